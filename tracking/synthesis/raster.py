"""Triangles to samples: a z-buffer over all triangles of a picture at once.

No loop runs over triangles: rows of triangles, then samples of rows, are laid out in one long
array each, and a packed key of depth and triangle decides who is in front.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Float32s

Ints = NDArray[np.int32]


@dataclass(frozen=True, slots=True)
class Samples:
    """Samples covered by triangles. All arrays have n rows.

    Attributes:
        triangle: index of the triangle.
        x, y: the sample's column and row.
        depth: the interpolated third coordinate; the largest is in front.
    """

    triangle: Ints
    x: Ints
    y: Ints
    depth: Float32s

    def where(self, chosen: NDArray[np.bool_]) -> Samples:
        """The chosen ones."""
        picked = np.flatnonzero(chosen)
        return Samples(self.triangle[picked], self.x[picked], self.y[picked], self.depth[picked])


def planes(corners: Float32s, values: Float32s) -> Float32s:
    """Coefficients (t, 3, k), a, b and c, with value = a x + b y + c over each triangle.

    Args:
        corners: (t, 3, 2) or wider; columns 0 and 1 are x and y.
        values: (t, 3, k) values at the corners.
    """
    origin = corners[:, 0, :2]
    e1 = corners[:, 1, :2] - origin
    e2 = corners[:, 2, :2] - origin
    area = e1[:, 0] * e2[:, 1] - e1[:, 1] * e2[:, 0]
    scale = 1.0 / np.where(area == 0, 1.0, area)
    d1 = values[:, 1] - values[:, 0]
    d2 = values[:, 2] - values[:, 0]
    a = (d1 * e2[:, 1:2] - d2 * e1[:, 1:2]) * scale[:, None]
    b = (d2 * e1[:, 0:1] - d1 * e2[:, 0:1]) * scale[:, None]
    c = values[:, 0] - a * origin[:, 0:1] - b * origin[:, 1:2]
    return np.asarray(np.stack((a, b, c), axis=1), np.float32)


def fill(corners: Float32s, window: tuple[int, int, int, int]) -> Samples:
    """All samples inside the triangles, one entry for each triangle that covers a sample.

    Args:
        corners: (t, 3, 3) x, y, depth; samples lie at whole x and y.
        window: left, top, right, bottom (half-open) outside of which nothing is wanted.
    """
    rows = _rows(corners, window)
    counts = np.maximum(rows.end - rows.start, 0)
    row = np.repeat(np.arange(len(counts), dtype=np.int32), counts)
    first = np.cumsum(counts) - counts
    x = np.arange(len(row), dtype=np.int32) + (rows.start - first.astype(np.int32))[row]
    depth = rows.depth[row] + rows.slope[row] * x.astype(np.float32)
    return Samples(rows.triangle[row], x, rows.y[row], depth)


@dataclass(frozen=True, slots=True)
class _Rows:
    """The part of a triangle in one row: start <= x < end, depth = depth + slope x."""

    triangle: Ints
    y: Ints
    start: Ints
    end: Ints
    depth: Float32s
    slope: Float32s


def _rows(corners: Float32s, window: tuple[int, int, int, int]) -> _Rows:
    left, top, right, bottom = window
    order = np.argsort(corners[:, :, 1], axis=1)
    sorted_corners = np.take_along_axis(corners, order[:, :, None], axis=1)
    px, py = sorted_corners[:, :, 0], sorted_corners[:, :, 1]
    y_start = np.maximum(np.ceil(py[:, 0]), top).astype(np.int32)
    y_end = np.minimum(np.ceil(py[:, 2]), bottom).astype(np.int32)
    counts = np.maximum(y_end - y_start, 0)
    triangle = np.repeat(np.arange(len(corners), dtype=np.int32), counts)
    first = (np.cumsum(counts) - counts).astype(np.int32)
    y = np.arange(len(triangle), dtype=np.int32) + (y_start - first)[triangle]
    long_edge, short_edge = _edges_at(px, py, triangle, y)
    # A sample on a shared edge belongs to one triangle: start <= x < end.
    start = np.ceil(np.minimum(long_edge, short_edge))
    end = np.ceil(np.maximum(long_edge, short_edge))
    plane = planes(corners, corners[:, :, 2:])[:, :, 0]
    depth = plane[triangle, 1] * y.astype(np.float32) + plane[triangle, 2]
    return _Rows(
        triangle,
        y,
        np.clip(start, left, right).astype(np.int32),
        np.clip(end, left, right).astype(np.int32),
        depth,
        plane[triangle, 0],
    )


def _edges_at(px: Float32s, py: Float32s, triangle: Ints, y: Ints) -> tuple[Float32s, Float32s]:
    """Where each row crosses its triangle's long edge and the other two."""

    def slopes(a: int, b: int) -> Float32s:
        rise = py[:, b] - py[:, a]
        run = px[:, b] - px[:, a]
        return np.asarray(run / np.where(rise == 0, np.float32(1), rise), np.float32)

    down = y.astype(np.float32)
    upper = down < py[triangle, 1]
    long_edge = px[triangle, 0] + (down - py[triangle, 0]) * slopes(0, 2)[triangle]
    high = px[triangle, 0] + (down - py[triangle, 0]) * slopes(0, 1)[triangle]
    low = px[triangle, 1] + (down - py[triangle, 1]) * slopes(1, 2)[triangle]
    return long_edge, np.asarray(np.where(upper, high, low), np.float32)


class DepthBuffer:
    """Keeps, for each sample of a canvas, what lies in front.

    Attributes:
        width, height: of the canvas in samples.
    """

    def __init__(self, width: int, height: int, still: Float32s | None = None) -> None:
        """Start empty, or with the depth (height, width) of things that never move."""
        self.width, self.height = width, height
        depth = np.zeros((height, width), np.float32) if still is None else still
        # A moving thing at the same depth as a still one is in front: its low half is not 0.
        self._start = np.ascontiguousarray(depth).view(np.int32).astype(np.int64).ravel() << 32
        self._keys = self._start.copy()

    def nearest(self, samples: Samples) -> NDArray[np.bool_]:
        """Which of the samples (all inside the canvas, depth > 0) are in front of everything."""
        place = samples.y * np.int32(self.width) + samples.x
        np.copyto(self._keys, self._start)
        key = samples.depth.view(np.int32).astype(np.int64) << 32
        key |= samples.triangle + np.int32(1)
        np.maximum.at(self._keys, place, key)
        return np.asarray(self._keys[place] == key)

    def depth(self) -> Float32s:
        """The depth (height, width) in front after the last `nearest`; 0 where nothing is."""
        bits = (self._keys >> 32).astype(np.int32)
        return bits.view(np.float32).reshape(self.height, self.width)
