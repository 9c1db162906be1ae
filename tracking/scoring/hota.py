"""HOTA: detection and association in one balanced number, over all strictness of matching."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.arrays import Floats

ALPHAS = np.arange(0.05, 0.99, 0.05)
"""Similarities from which a matched pair counts, 0.05 to 0.95."""

CURVES = ("HOTA", "DetA", "AssA", "DetRe", "DetPr", "AssRe", "AssPr", "LocA", "OWTA")
"""The curves by TrackEval's names, see `Hota.curve`."""

_LEAST = 1e-10


@dataclass(frozen=True, slots=True, eq=False)
class Hota:
    """[Luiten2020]: counts and curves over `ALPHAS`, each (19,); numbers are a curve's mean.

    Attributes:
        matches: pairs that count. misses, false_positives: rows left on either side.
        assa_curve: mean over the matches of the Jaccard index of their person and their track.
        assre_curve, asspr_curve: likewise the share of the person, and of the track.
        loca_curve: mean similarity of the matches; 1 without any.
    """

    matches: Floats
    misses: Floats
    false_positives: Floats
    assa_curve: Floats
    assre_curve: Floats
    asspr_curve: Floats
    loca_curve: Floats

    @classmethod
    def without_matches(cls, misses: int, false_positives: int) -> Hota:
        """Where nothing is alike, or a side is empty."""
        zero = np.zeros(len(ALPHAS))
        return cls(zero, zero + misses, zero + false_positives, zero, zero, zero, zero + 1.0)

    @property
    def deta_curve(self) -> Floats:
        """Jaccard index of the rows."""
        return self.matches / np.maximum(1, self.matches + self.misses + self.false_positives)

    @property
    def detre_curve(self) -> Floats:
        """Share of the truth's rows that are matched."""
        return self.matches / np.maximum(1, self.matches + self.misses)

    @property
    def detpr_curve(self) -> Floats:
        """Share of the result's rows that are matched."""
        return self.matches / np.maximum(1, self.matches + self.false_positives)

    @property
    def hota_curve(self) -> Floats:
        """Geometric mean of detection and association."""
        return np.sqrt(self.deta_curve * self.assa_curve)

    @property
    def owta_curve(self) -> Floats:
        """The same with detection recall: false positives do not count [Liu2022]."""
        return np.sqrt(self.detre_curve * self.assa_curve)

    def curve(self, name: str) -> Floats:
        """(19,) the curve of one of the names in `CURVES`."""
        return np.asarray(getattr(self, f"{name.lower()}_curve"))

    @property
    def hota(self) -> float:
        """Mean of the HOTA curve."""
        return float(self.hota_curve.mean())

    @property
    def deta(self) -> float:
        """Mean of the DetA curve."""
        return float(self.deta_curve.mean())

    @property
    def assa(self) -> float:
        """Mean of the AssA curve."""
        return float(self.assa_curve.mean())

    @property
    def loca(self) -> float:
        """Mean of the LocA curve."""
        return float(self.loca_curve.mean())

    @property
    def hota_0(self) -> float:
        """HOTA at the least strict matching."""
        return float(self.hota_curve[0])

    @property
    def loca_0(self) -> float:
        """LocA at the least strict matching."""
        return float(self.loca_curve[0])

    @property
    def hota_loca_0(self) -> float:
        """The product of the two."""
        return self.hota_0 * self.loca_0


def combined_hota(parts: list[Hota]) -> Hota:
    """Of several sequences: counts added up, the rest weighted with the matches."""
    matches = _sum([part.matches for part in parts])
    located = _sum([part.loca_curve * part.matches for part in parts])

    def weighted(name: str) -> Floats:
        total = _sum([part.curve(name) * part.matches for part in parts])
        return np.asarray(total / np.maximum(1.0, matches))

    return Hota(
        matches=matches,
        misses=_sum([part.misses for part in parts]),
        false_positives=_sum([part.false_positives for part in parts]),
        assa_curve=weighted("AssA"),
        assre_curve=weighted("AssRe"),
        asspr_curve=weighted("AssPr"),
        loca_curve=np.maximum(_LEAST, located) / np.maximum(_LEAST, matches),
    )


def _sum(curves: list[Floats]) -> Floats:
    return np.asarray(sum(curves, np.zeros(len(ALPHAS))))
