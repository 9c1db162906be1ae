"""Body parts in real footage, judged by the boxes of whole people.

Nobody has drawn the parts there. A part is taken for right while less than half of its rectangle
lies outside of the zone of the person's box in which that part of a walking person is: head in the
upper quarter, torso from a tenth to six tenths down, hip-leg from four tenths down. Coarser than
exact truth, and told as such.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.benchmarks.command import tell
from tests.benchmarks.parts.cases import ADJUSTED, rectangles
from tests.benchmarks.runner import run_of
from tracking.formats import read_mot
from tracking.recording import open_recording
from tracking.scoring.parts import Judged, PartTruth, judge

RECORDINGS = ("pets-s2l1-real", "tud-campus-real")
FRAMES = 100
_ZONES = ((0.0, 0.25), (0.1, 0.6), (0.4, 1.0))


def folders_in(data: Path) -> list[Path]:
    """The real recordings that are there; those missing are told."""
    there = [data / name for name in RECORDINGS if (data / name / "truth.txt").is_file()]
    for name in sorted(set(RECORDINGS) - {folder.name for folder in there}):
        tell(f"no real footage {name} in {data} (--data or TRACKWRIGHT_DATA): it is left out")
    return there


def measure(data: Path) -> dict[str, Any]:
    """Who keeps their parts in the real recordings that are there."""
    return {folder.name: kept_parts(judged_recording(folder)) for folder in folders_in(data)}


def judged_recording(folder: Path) -> list[Judged]:
    """Everybody in a recording with true boxes."""
    with open_recording(folder) as recording:
        size, fps = recording.size, recording.fps
    truth = truth_of_boxes(read_mot(folder / "truth.txt"), size)
    return judge(truth, rectangles(run_of(folder, ADJUSTED).run, ADJUSTED), fps)


def truth_of_boxes(columns: Mapping[str, NDArray[Any]], size_px: tuple[int, int]) -> PartTruth:
    """Zones of people's boxes in place of parts that nobody has drawn."""
    order = np.lexsort((columns["track"], columns["frame"]))
    left, top, width, height = (columns[name][order] for name in ("left", "top", "width", "height"))
    zones = [
        np.column_stack((left, top + high * height, left + width, top + low * height))
        for high, low in _ZONES
    ]
    frame, person = (columns[name][order].astype(np.int64) for name in ("frame", "track"))
    return PartTruth(frame, person, np.stack(zones, axis=1), np.ones(len(frame)), size_px)


def kept_parts(judged: Sequence[Judged], frames: int = FRAMES) -> dict[str, Any]:
    """How many people have all parts right after so many frames, or at the end of a shorter view.

    "throughout": in at least nine of ten frames until then.
    """
    after = [min(frames, len(one.parts) - 1) for one in judged]
    good = [one.parts[: last + 1].all(axis=1) for one, last in zip(judged, after, strict=True)]
    return {
        "people": len(judged),
        "tracked": sum(one.track > 0 for one in judged),
        "in_view": sum(len(one.parts) > frames for one in judged),
        "at_end": sum(bool(right[-1]) for right in good),
        "throughout": sum(bool(right.mean() >= 0.9) for right in good),
        "parts": [
            sum(bool(one.parts[last, part]) for one, last in zip(judged, after, strict=True))
            for part in range(len(_ZONES))
        ],
        "person": sum(
            bool(one.person_right[last]) for one, last in zip(judged, after, strict=True)
        ),
    }
