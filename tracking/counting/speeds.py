"""How fast people walk, from where they were."""

from __future__ import annotations

import math

import numpy as np

from tracking.counting.paths import Floats, Integers, Paths

WINDOW_S = 0.5
"""How long a stretch of a path a speed is taken from, half of it before and half after."""


def half_window(fps: float, window_s: float = WINDOW_S) -> int:
    """Half the window in frames, at least one."""
    return max(1, math.floor(window_s * fps / 2 + 0.5))


def speeds(paths: Paths, fps: float, frame_step: int | None = None) -> Floats:
    """(n,) the length of `velocities`."""
    velocity = velocities(paths, fps, frame_step)
    speed: Floats = np.hypot(velocity[:, 0], velocity[:, 1])
    return speed


def velocities(paths: Paths, fps: float, frame_step: int | None = None) -> Floats:
    """(n, 2) how fast and where to at each place: metres a second of paths on the floor.

    The way between the places frame_step frames before and after, over the time between them. At
    the ends of a track, where one of the two is missing, the place itself stands for it; where
    both are, the track's first and last do. In gaps a track goes straight. NaN for a track of
    one place. On tracks without gaps that are longer than frame_step their length is the speed of
    PedPy's `compute_individual_speed` with `BORDER_SINGLE_SIDED`.

    Args:
        frame_step: None: half of `WINDOW_S`.
    """
    step = half_window(fps) if frame_step is None else frame_step
    if not len(paths):
        return np.zeros((0, 2))
    first, last = _ends(paths)
    earlier, later = paths.frame - step, paths.frame + step
    no_past, no_future = earlier < first, later > last
    neither = no_past & no_future
    earlier = np.where(no_past, np.where(neither, first, paths.frame), earlier)
    later = np.where(no_future, np.where(neither, last, paths.frame), later)
    way = _at(paths, later) - _at(paths, earlier)
    took_s = (later - earlier) / fps
    with np.errstate(invalid="ignore", divide="ignore"):
        velocity: Floats = np.where(took_s > 0, way.T / took_s, np.nan).T
    return velocity


def _ends(paths: Paths) -> tuple[Integers, Integers]:
    """(n,) the first and the last frame of each row's track."""
    first_row = paths.first_row
    begins = np.flatnonzero(first_row == np.arange(len(paths)))
    ends = np.append(begins[1:], len(paths)) - 1
    of_row = np.searchsorted(begins, first_row)
    return paths.frame[first_row], paths.frame[ends[of_row]]


def _at(paths: Paths, frame: Integers) -> Floats:
    """(n, 2) where each row's track is in another frame within its first and last."""
    rank = np.cumsum(~paths.goes_on)
    stride = int(paths.frame.max()) + 1
    known, asked = rank * stride + paths.frame, rank * stride + frame
    after = np.clip(np.searchsorted(known, asked), 1, max(len(known) - 1, 1))
    after = np.minimum(after, len(known) - 1)
    before = np.maximum(after - 1, 0)
    apart = np.maximum(known[after] - known[before], 1)
    share = np.clip((asked - known[before]) / apart, 0.0, 1.0)[:, None]
    place: Floats = paths.place[before] * (1 - share) + paths.place[after] * share
    return place
