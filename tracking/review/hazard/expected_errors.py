"""How much goes wrong where: hazards of rows summed over stretches of tracks."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.review.core.evidence import Evidence, Rows
from tracking.review.core.material import Material
from tracking.review.hazard.features import features
from tracking.review.hazard.picture import picture_features
from tracking.review.hazard.trees import Trees, built_in_corrections, built_in_trees

_AROUND_S, _TRACKS = 0.1, 1.5
"""So far from a mistake rows count as going wrong, and of so many tracks on average."""


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
    def of(
        cls, material: Material, trees: Trees | None = None, corrections: Trees | None = None
    ) -> Hazards:
        """Of every row; trees and corrections: those built in unless told otherwise."""
        values = corrected_by(material, trees or built_in_trees())
        odds = (corrections or built_in_corrections()).log_odds(values)
        hazard = 1.0 / (1.0 + np.exp(-odds))
        return cls(material.evidence, hazard, np.concatenate(([0.0], np.cumsum(hazard))))

    def expect(self, track: Rows, start: Rows, end: Rows) -> Floats:
        """(k,) sums over stretches of tracks, half-open; 0 for track 0."""
        low, high = self._rows(track, start, end)
        return np.where(track > 0, self.total[high] - self.total[low], 0.0)

    def mistakes(self, start: Rows, end: Rows) -> Floats:
        """(k,) how many of everybody's are expected in half-open ranges of frames.

        Rounded, as sums up to a frame are not the same to the last digit wherever they begin.
        """
        frames = self.evidence.frame
        of_frame = np.bincount(frames, self.hazard, self.evidence.stop + 1)
        total = np.concatenate(([0.0], np.cumsum(of_frame)))
        low, high = (np.clip(at, 0, self.evidence.stop) for at in (start, end))
        rows = _TRACKS * (2 * self.evidence.frames_of(_AROUND_S) + 1)
        return np.asarray(np.round((total[high] - total[low]) / rows, 6))

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


def corrected_by(material: Material, trees: Trees) -> NDArray[np.float32]:
    """(n, features) of every row: `CORRECTED_BY`; trees: whose log odds are corrected."""
    values = features(material)
    odds = trees.log_odds(values)[:, None].astype(np.float32)
    return np.concatenate((values, picture_features(material), odds), axis=1)
