"""How alike two rows are."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Protocol

import numpy as np

from tracking.arrays import Floats
from tracking.errors import FormatError, SettingsError
from tracking.scoring.pairs import EPS, Rows
from tracking.scoring.table import ScoringTable


class Match(Protocol):
    """A way to say how alike two rows are."""

    @property
    def threshold(self) -> float:
        """Rows at least this alike may be one person."""

    def measured(self, table: ScoringTable) -> Floats:
        """(m, n) what of each row the similarity is had from.

        The first two are the ends of a stretch along any one axis: rows whose stretches do not
        meet have similarity 0. NaN meets nothing.
        """

    def similarity(self, truth: Floats, result: Floats, pairs: Rows) -> Floats:
        """(k,) 0 to 1 for each pair of rows; 0 where it cannot be said.

        Args:
            truth, result: as measured.
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
            raise SettingsError(
                "overlap {threshold} is not in 0 to 1; 0.5 is usual", threshold=self.threshold
            )

    def measured(self, table: ScoringTable) -> Floats:
        """(5, n) left, right, top and bottom edges, and areas."""
        found = np.empty((5, len(table)))
        for axis, (low, high) in enumerate((found[0:2], found[2:4])):
            np.add(table.box[:, axis], self.first_pixel, out=low)
            np.add(low, table.box[:, axis + 2], out=high)
        np.multiply(found[1] - found[0], found[3] - found[2], out=found[4])
        return found

    def similarity(self, truth: Floats, result: Floats, pairs: Rows) -> Floats:
        """Intersection over union of the boxes."""
        a, b = pairs.truth, pairs.result
        across = np.minimum(truth[1][a], result[1][b]) - np.maximum(truth[0][a], result[0][b])
        down = np.minimum(truth[3][a], result[3][b]) - np.maximum(truth[2][a], result[2][b])
        shared = np.maximum(across, 0) * np.maximum(down, 0)
        a_area, b_area = truth[4][a], result[4][b]
        union = a_area + b_area - shared
        real = (a_area > EPS) & (b_area > EPS) & (union > EPS)  # False for NaN
        return np.asarray(np.divide(shared, union, out=np.zeros(len(union)), where=real))

    def require(self, table: ScoringTable, side: str) -> None:
        """Boxes are asked for."""
        if not _any_known(table.box):
            raise FormatError(
                "the {side} has no boxes",
                "match by floor distance",
                option="--match floor",
                side=side,
            )


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
            raise SettingsError(
                "radius {radius_m} m is not above 0; 0.5 is usual", radius_m=self.radius_m
            )

    def measured(self, table: ScoringTable) -> Floats:
        """(4, n) as far along x as half of what another row may be away, then x and y."""
        x, y = table.position.T
        # A little more than a radius to either side, for rounding.
        half_m = self.radius_m * (1.0 + 1e-6) + np.abs(x) * 1e-12
        return np.stack([x - half_m, x + half_m, x, y])

    def similarity(self, truth: Floats, result: Floats, pairs: Rows) -> Floats:
        """1 at the same place, 0.5 at the radius, 0 from twice the radius on."""
        x, y = (truth[axis][pairs.truth] - result[axis][pairs.result] for axis in (2, 3))
        # Not np.hypot: equal distances must round as in TrackEval, which decides between them.
        alike = np.maximum(0.0, 1.0 - np.sqrt(x * x + y * y) / (2.0 * self.radius_m))
        return np.where(np.isnan(alike), 0.0, alike)

    def require(self, table: ScoringTable, side: str) -> None:
        """Positions are asked for."""
        if not _any_known(table.position):
            raise FormatError(
                "the {side} has no floor positions",
                "match by boxes",
                option="--match box",
                side=side,
            )


def _any_known(values: Floats) -> bool:
    """Whether a row is known in full, or there are none."""
    if not len(values) or not np.isnan(values[0]).any():
        return True
    return not np.isnan(values).any(axis=1).all()
