"""People counted by a tracker beside those who passed ([Yoneji2013] table 2)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.benchmarks.flow.clips import Counted
from tests.benchmarks.rendered_clips import floor_truth, folder_of, run_of
from tracking.counting import PAPER_STEP_S, Hits, compare_passages, occupancy, passages
from tracking.formats import read_mot
from tracking.recording import open_recording
from tracking.tracks import CountingLine, Region

TRACKERS = ("flow",)
STRETCH_S = 20.0
"""Sums are told for stretches of a recording, too."""

SEEN = 0.1
"""Share of a person that a camera needs to count it."""

JITTER_M = 0.2
"""Who sways over a line has not passed."""

Table = Mapping[str, NDArray[Any]]


def scenes(counted: Sequence[Counted], kept: Path | None = None) -> list[dict[str, Any]]:
    """Sums and hits of each scene, by tracker."""
    rows = []
    for one in counted:
        folder = folder_of(one.clip, kept)
        for tracker in TRACKERS:
            found = counts_of(folder, tracker, floor_truth(folder), one.lines, one.region)
            found["seen_sum"] = _seen_sum(folder, one)
            rows.append({"scene": one.clip.scene, "seed": one.clip.seed, **found})
    return rows


def _seen_sum(folder: Path, one: Counted) -> int:
    """The true sum of those of whom enough is seen to be counted by eye."""
    truth = read_mot(folder / "truth.txt")
    shares = np.loadtxt(folder / "visibility.csv", delimiter=",", skiprows=1, ndmin=2)[:, 2]
    seen = {name: column[shares >= SEEN] for name, column in truth.items()}
    with open_recording(folder) as recording:
        fps, frames = recording.fps, recording.frame_count
    return int(people_inside(seen, fps, frames, one.region).sum())


def counts_of(
    folder: Path,
    tracker: str,
    truth: Table,
    lines: Sequence[CountingLine],
    region: Region,
) -> dict[str, Any]:
    """The tracker's counts in one recording beside the true ones."""
    tracks = run_of(folder, tracker).tracks
    with open_recording(folder) as recording:
        fps, frames = recording.fps, recording.frame_count
    true, ours = (people_inside(table, fps, frames, region) for table in (truth, tracks))
    hits = hits_of(tracks, truth, fps, lines)
    return {
        "tracker": tracker,
        "true_sum": int(true.sum()),
        "sum": int(ours.sum()),
        "most": int(true.max(initial=0)),
        "mean_difference": float(np.abs(true - ours).mean()),
        "stretches": _stretches(true, ours),
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
    found, happened = (passages(table, fps, lines, jitter_m=JITTER_M) for table in (tracks, truth))
    return compare_passages(found, happened)


def _stretches(true: NDArray[np.int64], ours: NDArray[np.int64]) -> list[tuple[int, int]]:
    """True and counted sums of each stretch."""
    steps = round(STRETCH_S / PAPER_STEP_S)
    return [
        (int(true[start : start + steps].sum()), int(ours[start : start + steps].sum()))
        for start in range(0, len(true), steps)
    ]
