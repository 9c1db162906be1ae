"""How alike two rows are."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Protocol

import numpy as np

from tracking.errors import FormatError, SettingsError
from tracking.scoring.pairs import EPS, Rows
from tracking.scoring.table import Floats, ScoringTable


class Match(Protocol):
    """A way to say how alike two rows are."""

    @property
    def threshold(self) -> float:
        """Rows at least this alike may be one person."""

    def similarity(self, truth: ScoringTable, result: ScoringTable, pairs: Rows) -> Floats:
        """(k,) 0 to 1 for each pair of rows; 0 where it cannot be said."""

    def reach(self, table: ScoringTable) -> tuple[Floats, Floats]:
        """(n,) and (n,) least and greatest of a stretch along any one axis.

        Two rows whose stretches do not meet have similarity 0. NaN meets nothing.
        """

    def require(self, table: ScoringTable, side: str) -> None:
        """Refuse a table whose rows have nothing to be matched by; `side` is its name."""


@dataclass(frozen=True, slots=True)
class BoxMatch:
    """Boxes in the image, by intersection over union.

    Attributes:
        threshold: least overlap of one person's boxes.
        first_pixel: the number the first pixel bears where corners are added up. It only tells
            how sums round, and so whether an overlap right on the threshold is on it: 1 as for
            tools that read MOTChallenge's files as they are, 0 for those that subtract 1 first.
    """

    threshold: float = 0.5
    first_pixel: float = 1.0

    def __post_init__(self) -> None:
        if not 0 < self.threshold <= 1:
            raise SettingsError(f"overlap {self.threshold} is not in 0 to 1; 0.5 is usual")

    def similarity(self, truth: ScoringTable, result: ScoringTable, pairs: Rows) -> Floats:
        """Intersection over union of the boxes."""
        a, b = truth.box[pairs.truth], result.box[pairs.result]
        a_size, b_size, shared = np.ones(len(a)), np.ones(len(b)), np.ones(len(a))
        for axis in (0, 1):
            a_low, a_high = self._corners(a, axis)
            b_low, b_high = self._corners(b, axis)
            a_size *= a_high - a_low
            b_size *= b_high - b_low
            shared *= np.maximum(np.minimum(a_high, b_high) - np.maximum(a_low, b_low), 0)
        union = a_size + b_size - shared
        real = (a_size > EPS) & (b_size > EPS) & (union > EPS)  # False for NaN
        return np.asarray(np.divide(shared, union, out=np.zeros(len(union)), where=real))

    def reach(self, table: ScoringTable) -> tuple[Floats, Floats]:
        """From the left edge to the right one."""
        return self._corners(table.box, 0)

    def _corners(self, box: Floats, axis: int) -> tuple[Floats, Floats]:
        """(n,) and (n,) where the boxes begin and end, from left to right or downward."""
        low = box[:, axis] + self.first_pixel
        return low, low + box[:, axis + 2]

    def require(self, table: ScoringTable, side: str) -> None:
        """Boxes are asked for."""
        if len(table) and np.isnan(table.box).any(axis=1).all():
            raise FormatError(f"the {side} has no boxes; match by floor distance (--match floor)")


@dataclass(frozen=True, slots=True)
class FloorMatch:
    """Positions on the floor, by distance.

    Attributes:
        radius_m: greatest distance of one person's positions.
    """

    radius_m: float = 0.5
    threshold: float = field(default=0.5, init=False)

    def __post_init__(self) -> None:
        if not 0 < self.radius_m < np.inf:
            raise SettingsError(f"radius {self.radius_m} m is not above 0; 0.5 is usual")

    def similarity(self, truth: ScoringTable, result: ScoringTable, pairs: Rows) -> Floats:
        """1 at the same place, 0.5 at the radius, 0 from twice the radius on."""
        apart = truth.position[pairs.truth] - result.position[pairs.result]
        distance_m = np.hypot(apart[:, 0], apart[:, 1])
        alike = np.maximum(0.0, 1.0 - distance_m / (2.0 * self.radius_m))
        return np.where(np.isnan(alike), 0.0, alike)

    def reach(self, table: ScoringTable) -> tuple[Floats, Floats]:
        """As far along x as half of what another row may be away, and a little for rounding."""
        x, radius_m = table.position[:, 0], self.radius_m * (1.0 + 1e-6)
        slack = np.abs(x) * 1e-12
        return x - radius_m - slack, x + radius_m + slack

    def require(self, table: ScoringTable, side: str) -> None:
        """Positions are asked for."""
        if len(table) and np.isnan(table.position).any(axis=1).all():
            raise FormatError(f"the {side} has no floor positions; match by boxes (--match box)")
