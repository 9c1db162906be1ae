"""`review` lists where a session's tracks are likely wrong."""

from __future__ import annotations

import json
from contextlib import closing
from pathlib import Path

from command_line import Trackwright

from tracking.editing import plan_mark_reviewed, plan_swap
from tracking.session import Session


def swapped(session: Path) -> int:
    """Swap two people who stand in one frame; gives the frame."""
    with closing(Session.open(session)) as opened:
        table = opened.tracks
        one, other, frame = next(
            (a, b, frame)
            for a in table.track_ids
            for b in table.track_ids
            if a < b
            for start, end in [
                (
                    max(table.frame_range(a)[0], table.frame_range(b)[0]),
                    min(table.frame_range(a)[1], table.frame_range(b)[1]),
                )
            ]
            if end - start > 30
            for frame in [(start + end) // 2]
        )
        opened.apply(plan_swap(table, one, other, frame))
        opened.save()
    return frame


def test_a_swap_is_found(trackwright: Trackwright, session: Path) -> None:
    frame = swapped(session)
    status, printed, _ = trackwright("review", session, "--json")
    told = json.loads(printed)
    assert status == 0
    assert told["found"] == told["open"] == len(told["review_items"])
    assert any(
        one["start"] <= frame < one["end"] and one["likelihood"] > 0.05
        for one in told["review_items"]
    )
    first = told["review_items"][0]
    assert {"kind", "tracks", "frame", "time_s", "likelihood", "cost", "text", "fix"} <= set(first)


def test_lines_are_as_many_as_asked_for(trackwright: Trackwright, session: Path) -> None:
    swapped(session)
    status, printed, _ = trackwright("review", session, "--order", "time", "--most", "1")
    assert status == 0
    heading, *review_items, blank, decided, left, counted = printed.splitlines()
    assert (blank, decided.split()[0]) == ("", "Decided:")
    assert left.startswith("About ")
    assert "Missed people" in counted
    assert heading.split() == [
        "frame",
        "sure",
        "rows",
        "what",
        "may",
        "be",
        "wrong",
        "(what",
        "would",
        "correct",
        "it)",
    ]
    assert len(review_items) == 1


def test_reviewed_footage_is_listed_no_more(trackwright: Trackwright, session: Path) -> None:
    with closing(Session.open(session)) as opened:
        end = opened.recording.frame_count
        opened.apply(plan_mark_reviewed(opened.labels, 0, 0, end))
        opened.save()
    told = json.loads(trackwright("review", session, "--json")[1])
    assert told["open"] == 0
    assert told["found"] > 0
    assert (told["decided"], told["boxes_reviewed"]) == (told["found"], 1.0)
    assert told["errors_left"] == {"expected": 0.0, "low": 0, "high": 0}
    printed = trackwright("review", session)[1]
    said = f"Nothing is left to look at: all {told['found']} review items are decided or reviewed."
    lines = printed.splitlines()
    assert lines[0] == said
    assert lines[3] == "About 0 identity errors left (likely 0 to 0)."


def test_what_is_no_session_is_told(trackwright: Trackwright, tmp_path: Path) -> None:
    status, printed, said = trackwright("review", tmp_path / "none.h5")
    assert (status, printed) == (1, "")
    assert "there is no such session" in said


def test_imported_ground_truth_is_quiet_unless_asked(
    trackwright: Trackwright, session: Path, tiny_recording: Path, tmp_path: Path
) -> None:
    swapped(session)
    truth, imported = tmp_path / "truth.txt", tmp_path / "truth.h5"
    assert trackwright("export", session, "-o", truth, "--format", "mot")[0] == 0
    rows = [line.split(",") for line in truth.read_text("utf-8").splitlines()]
    sure = [",".join((*row[:6], "1", *row[7:])) for row in rows]
    truth.write_text("\n".join(sure), encoding="utf-8")
    assert trackwright("import", "-r", tiny_recording, truth, "-o", imported)[0] == 0
    status, printed, _ = trackwright("review", imported)
    assert status == 0
    assert "--hand-made" in printed
    told = json.loads(trackwright("review", imported, "--json")[1])
    assert (told["searched"], told["found"]) == (False, 0)
    asked = json.loads(trackwright("review", imported, "--hand-made", "--json")[1])
    assert asked["searched"]
    assert asked["found"] > 0
