"""Runs of the flow tracker made of people who walk straight, with exact tracklets."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from tests.trackers.flow.flow_scenes import FPS, view_of
from tracking.tracks.columns import (
    DETECTION_COLUMNS,
    PARTICLE_COLUMNS,
    TRACK_COLUMNS,
    TRACKLET_COLUMNS,
    Columns,
    box_columns,
    empty,
    typed,
)
from tracking.tracks.run import Particles, Run

VIEW = view_of(2.2, 20.0)
FRAMES = 80
_POINTS = np.array(
    [(aside, height) for height in (0.4, 0.8, 1.1, 1.4, 1.6) for aside in (-0.1, 0.1)]
)
"""Of a body: m beside its middle, m over the floor."""
_STRIDE_M = 0.35

Pair = tuple[float, float]


@dataclass(frozen=True, slots=True, eq=False)
class Walker:
    """Somebody who walks straight.

    Attributes:
        start: m in frame 0. pace: m/s. frames: in which their points are followed.
        points: (n, 2) of the body, m beside its middle, m over the floor.
        stride_m: how much nearer than the body the foot in front is.
    """

    start: Pair
    pace: Pair
    frames: range = range(FRAMES)
    points: NDArray[np.float64] = field(default_factory=_POINTS.copy)
    stride_m: float = _STRIDE_M

    def at(self, frame: NDArray[np.int64] | int) -> NDArray[np.float64]:
        """(..., 2) m."""
        way = np.asarray(frame, np.float64)[..., None] / FPS * np.array(self.pace)
        return np.asarray(np.array(self.start) + way)


def run_with(
    walkers: Sequence[Walker],
    tracks: Sequence[tuple[int, int, range]],
    known_tracks: int = 0,
    *,
    feet: bool = False,
) -> Run:
    """A run in which tracks followed walkers.

    Args:
        tracks: track, number of the walker followed, and in which frames.
        feet: whether everybody's foot in front is seen.
    """
    table = _tracks(walkers, tracks)
    start, tracklets = _tracklets(walkers, tracks, feet)
    values = {name: table.get(name, np.ones(len(table["x"]))) for name in DETECTION_COLUMNS}
    return Run(
        tracker="flow",
        settings={"persistent_points": True, "smooth": True, "extrapolate_s": 0.0},
        seed=0,
        frames=(0, FRAMES),
        tracks=table,
        detections=typed(values, DETECTION_COLUMNS),
        particles=Particles(np.zeros(FRAMES + 1, np.int64), empty(PARTICLE_COLUMNS)),
        tracklets=Particles(start, tracklets),
        known_tracks=known_tracks,
    )


def _tracks(walkers: Sequence[Walker], tracks: Sequence[tuple[int, int, range]]) -> Columns:
    frame = np.concatenate([np.array(frames) for _, _, frames in tracks])
    track = np.concatenate([np.full(len(frames), name) for name, _, frames in tracks])
    place = np.concatenate([walkers[who].at(np.array(frames)) for _, who, frames in tracks])
    order = np.lexsort((track, frame))
    values = {
        "frame": frame,
        "track": track,
        **box_columns(VIEW.box_of_person(place, 1.7, 0.55)),
        "x": place[:, 0],
        "y": place[:, 1],
        **dict.fromkeys(("vx", "vy"), np.zeros(len(frame))),
        **dict.fromkeys(("confidence", "visibility"), np.ones(len(frame))),
        "predicted": np.zeros(len(frame), bool),
    }
    return {name: column[order] for name, column in typed(values, TRACK_COLUMNS).items()}


def _tracklets(
    walkers: Sequence[Walker], tracks: Sequence[tuple[int, int, range]], feet: bool
) -> tuple[NDArray[np.int64], Columns]:
    """Each point in each frame from its third on, with where it was in the two before."""
    count, rows = np.zeros(FRAMES + 1, np.int64), []
    for frame in range(FRAMES):
        for who, walker in enumerate(walkers):
            if frame not in walker.frames or frame - 2 not in walker.frames:
                continue
            holder = [name for name, held, frames in tracks if held == who and frame in frames]
            seen = [_pixels(walker, frame - back) for back in range(3)]
            points = len(walker.points)
            foot_v = np.full(points, _foot_line(walker, frame) if feet else np.nan)
            rows.append(np.column_stack((np.full(points, sum(holder[:1])), *seen, foot_v)))
            count[frame + 1] += points
    table = np.concatenate(rows) if rows else np.zeros((0, 8))
    names = ("track", "u0", "v0", "u1", "v1", "u2", "v2", "foot_v")
    return np.cumsum(count), typed(dict(zip(names, table.T, strict=True)), TRACKLET_COLUMNS)


def _pixels(walker: Walker, frame: int) -> NDArray[np.float64]:
    x, y = walker.at(frame)
    aside, height = walker.points.T
    points = np.column_stack((x + aside, np.full(len(aside), y), height))
    return VIEW.pixel_from_world(points)


def _foot_line(walker: Walker, frame: int) -> float:
    x, y = walker.at(frame)
    nearer = 1.0 - walker.stride_m / np.hypot(x, y)
    return float(VIEW.pixel_from_world(np.array([[x * nearer, y * nearer, 0.0]]))[0, 1])
