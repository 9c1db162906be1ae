"""Our trackers beside those of others on the same detections, as a section of the page."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

from tests.benchmarks.clips import folder_of
from tests.benchmarks.pages import Figures
from tests.benchmarks.stereo.clips import OURS, OfScene
from tests.benchmarks.tracker_peers.comparison import compared, compared_on
from tests.benchmarks.tracker_peers.detections import rendered_clip

SHOWN = (OURS.tracker, "stereo-direction")
SCENES_SHOWN = ("lobby", "plaza", "square")


def measure(clips: OfScene, seeds: Sequence[int], kept: Path | None = None) -> dict[str, Any]:
    """Everybody over crossing walkers of these seeds, and over one clip each of some scenes."""
    chosen = [clips[scene][0] for scene in SCENES_SHOWN]
    seen = [rendered_clip(folder_of(clip, kept)) for clip in chosen]
    return {
        "crossing": [asdict(row) for row in compared(seeds, SHOWN)],
        "rendered": [asdict(row) for row in compared_on(seen, "rendered", SHOWN)],
        "clips": [clip.name for clip in chosen],
    }


def verdicts(rows: Sequence[Figures]) -> str:
    """No more switches than the best of the others without colours, at most half with them."""
    others = [row for row in rows if not row["ours"] and row["figures"] is not None]
    if not others:
        return (
            "None of the others could be measured (`make peers` installs them), so there is "
            "nothing to compare with."
        )
    best = min(others, key=_switches)
    fewest = _switches(best)
    said = [
        f"Fewest switches of the others: {best['tracker']}, {fewest}.",
        _verdict(rows, colour=False, goal="without colours, no more", most=fewest),
        _verdict(rows, colour=True, goal="with colours, at most half", most=fewest // 2)
        if fewest
        else "Half of none is none, so that with colours no more is asked.",
        _harm_of_colours(rows),
    ]
    return " ".join(part for part in said if part)


def _verdict(rows: Sequence[Figures], *, colour: bool, goal: str, most: int) -> str:
    switches = _ours(rows, colour, finished=True)
    verdict = "met" if switches is not None and switches <= most else "missed"
    return f"Goal {goal}: {OURS.tracker} {switches} finished ({verdict})."


def _harm_of_colours(rows: Sequence[Figures]) -> str:
    """What is said where our tracker does worse with colours than without, as frames come."""
    without, with_them = (_ours(rows, colour, finished=False) for colour in (False, True))
    if without is None or with_them is None or with_them <= without:
        return ""
    said = (
        f"As they come, colours cost {OURS.tracker} {with_them - without} switches here "
        f"({with_them}, without colours {without})"
    )
    bare, coloured = (_ours(rows, colour, finished=True) for colour in (False, True))
    back = bare is not None and coloured is not None and coloured <= bare
    return f"{said}{'; finishing takes them back' if back else ''}."


def _ours(rows: Sequence[Figures], colour: bool, *, finished: bool) -> int | None:
    """Our tracker's switches; None where they were not measured."""
    asked = (OURS.tracker, colour, finished)
    own = (row for row in rows if (row["tracker"], row["colour"], row["finished"]) == asked)
    return next(map(_switches, own), None)


def _switches(row: Figures) -> int:
    return int(row["figures"]["id_switches"])
