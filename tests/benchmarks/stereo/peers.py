"""Our trackers beside those of others on the same detections, as a section of the page."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

from tests.benchmarks.pages import Figures, table
from tests.benchmarks.rendered_clips import Clip
from tests.benchmarks.stereo import words
from tests.benchmarks.stereo.clips import folder
from tests.benchmarks.stereo.columns import OURS
from tests.benchmarks.tracker_peers import compared, compared_on
from tests.benchmarks.tracker_peers.rendered_clips import rendered_clip
from tests.benchmarks.tracker_peers.rows import RADIUS_M

SHOWN = (OURS.tracker, "stereo-direction")
SCENES_SHOWN = ("lobby", "plaza", "square")


def measure(
    of_scene: Mapping[str, Sequence[Clip]], seeds: Sequence[int], kept: Path | None = None
) -> dict[str, Any]:
    """Everybody over crossing walkers of these seeds, and over one clip each of some scenes."""
    clips = [of_scene[scene][0] for scene in SCENES_SHOWN]
    seen = [rendered_clip(folder(clip, kept)) for clip in clips]
    return {
        "crossing": [asdict(row) for row in compared(seeds, SHOWN)],
        "rendered": [asdict(row) for row in compared_on(seen, "rendered", SHOWN)],
        "clips": [clip.name for clip in clips],
    }


def written(figures: Figures) -> str:
    """The section: a table and the goals for each kind of clip."""
    parts = [words.PEERS.format(radius=RADIUS_M).strip()]
    for kind, said in words.KINDS.items():
        rows = figures[kind]
        parts += [said.format(clips=", ".join(figures["clips"])), _table(rows), goals(rows)]
    return "\n\n".join(parts)


def _table(rows: Sequence[Figures]) -> str:
    head = ("tracker", "switches", "IDF1", "HOTA", "kept", "error, m", "ms a frame")
    return table(head, [[_named(row), *_cells(row)] for row in rows])


def _named(row: Figures) -> str:
    if not row["ours"]:
        return str(row["tracker"])
    colour = "with colours" if row["colour"] else "without colours"
    return f"{row['tracker']}, {colour}, {'finished' if row['finished'] else 'as they come'}"


def _cells(row: Figures) -> list[str]:
    told = row["figures"]
    if told is None:
        return [row["absent"], *[""] * 5]
    return [
        str(told["id_switches"]),
        f"{told['idf1']:.3f}",
        f"{told['hota']:.3f}",
        f"{told['kept']} of {told['people']}",
        f"{told['floor_error_m']:.3f}",
        f"{told['ms']:.2f}",
    ]


def goals(rows: Sequence[Figures]) -> str:
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
    ]
    if fewest:
        said.append(
            _verdict(rows, colour=True, goal="with colours, at most half", most=fewest // 2)
        )
    else:
        said.append("Half of none is none, so that with colours no more is asked.")
    return " ".join([*said, *_harm_of_colours(rows)])


def _verdict(rows: Sequence[Figures], *, colour: bool, goal: str, most: int) -> str:
    switches = _ours(rows, colour)
    verdict = "met" if switches is not None and switches <= most else "missed"
    return f"Goal {goal}: {OURS.tracker} {switches} finished ({verdict})."


def _harm_of_colours(rows: Sequence[Figures]) -> Iterator[str]:
    """What is said where our tracker does worse with colours than without, as frames come."""
    without, with_them = (_ours(rows, colour, finished=False) for colour in (False, True))
    if without is None or with_them is None or with_them <= without:
        return
    cost = with_them - without
    said = (
        f"As they come, colours cost {OURS.tracker} {cost} switches here ({with_them}, without "
        f"colours {without})"
    )
    finished = [_ours(rows, colour) for colour in (False, True)]
    back = finished[1] is not None and finished[0] is not None and finished[1] <= finished[0]
    yield f"{said}{'; finishing takes them back' if back else ''}."


def _ours(rows: Sequence[Figures], colour: bool, *, finished: bool = True) -> int | None:
    """Our tracker's switches; None where they were not measured."""
    own = (
        _switches(row)
        for row in rows
        if row["tracker"] == OURS.tracker
        and row["colour"] == colour
        and row["finished"] == finished
    )
    return next(own, None)


def _switches(row: Figures) -> int:
    return int(row["figures"]["id_switches"])
