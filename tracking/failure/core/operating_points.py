"""Operating points: how many failures are found for how many false alarms, by held-out scores."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from tracking.arrays import Floats

NO_BETTER_THAN_CHANCE = 0.6
"""Below this area under its curve a machine found hardly more than drawing lots finds (0.5)."""


@dataclass(frozen=True, slots=True, eq=False)
class Curve:
    """Scores of samples that the machine which gave them had not seen; above 0 leans to failed.

    Attributes:
        on, off: (n,), (m,) ascending scores of samples on and off their part.
    """

    on: Floats
    off: Floats

    def threshold_for(self, false_alarms: float) -> float:
        """The least threshold at which at most this share of the samples on their part fail.

        A part fails where its score is above the threshold.
        """
        if not len(self.on):
            return 0.0
        allowed = min(math.floor(false_alarms * len(self.on) + 1e-9), len(self.on))
        if allowed == len(self.on):
            return float(np.nextafter(self.on[0], -math.inf))
        return float(self.on[len(self.on) - 1 - allowed])

    def false_alarms(self, threshold: float) -> float:
        """The share of samples on their part that fail; NaN without any."""
        return _above(self.on, threshold)

    def found(self, threshold: float) -> float:
        """The share of samples off their part that fail; NaN without any."""
        return _above(self.off, threshold)

    def points(self) -> Floats:
        """(p, 3) threshold, false alarms and found at every step of the curve, from few to many."""
        thresholds = np.unique(np.concatenate((self.on, self.off)))[::-1]
        if not len(thresholds):
            return np.zeros((1, 3))
        lowest = np.nextafter(thresholds[-1:], -math.inf)
        thresholds = np.concatenate((thresholds, lowest))
        rates = [
            1.0 - np.searchsorted(scores, thresholds, "right") / max(len(scores), 1)
            for scores in (self.on, self.off)
        ]
        return np.column_stack((thresholds, *rates))

    def area(self, most_false_alarms: float = 1.0) -> float:
        """The mean share found over the false alarms from 0 to a share; NaN without both sides."""
        if not len(self.on) or not len(self.off):
            return math.nan
        points = self.points()
        grid = np.linspace(0.0, most_false_alarms, 201)
        at = np.searchsorted(points[:, 1], grid + 1e-12, "right") - 1
        return float(points[np.maximum(at, 0), 2].mean())

    @property
    def by_chance(self) -> bool:
        """Whether the machine is no better than chance; see `NO_BETTER_THAN_CHANCE`."""
        known = len(self.on) > 0 and len(self.off) > 0
        return known and self.area() < NO_BETTER_THAN_CHANCE


def _above(scores: Floats, threshold: float) -> float:
    return float((scores > threshold).mean()) if len(scores) else math.nan
