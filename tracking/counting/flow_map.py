"""Where people are and which way they go: the floor in cells."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from tracking.arrays import Flags, Floats, Integers
from tracking.counting.paths import Paths
from tracking.counting.speeds import velocities
from tracking.errors import CountingError

CELL_M = 0.5
_MOST_CELLS = 400
"""Along a side. One wrong place kilometres away would ask for millions of cells: cells then grow,
so that the map stays small, if coarse."""


@dataclass(frozen=True, slots=True, eq=False)
class FlowMap:
    """A grid over the floor; row 0 lies at its lower edge, column 0 at its left one.

    Attributes:
        left, bottom: its corner, m. cell_m: the side of a cell.
        density: (rows, columns) people a square metre, the mean over all frames.
        velocity: (rows, columns, 2) the mean of who was there, m/s; NaN where nobody was.
        frames: how many frames the means are over.
    """

    left: float
    bottom: float
    cell_m: float
    density: Floats
    velocity: Floats
    frames: int

    @property
    def most(self) -> float:
        """The highest density; 0 where nobody was."""
        return float(self.density.max(initial=0.0))

    @property
    def centres(self) -> Floats:
        """(rows, columns, 2) the middle of each cell, m."""
        rows, columns = self.density.shape
        x = self.left + (np.arange(columns) + 0.5) * self.cell_m
        y = self.bottom + (np.arange(rows) + 0.5) * self.cell_m
        middle: Floats = np.stack(np.meshgrid(x, y), axis=-1)
        return middle


def flow_map(
    columns: Mapping[str, ArrayLike],
    fps: float,
    frames: tuple[int, int],
    cell_m: float = CELL_M,
    *,
    bounds: tuple[float, float, float, float] | None = None,
) -> FlowMap:
    """Density and direction of people on the floor in a half-open range of frames.

    Args:
        columns: `frame, track, x, y`; people without a place on the floor are left out.
        bounds: left, bottom, right, top in m: only cells that begin inside; None: wherever
            somebody was.

    Raises CountingError for a cell that has no size, a track twice in one frame.
    """
    if not (math.isfinite(cell_m) and cell_m > 0):
        raise CountingError("a cell of {cell_m:g} m; it needs a size", cell_m=cell_m)
    paths = Paths.on_floor(columns)
    velocity = velocities(paths, fps)
    used = (paths.frame >= frames[0]) & (paths.frame < frames[1])
    if bounds is not None:
        low, high = np.array(bounds[:2]), np.array(bounds[2:])
        used &= ((paths.place >= low) & (paths.place < high)).all(axis=1)
    return _over(paths.place[used], velocity[used], max(frames[1] - frames[0], 1), cell_m)


def _over(place: Floats, velocity: Floats, frames: int, cell_m: float) -> FlowMap:
    if not len(place):
        return FlowMap(0.0, 0.0, cell_m, np.zeros((0, 0)), np.zeros((0, 0, 2)), frames)
    widest = float((place.max(axis=0) - place.min(axis=0)).max())
    cell_m = max(cell_m, widest / (_MOST_CELLS - 1))
    cell = np.floor(place / cell_m).astype(np.int64)
    first = cell.min(axis=0)
    columns, rows = (cell.max(axis=0) - first + 1).tolist()
    at = (cell[:, 1] - first[1]) * columns + cell[:, 0] - first[0]
    density = np.bincount(at, minlength=rows * columns) / (frames * cell_m**2)
    moving = np.isfinite(velocity).all(axis=1)
    mean = _means(at[moving], velocity[moving], rows * columns)
    left, bottom = (first * cell_m).tolist()
    return FlowMap(
        left,
        bottom,
        cell_m,
        density.reshape(rows, columns),
        mean.reshape(rows, columns, 2),
        frames,
    )


def _means(at: Integers, velocity: Floats, cells: int) -> Floats:
    """(cells, 2) mean velocity, m/s; NaN where nobody moved."""
    number = np.bincount(at, minlength=cells)
    sums = [np.bincount(at, part, minlength=cells) for part in velocity.T]
    total = np.column_stack(sums).astype(np.float64)
    there: Flags = number > 0
    mean = np.full((cells, 2), np.nan)
    mean[there] = total[there] / number[there, None]
    return mean
