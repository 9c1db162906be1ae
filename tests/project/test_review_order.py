"""Which recording is reviewed next."""

from __future__ import annotations

from pathlib import Path

from tracking.project import (
    ProjectRow,
    ScannedFile,
    SessionFacts,
    SessionRow,
    next_to_review,
    worth_of,
)


def _row(
    name: str, errors: float, minutes: float, *, holder: str = "", hand_made: bool = False
) -> ProjectRow:
    facts = SessionFacts(
        items_left=round(2 * errors),
        errors_left=9 * errors,
        errors_at_items=errors,
        minutes_left=minutes,
        hand_made=hand_made,
    )
    file = ScannedFile(Path(f"{name}.h5"), "")
    return ProjectRow(name, None, None, (SessionRow(file, facts, holder=holder),))


def test_most_errors_for_each_minute_come_first() -> None:
    rows = [_row("long", 100, 60), _row("dense", 40, 9.5), _row("tiny", 0.9, 0.05)]
    assert [round(worth_of(row) or 0, 2) for row in rows] == [1.65, 4.0, 1.64]
    best = next_to_review(rows)
    assert best is not None
    assert best.name == "dense"


def test_what_others_have_open_is_left_to_them() -> None:
    rows = [_row("theirs", 40, 1, holder="process 5 on lab"), _row("free", 10, 1)]
    best = next_to_review(rows)
    assert best is not None
    assert best.name == "free"
    assert next_to_review(rows, leave_out="free") is None


def test_nothing_is_left_where_all_is_decided_or_made_by_hand() -> None:
    rows = [_row("decided", 0, 0), _row("drawn", 10, 1, hand_made=True)]
    rows.append(ProjectRow("untracked", ScannedFile(Path("a"), ""), None))
    assert [worth_of(row) for row in rows] == [None, None, None]
    assert next_to_review(rows) is None
