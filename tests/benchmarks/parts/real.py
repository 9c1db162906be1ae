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

from tests.benchmarks.parts.judging import Judged, judge
from tests.benchmarks.parts.running import ADJUSTED, Variant, run_of, tracked_by
from tests.benchmarks.parts.truth import PARTS, Truth
from tracking.formats import read_mot
from tracking.recording import open_recording

RECORDINGS = ("pets-s2l1-real", "tud-campus-real")
FRAMES = 100
_ZONES = ((0.0, 0.25), (0.1, 0.6), (0.4, 1.0))


def measure(data: Path, variant: Variant = ADJUSTED) -> dict[str, Any]:
    """Who keeps their parts in the real recordings that are there."""
    folders = [data / name for name in RECORDINGS if (data / name / "truth.txt").is_file()]
    return {folder.name: kept_parts(judged_recording(folder, variant)) for folder in folders}


def judged_recording(folder: Path, variant: Variant) -> list[Judged]:
    """Everybody in a recording with true boxes."""
    run = run_of(folder, variant)
    with open_recording(folder) as recording:
        size, fps, frames = recording.size, recording.fps, recording.frame_count
    truth = truth_of_boxes(read_mot(folder / "truth.txt"), frames, size)
    return judge(truth, tracked_by(run, variant), fps)


def truth_of_boxes(
    columns: Mapping[str, NDArray[Any]], frames: int, size_px: tuple[int, int]
) -> Truth:
    """Zones of people's boxes in place of parts that nobody has drawn."""
    ids = np.unique(columns["track"])
    place = columns["frame"], np.searchsorted(ids, columns["track"])
    parts = np.full((frames, len(ids), len(PARTS), 4), np.nan)
    left, width = columns["left"], columns["width"]
    for part, (high, low) in enumerate(_ZONES):
        top = columns["top"] + high * columns["height"]
        bottom = columns["top"] + low * columns["height"]
        parts[(*place, part)] = np.column_stack((left, top, left + width, bottom))
    seen = np.isfinite(parts[:, :, 0, 0]).astype(float)
    return Truth(ids.astype(np.int32), parts, seen, size_px)


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
            for part in range(len(PARTS))
        ],
        "person": sum(
            bool(one.person_right[last]) for one, last in zip(judged, after, strict=True)
        ),
    }
