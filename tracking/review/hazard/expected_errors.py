"""How much goes wrong where: hazards of rows summed over stretches of tracks."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.arrays import Floats
from tracking.review.core.evidence import Evidence, Rows
from tracking.review.core.material import Material
from tracking.review.hazard.features import features
from tracking.review.hazard.trees import Trees, built_in_trees


@dataclass(frozen=True, slots=True, eq=False)
class Hazards:
    """The hazard of each row: how likely its track goes wrong within a tenth of a second of it.

    Attributes:
        hazard: (n,) 0 to 1. total: (n + 1,) the sum of those up to each row.
    """

    evidence: Evidence
    hazard: Floats
    total: Floats

    @classmethod
    def of(cls, material: Material, trees: Trees | None = None) -> Hazards:
        """Of every row; trees: those built in unless told otherwise."""
        odds = (trees or built_in_trees()).log_odds(features(material))
        hazard = 1.0 / (1.0 + np.exp(-odds))
        return cls(material.evidence, hazard, np.concatenate(([0.0], np.cumsum(hazard))))

    def expect(self, track: Rows, start: Rows, end: Rows) -> Floats:
        """(k,) sums over stretches of tracks, half-open; 0 for track 0."""
        low, high = self._rows(track, start, end)
        return np.where(track > 0, self.total[high] - self.total[low], 0.0)

    def once(self, tracks: Rows, start: Rows, end: Rows, first: Rows) -> Floats:
        """(k,) sums over stretches of two tracks each, every row counted for one of them only.

        Args:
            tracks: (k, 2), 0 for none. first: (k,) the order in which stretches take their rows.
        """
        order = np.repeat(first, 2)
        low, high = self._rows(tracks[first].ravel(), start[order], end[order])
        count = np.where(tracks[first].ravel() > 0, high - low, 0)
        within = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
        row, taken = np.unique(np.repeat(low, count) + within, return_index=True)
        place = np.repeat(order, count)[taken]
        return np.asarray(np.bincount(place, self.hazard[row], len(start)), np.float64)

    def _rows(self, track: Rows, start: Rows, end: Rows) -> tuple[Rows, Rows]:
        low = self.evidence.row_from(track, np.maximum(start, 0))
        return low, np.maximum(self.evidence.row_from(track, np.maximum(end, 0)), low)
