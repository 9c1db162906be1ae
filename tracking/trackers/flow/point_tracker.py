"""Points of the picture followed from frame to frame: tracklets."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.trackers.flow.half_resolution import halve
from tracking.trackers.flow.settings import PointSettings

Grey = NDArray[np.uint8]
Mask = NDArray[np.uint8]
Paths = NDArray[np.float32]

_STEPS = 10
_FINE_PX = 0.03
"""Lucas-Kanade ends after so many steps, or one as small."""
_BORDER_PX = 3
_EIGEN_BLOCK = 3


@dataclass(frozen=True, slots=True, eq=False)
class Tracklets:
    """The points followed in a frame.

    Attributes:
        id: (n,) stays with a point while it is followed; ascending.
        path: (n, k, 2) px of the picture as recorded, newest first; NaN before it was found.
        age: (n,) steps it was followed for.
    """

    id: NDArray[np.int64]
    path: Paths
    age: NDArray[np.int64]

    def __len__(self) -> int:
        """How many there are."""
        return len(self.id)

    def select(self, rows: NDArray[np.intp] | NDArray[np.bool_]) -> Tracklets:
        """Some of them."""
        return Tracklets(self.id[rows], self.path[rows], self.age[rows])


def empty_tracklets(positions: int) -> Tracklets:
    """None, which would have so many positions."""
    none = np.zeros(0, np.int64)
    return Tracklets(none, np.zeros((0, positions, 2), np.float32), none)


class PointFollower:
    """Shi-Tomasi corners followed by pyramidal Lucas-Kanade [Yoneji2013] section 3.1.

    A point ends where it is not found again, or where following it back leads elsewhere. New
    points are looked for where there are none within the spacing.

    Args:
        settings: of points.
        positions: a tracklet's, at most.
        spacing_px: (height, width) distance of new points there.
    """

    def __init__(
        self, settings: PointSettings, positions: int, spacing_px: NDArray[np.float32]
    ) -> None:
        self._settings = settings
        self._cells = _Cells(spacing_px)
        self._points = empty_tracklets(positions)
        self._before: Grey | None = None
        self._next_id = 1

    def step(self, grey: Grey, seek: Mask | None) -> Tracklets:
        """Follow the points into the next picture and find new ones.

        Args:
            grey: (height, width).
            seek: (rows, columns) non-zero where new points are looked for, at half resolution
                (see `halving`); None: everywhere.
        """
        if self._before is not None and len(self._points):
            self._points = self._follow(self._before, grey)
        self._points = self._add_corners(grey, seek)
        self._before = grey
        return self._points

    def drop(self, gone: NDArray[np.bool_]) -> None:
        """Follow some of the points no further."""
        self._points = self._points.select(~gone)

    def _follow(self, before: Grey, grey: Grey) -> Tracklets:
        points, settings = self._points, self._settings
        start = np.ascontiguousarray(points.path[:, 0])
        pace = np.nan_to_num(start - points.path[:, 1])
        there, found = self._flow(before, grey, start, start + pace, settings.pyramid_levels)
        back, again = self._flow(grey, before, there, start.copy(), 0)
        height, width = grey.shape
        kept = found & again
        kept &= np.hypot(*(back - start).T) <= settings.forward_backward_px
        kept &= (there >= _BORDER_PX).all(axis=1)
        kept &= (there < np.array((width, height)) - _BORDER_PX).all(axis=1)
        path = np.concatenate((there[:, None], points.path[:, :-1]), axis=1)
        return Tracklets(points.id, path, points.age + 1).select(kept)

    def _flow(
        self, before: Grey, after: Grey, points: Paths, guess: Paths, levels: int
    ) -> tuple[Paths, NDArray[np.bool_]]:
        """Where points (n, 2) of a picture are in another one, and whether they are found."""
        side = self._settings.window_px
        there, found, change = cv2.calcOpticalFlowPyrLK(
            before,
            after,
            points,
            guess,
            winSize=(side, side),
            maxLevel=levels,
            criteria=(cv2.TERM_CRITERIA_COUNT | cv2.TERM_CRITERIA_EPS, _STEPS, _FINE_PX),
            flags=cv2.OPTFLOW_USE_INITIAL_FLOW,
        )
        alike = change[:, 0] <= self._settings.max_residual
        return np.asarray(there, np.float32), np.asarray((found[:, 0] > 0) & alike)

    def _add_corners(self, grey: Grey, seek: Mask | None) -> Tracklets:
        points = self._points
        room = self._settings.max_points - len(points)
        if room <= 0:
            return points
        new = self._corners(grey, seek, points.path[:, 0])[:room]
        path = np.full((len(new), points.path.shape[1], 2), np.nan, np.float32)
        path[:, 0] = new
        ids = np.arange(self._next_id, self._next_id + len(new))
        self._next_id += len(new)
        return Tracklets(
            np.append(points.id, ids),
            np.concatenate((points.path, path)),
            np.append(points.age, np.zeros(len(new), np.int64)),
        )

    def _corners(self, grey: Grey, seek: Mask | None, taken: Paths) -> Paths:
        """(k, 2) px new corners, the strongest first, one a cell that has no point yet."""
        strength = cv2.cornerMinEigenVal(halve(grey), _EIGEN_BLOCK)
        peak = strength >= cv2.dilate(strength, np.ones((3, 3), np.uint8))
        peak &= strength > self._settings.corner_quality
        if seek is not None:
            peak &= seek > 0
        peak[:_BORDER_PX] = peak[-_BORDER_PX:] = False
        peak[:, :_BORDER_PX] = peak[:, -_BORDER_PX:] = False
        v, u = np.nonzero(peak)
        order = np.argsort(-strength[v, u], kind="stable")
        found = np.column_stack((u, v))[order].astype(np.float32) * 2.0 + 0.5
        cell = self._cells.of(found)
        first = np.sort(np.unique(cell, return_index=True)[1])
        free = ~np.isin(cell[first], self._cells.of(taken))
        return found[first[free]]


class _Cells:
    """The picture cut into cells as large as the spacing: lines of them, coarser further down."""

    def __init__(self, spacing_px: NDArray[np.float32]) -> None:
        height, self._width = spacing_px.shape
        self._line = np.zeros(height, np.int64)
        self._side = np.zeros(height, np.float32)
        top, line = 0, 0
        while top < height:
            side = float(np.median(spacing_px[top]))
            bottom = min(height, top + max(2, round(side)))
            self._line[top:bottom], self._side[top:bottom] = line, max(2.0, side)
            top, line = bottom, line + 1

    def of(self, points: Paths) -> NDArray[np.int64]:
        """(n,) the cell each point (n, 2) is in."""
        row = np.clip(points[:, 1], 0, len(self._line) - 1).astype(np.intp)
        column = (points[:, 0] / self._side[row]).astype(np.int64)
        return np.asarray(self._line[row] * self._width + column, np.int64)
