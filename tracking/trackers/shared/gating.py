"""Gates: how far from where somebody is expected they may be found."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class WideningGate:
    """A round gate that widens while somebody is not seen.

    Attributes:
        at_once, a_second, widest: its radius, by how much it grows, and its largest radius; in
            metres, or in what else the tracker measures by.
    """

    at_once: float
    a_second: float
    widest: float = np.inf

    def radius(self, missed_s: Floats | float) -> Floats:
        """(...) of somebody not seen for so long."""
        return np.asarray(np.minimum(self.at_once + self.a_second * missed_s, self.widest))


@dataclass(frozen=True, slots=True)
class GatedPairs:
    """All pairs of a track and a detection, and which of them the gate lets through.

    Attributes:
        offset: (tracks, detections, 2) m, from where a track is expected to the detection.
        distance: (tracks, detections) m. allowed: (tracks, detections) inside the gate.
    """

    offset: Floats
    distance: Floats
    allowed: NDArray[np.bool_]


def gate_pairs(expected: Floats, measured: Floats, radius: Floats | float) -> GatedPairs:
    """The pairs of tracks and detections within the gate.

    Args:
        expected: (tracks, 2) m. measured: (detections, 2) m.
        radius: m, of all pairs, or of each: (tracks, 1) or (tracks, detections).
    """
    offset = measured[None] - expected[:, None]
    distance = np.hypot(offset[..., 0], offset[..., 1])
    return GatedPairs(offset, distance, distance <= radius)


def nearest_others_m(place: Floats) -> Floats:
    """(people,) m from places (people, 2) to the next other one; infinite for who is alone."""
    apart = np.hypot(*(place[:, None] - place[None]).transpose(2, 0, 1))
    np.fill_diagonal(apart, np.inf)
    return np.asarray(apart.min(axis=1, initial=np.inf))
