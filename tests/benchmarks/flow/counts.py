"""People counted by a tracker beside those who passed ([Yoneji2013] table 2)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.benchmarks.clips import Clip, floor_truth, folder_of
from tests.benchmarks.runner import Case, run_of
from tracking.counting import (
    PAPER_STEP_S,
    Hits,
    compare_passages,
    occupancy,
    passages,
)
from tracking.formats import read_mot
from tracking.recording import open_recording
from tracking.synthesis import SCENES
from tracking.tracks import CountingLine, Region

OURS = Case("flow")
STRETCH_S = 20.0
"""Sums are told for stretches of a recording, too."""
_SEEN = 0.1
"""Share of a person that a camera needs to count it."""
_JITTER_M = 0.2
"""Who sways over a line has not passed."""
_NEAR_M, _FAR_M = 5.0, 9.0
_LINES_M = (5.5, 7.0, 8.5)

Table = Mapping[str, NDArray[Any]]


def where_counted(scene: str) -> tuple[tuple[CountingLine, ...], Region]:
    """Lines across a scene's passage, forward away from the camera, and the region of the sums."""
    passage = SCENES[scene].passage
    assert passage is not None
    half = passage.half_width_m
    corners = ((-half, _NEAR_M), (half, _NEAR_M), (half, _FAR_M), (-half, _FAR_M))
    lines = tuple(CountingLine(f"{y:g} m", (half, y), (-half, y)) for y in _LINES_M)
    return lines, Region("passage", corners)


def count_scenes(clips: Sequence[Clip]) -> list[dict[str, Any]]:
    """Sums and hits of each scene."""
    return [_count_scene(clip, folder_of(clip)) for clip in clips]


def _count_scene(clip: Clip, folder: Path) -> dict[str, Any]:
    lines, region = where_counted(clip.scene)
    seen_sum = int(people_inside(_seen(folder), *_length(folder), region).sum())
    counts = _counts(folder, floor_truth(folder), lines, region)
    return {"scene": clip.scene, "seed": clip.seed, **counts, "seen_sum": seen_sum}


def _seen(folder: Path) -> Table:
    """The true rows of those of whom enough is seen to be counted by eye."""
    shares = np.loadtxt(folder / "visibility.csv", delimiter=",", skiprows=1, ndmin=2)[:, 2]
    truth = read_mot(folder / "truth.txt")
    return {name: column[shares >= _SEEN] for name, column in truth.items()}


def _length(folder: Path) -> tuple[float, int]:
    """Frames a second, and how many."""
    with open_recording(folder) as recording:
        return recording.fps, recording.frame_count


def _counts(
    folder: Path, truth: Table, lines: Sequence[CountingLine], region: Region
) -> dict[str, Any]:
    """The tracker's counts in one recording beside the true ones."""
    tracks, (fps, frames) = run_of(folder, OURS).tracks, _length(folder)
    true, ours = (people_inside(table, fps, frames, region) for table in (truth, tracks))
    hits = hits_of(tracks, truth, fps, lines)
    steps = round(STRETCH_S / PAPER_STEP_S)
    return {
        "tracker": OURS.tracker,
        "true_sum": int(true.sum()),
        "sum": int(ours.sum()),
        "most": int(true.max(initial=0)),
        "mean_difference": float(np.abs(true - ours).mean()),
        "stretches": [
            (int(true[start : start + steps].sum()), int(ours[start : start + steps].sum()))
            for start in range(0, len(true), steps)
        ],
        "true_steps": true.tolist(),
        "steps": ours.tolist(),
        "happened": hits.happened,
        "found": hits.found,
        "hit": hits.hit,
        "by_line": {line.name: hits_of(tracks, truth, fps, [line]).rate for line in lines},
    }


def people_inside(table: Table, fps: float, frames: int, region: Region) -> NDArray[np.int64]:
    """How many people are inside in steps of half a second."""
    found = occupancy(table, fps, [region], frames, step_s=PAPER_STEP_S)[0]
    return np.asarray(found.people, np.int64)


def hits_of(tracks: Table, truth: Table, fps: float, lines: Sequence[CountingLine]) -> Hits:
    """Passages found over all lines."""
    found, happened = (passages(table, fps, lines, jitter_m=_JITTER_M) for table in (tracks, truth))
    return compare_passages(found, happened)
