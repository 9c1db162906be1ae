"""Track initiation at clusters of tracklets without an owner."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.flow.floor import Floor
from tracking.trackers.flow.flow_frame import paces
from tracking.trackers.flow.silhouettes import Cover, score_silhouettes

Floats = NDArray[np.float64]
Mask = NDArray[np.uint8]

_CENTRES_M = np.linspace(0.25, 1.6, 28)
"""Heights at which the middle of a cluster may be in its body."""
_USUAL_CENTRE_M, _CENTRE_ERROR_M = 1.15, 0.3
_USUAL_PACE_M_S, _PACE_ERROR_M_S = 1.2, 0.6
_HIGHEST_M = 1.8
_PRIOR = 0.03
"""What an oddity of one error, squared, costs of the score."""


@dataclass(frozen=True, slots=True)
class BirthHypothesis:
    """Where somebody new may stand.

    Attributes:
        place: (2,) m. pace: (2,) m/s. score, seen, own: see `Fit`.
    """

    place: Floats
    pace: Floats
    score: float
    seen: float
    own: float


def locate_birth(
    slope: Floats, before: Floats, over_s: float, mask: Mask, cover: Cover, floor: Floor
) -> BirthHypothesis:
    """Where the person of a cluster stands, of all places along the sight the likeliest.

    A body there must fill the foreground from head to feet and end where that ends, hold the
    tracklets, and walk about as fast as people do.

    Args:
        slope, before: (n, 2) of the cluster's tracklets, now and `over_s` ago.
        mask, cover: at half resolution; what is seen, and by whom it is explained.
    """
    middle = np.median(slope, axis=0)
    place = floor.places(middle[None], _CENTRES_M)
    height = floor.heights(slope[None], place[:, None])
    highest = height.max(axis=1)
    every = paces(slope[None], before[None], height, over_s, floor.camera_m)
    pace = np.median(every, axis=1)
    fit = score_silhouettes(place, mask, cover, floor)
    speed = np.hypot(pace[:, 0], pace[:, 1])
    odd = ((_CENTRES_M - _USUAL_CENTRE_M) / _CENTRE_ERROR_M) ** 2
    odd += ((speed - _USUAL_PACE_M_S) / _PACE_ERROR_M_S) ** 2
    odd += (np.maximum(highest - _HIGHEST_M, 0) / 0.1) ** 2
    best = int((fit.score - _PRIOR * odd).argmax())
    scores = (float(values[best]) for values in (fit.score, fit.seen, fit.own))
    return BirthHypothesis(place[best], pace[best], *scores)
