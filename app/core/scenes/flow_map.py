"""The flow map as the overhead view draws it."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from app.core.scenes import LegendEntry


@dataclass(frozen=True, slots=True, eq=False)
class FlowScene:
    """The flow map over the floor.

    Attributes:
        left, bottom, cell_m: where its cells lie, m; row 0 is the lowest.
        image: (rows, columns, 4) uint8 RGBA, row 0 the highest. The very same while it stays.
        arrows: (n, 4) from x, y to x, y in m, the longer the faster.
        legend: what its colours mean.
    """

    left: float
    bottom: float
    cell_m: float
    image: NDArray[np.uint8]
    arrows: NDArray[np.float64] = field(default_factory=lambda: np.zeros((0, 4)))
    legend: tuple[LegendEntry, ...] = ()
