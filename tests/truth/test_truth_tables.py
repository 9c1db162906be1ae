"""The tables of truth beside a rendered recording: what is read, and what is refused."""

from __future__ import annotations

from pathlib import Path

import pytest

from tracking.errors import FormatError
from tracking.truth import TRUE_PART_COLUMNS, read_true_parts, read_visibility

HEADER = ",".join(TRUE_PART_COLUMNS) + "\n"


def test_parts_are_sorted_by_frame_person_and_part(tmp_path: Path) -> None:
    path = tmp_path / "t.csv"
    rows = ("4,1,head,1,2,3,4,5", "0,2,hip_leg,0,0,1,1,6", "0,2,torso,0,0,1,1,7")
    path.write_text(HEADER + "\n".join(rows) + "\n", encoding="utf-8")
    true = read_true_parts(path)
    assert list(zip(true.frame, true.person, true.part, strict=True)) == [
        (0, 2, 1),
        (0, 2, 2),
        (4, 1, 0),
    ]
    assert true.seen.tolist() == [7, 6, 5]
    assert true.box[2].tolist() == [1, 2, 3, 4]


def test_what_is_seen_of_people_is_sorted_by_frame_and_person(tmp_path: Path) -> None:
    path = tmp_path / "v.csv"
    path.write_text("frame,id,visibility\n2,1,0.5\n0,9,1\n0,3,0\n", encoding="utf-8")
    seen = read_visibility(path)
    assert list(zip(seen.frame, seen.person, seen.share, strict=True)) == [
        (0, 3, 0.0),
        (0, 9, 1.0),
        (2, 1, 0.5),
    ]


def test_a_part_that_stands_there_twice_is_named_by_both_lines(tmp_path: Path) -> None:
    path = tmp_path / "t.csv"
    rows = ("4,1,head,0,0,1,1,5", "0,1,head,0,0,1,1,5", "0,1,torso,0,0,1,1,5", "0,1,head,9,0,1,1,5")
    path.write_text(HEADER + "\n".join(rows) + "\n", encoding="utf-8")
    with pytest.raises(FormatError, match="line 5: line 3 gives the same part") as told:
        read_true_parts(path)
    assert "\n" not in str(told.value)


def test_a_table_larger_than_any_is_not_read(tmp_path: Path, monkeypatch) -> None:
    path = tmp_path / "t.csv"
    path.write_text(HEADER + "0,1,head,0,0,1,1,5\n" * 60, encoding="utf-8")
    monkeypatch.setattr("tracking.truth.table.MOST_BYTES", 1000)
    with pytest.raises(FormatError, match="give a shorter recording"):
        read_true_parts(path)


@pytest.mark.parametrize(
    ("line", "why"),
    [
        ("0,1,arm,0,0,1,1,5", "line 3"),
        ("0,1,head,0,0,1,1", "line 3"),
        ("0,1,head,nan,0,1,1,5", "line 3"),
        ("-1,1,head,0,0,1,1,5", "line 3"),
        ("0,0,head,0,0,1,1,5", "line 3"),
        ("x,1,head,0,0,1,1,5", "line 3"),
        ("0,1,head,0,0,-1,1,5", "line 3"),
        (f"0,1,head,0,0,1,1,{10**30}", "line 3"),
    ],
)
def test_a_line_that_is_no_part_is_named(tmp_path: Path, line: str, why: str) -> None:
    path = tmp_path / "t.csv"
    path.write_text(HEADER + "0,1,head,0,0,1,1,5\n" + line + "\n", encoding="utf-8")
    with pytest.raises(FormatError, match=why):
        read_true_parts(path)


def test_a_table_of_something_else_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "t.csv"
    path.write_text("frame,id,visibility\n", encoding="utf-8")
    with pytest.raises(FormatError, match="line 1"):
        read_true_parts(path)
    with pytest.raises(FormatError, match="cannot read"):
        read_true_parts(tmp_path / "missing.csv")
