"""How fast people walk, from where they were."""

from __future__ import annotations

import math

import numpy as np

from tracking.arrays import Floats, Integers
from tracking.counting.paths import Paths

WINDOW_S = 0.5
"""How long a stretch of a path a speed is taken from, half of it before and half after."""


def half_window(fps: float, window_s: float = WINDOW_S) -> int:
    """Half the window in frames, at least one."""
    return max(1, math.floor(window_s * fps / 2 + 0.5))


def velocities(paths: Paths, fps: float, frame_step: int | None = None) -> Floats:
    """(n, 2) how fast and where to at each place: metres a second of paths on the floor.

    See `Velocities`.
    """
    return Velocities(paths, fps, frame_step).at(np.arange(len(paths)))


def lengths(vectors: Floats) -> Floats:
    """(n,) of vectors (n, 2)."""
    length: Floats = np.hypot(vectors[:, 0], vectors[:, 1])
    return length


class Velocities:
    """How fast and where to people walk, worked out at the rows that are asked for.

    The way between the places frame_step frames before and after, over the time between them. At
    the ends of a track, where one of the two is missing, the place itself stands for it; where
    both are, the track's first and last do. In gaps a track goes straight. NaN for a track of
    one place. On tracks without gaps that are longer than frame_step their length is the speed of
    PedPy's `compute_individual_speed` with `BORDER_SINGLE_SIDED`.

    Args:
        frame_step: None: half of `WINDOW_S`.
    """

    def __init__(self, paths: Paths, fps: float, frame_step: int | None = None) -> None:
        self._paths, self._fps = paths, fps
        self._step = half_window(fps) if frame_step is None else frame_step
        begins = np.flatnonzero(~paths.goes_on)
        ends = np.append(begins[1:], len(paths)) - 1
        self._rank = np.cumsum(~paths.goes_on) - 1
        self._first, self._last = paths.frame[begins], paths.frame[ends[: len(begins)]]
        self._stride = int(paths.frame.max(initial=0)) + 1
        self._known = self._rank * self._stride + paths.frame
        """Grows from row to row: the track's rank, then the frame."""

    def at(self, rows: Integers) -> Floats:
        """(k, 2) m/s at some rows of the paths."""
        frame, rank = self._paths.frame[rows], self._rank[rows]
        earlier, later = frame - self._step, frame + self._step
        no_past, no_future = earlier < self._first[rank], later > self._last[rank]
        neither = no_past & no_future
        earlier = np.where(no_past, np.where(neither, self._first[rank], frame), earlier)
        later = np.where(no_future, np.where(neither, self._last[rank], frame), later)
        way = self._places(rows, later) - self._places(rows, earlier)
        took_s = (later - earlier) / self._fps
        with np.errstate(invalid="ignore", divide="ignore"):
            velocity: Floats = np.where(took_s > 0, way.T / took_s, np.nan).T
        return velocity

    def _places(self, rows: Integers, frame: Integers) -> Floats:
        """(k, 2) where the tracks of rows are in other frames within their first and last."""
        asked = self._rank[rows] * self._stride + frame
        guess = np.clip(rows + frame - self._paths.frame[rows], 0, len(self._known) - 1)
        place: Floats = self._paths.place[guess]
        in_gap = np.flatnonzero(self._known[guess] != asked)
        if len(in_gap):
            place[in_gap] = self._between(asked[in_gap])
        return place

    def _between(self, asked: Integers) -> Floats:
        """(k, 2) places that are searched for, straight between the rows around them."""
        after = np.searchsorted(self._known, asked)
        before = np.maximum(after - 1, 0)
        apart = np.maximum(self._known[after] - self._known[before], 1)
        share = np.clip((asked - self._known[before]) / apart, 0.0, 1.0)[:, None]
        place: Floats = self._paths.place[before] * (1 - share) + self._paths.place[after] * share
        return place
