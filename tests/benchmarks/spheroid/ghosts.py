"""Tracks where nobody is: after people left, where a recording begins, in a change of light."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.benchmarks.rendered_clips import Clip, Columns, folder_of, tracked
from tests.benchmarks.spheroid.people_kept import table_of
from tests.benchmarks.spheroid.recordings import RADIUS_M, told
from tests.benchmarks.spheroid.spots import TRACKER
from tracking.formats import read_mot
from tracking.scoring import FloorMatch, ScoringTable, score

NEAR_M = 1.0
LONGEST_S = 5.0
"""No ghost may last longer (the goal)."""


def robustness(clips: Sequence[Clip], kept: Path | None = None) -> list[dict[str, Any]]:
    """Scores and ghosts of clips in which something is out of the ordinary."""
    return [_row(clip, folder_of(clip, kept)) for clip in clips]


def _row(clip: Clip, folder: Path) -> dict[str, Any]:
    columns = read_mot(folder / "truth.txt")
    found = tracked(folder, TRACKER)
    tracks = found.run.tracks
    truth = ScoringTable.from_columns(columns, dont_cares=True)
    result = score(truth, table_of(tracks), FloorMatch(RADIUS_M))
    alone_s = ghosts_s(columns, tracks, clip.fps)
    return {
        **told(clip.name, TRACKER, result),
        "ghosts": int((alone_s > LONGEST_S).sum()),
        "longest_s": float(alone_s.max(initial=0.0)),
        "notes": list(found.notes),
    }


def ghosts_s(truth: Mapping[str, NDArray[Any]], tracks: Columns, fps: float) -> NDArray[np.float64]:
    """How long each track is without anybody near, at a stretch, in seconds.

    Args:
        truth: of everybody of whom anything is seen.
        tracks: a run's.
        fps: frames a second.
    """
    alone = np.array([_nobody_near(truth, *row) for row in _rows(tracks)], bool)
    longest = []
    for track in np.unique(tracks["track"]):
        own = tracks["track"] == track
        longest.append(_longest_run(tracks["frame"][own], alone[own]))
    return np.array(longest, float) / fps


def _rows(tracks: Columns) -> list[tuple[int, float, float]]:
    names = ("frame", "x", "y")
    return list(zip(*(tracks[name].tolist() for name in names), strict=True))


def _nobody_near(truth: Mapping[str, NDArray[Any]], frame: int, x: float, y: float) -> bool:
    start, end = np.searchsorted(truth["frame"], (frame, frame + 1))
    away = np.hypot(truth["x"][start:end] - x, truth["y"][start:end] - y)
    return not (away < NEAR_M).any()


def _longest_run(frames: NDArray[Any], alone: NDArray[np.bool_]) -> int:
    """Frames of the longest stretch that is alone throughout."""
    longest = current = 0
    last = None
    for frame, lonely in zip(frames.tolist(), alone.tolist(), strict=True):
        goes_on = lonely and last is not None and frame == last + 1
        current = current + 1 if goes_on else int(lonely)
        longest, last = max(longest, current), frame
    return longest
