"""Who is who: tracks and detections matched by the smallest total cost."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

from tracking.arrays import Floats

_NEVER = 1e6


@dataclass(frozen=True, slots=True)
class Association:
    """Pairs of tracks and detections; all arrays have one entry per pair, sorted by track.

    Attributes:
        track, detection: rows of the cost matrix and columns of it.
        margin: by how much the total of all pairs would grow with the best other choice for this
            pair: a free detection, a free track, or an exchange with another pair; NaN where
            there is no other choice.
    """

    track: NDArray[np.intp]
    detection: NDArray[np.intp]
    margin: Floats


def associate(cost: Floats, allowed: NDArray[np.bool_], left_out: float | Floats) -> Association:
    """The pairs with the smallest total cost ([Kawashita2014] section 3.3).

    Args:
        cost: (tracks, detections) total D. allowed: the same shape; False is never a pair.
        left_out: what it costs to leave a track without a detection; (tracks,) or of all alike.
    """
    track, detection = cheapest_pairs(cost, allowed, left_out)
    return Association(track, detection, margins(cost, allowed, track, detection))


def nearest_first(cost: Floats, allowed: NDArray[np.bool_]) -> Association:
    """One pair after the other, the cheapest of those that are left first.

    Each track takes the detection that costs it least ([Kawashita2012] eq. 5); the source leaves
    open who has one that is the cheapest for several, and here it is whom it costs least. The
    total may be more than that of `associate`: the margins are 0 there.

    Args:
        cost: (tracks, detections) total D. allowed: the same shape; False is never a pair.
    """
    left = np.where(allowed, cost, np.inf)
    pairs: list[tuple[int, int]] = []
    while left.size and np.isfinite(cheapest := left.min()):
        row, column = np.argwhere(left == cheapest)[0].tolist()
        pairs.append((row, column))
        left[row], left[:, column] = np.inf, np.inf
    track, detection = np.array(sorted(pairs), np.intp).reshape(-1, 2).T
    return Association(track, detection, np.maximum(margins(cost, allowed, track, detection), 0.0))


def cheapest_pairs(
    cost: Floats, allowed: NDArray[np.bool_], left_out: float | Floats
) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """The tracks and detections of `associate`, without the margins."""
    tracks, detections = cost.shape
    if not (tracks and detections):
        return np.zeros(0, np.intp), np.zeros(0, np.intp)
    choices = np.full((tracks, detections + tracks), _NEVER)
    choices[:, :detections] = np.where(allowed, cost, _NEVER)
    choices[np.arange(tracks), detections + np.arange(tracks)] = left_out
    rows, columns = linear_sum_assignment(choices)
    real = columns < detections
    return rows[real], columns[real]


def margins(
    cost: Floats,
    allowed: NDArray[np.bool_],
    track: NDArray[np.intp],
    detection: NDArray[np.intp],
) -> Floats:
    """By how much the total grows with the best single change that breaks each pair.

    Args:
        cost, allowed: as in `associate`. track, detection: the pairs, each of both once.

    Returns:
        (pairs,); NaN where there is no other choice.
    """
    cost = np.where(allowed, cost, np.inf)
    free_track, free_detection = (np.ones(length, np.bool_) for length in cost.shape)
    free_track[track] = free_detection[detection] = False
    theirs = cost[track]
    free_tracks = cost[free_track][:, detection]
    free_detections = theirs[:, free_detection]
    best = np.minimum(
        free_tracks.min(axis=0, initial=np.inf), free_detections.min(axis=1, initial=np.inf)
    )
    among = theirs[:, detection]
    own = among.diagonal()
    exchange = among + among.T - own[None, :]
    np.fill_diagonal(exchange, np.inf)
    best = np.minimum(best, exchange.min(axis=1, initial=np.inf))
    return np.where(np.isinf(best), np.nan, best - own)


def turning_angle(walked: Floats, candidate: Floats) -> Floats:
    """The angle between where people walked and where each candidate would have them walk.

    Args:
        walked: (people, 2) m, along each track's own history; NaN where it has no direction.
        candidate: (people, detections, 2) m, from a past position of the track to the detection.

    Returns (people, detections) in 0 to pi rad; NaN where either has no direction.
    """
    forward = np.einsum("pk,pdk->pd", walked, candidate)
    sideways = walked[:, None, 0] * candidate[..., 1] - walked[:, None, 1] * candidate[..., 0]
    return np.asarray(np.abs(np.arctan2(sideways, forward)))


def direction_cost(angle: Floats, threshold_rad: float, weight: float) -> Floats:
    """What a turn costs: `Da = k alpha / alpha_thr`, and `k` from the threshold on.

    ([Kawashita2014] eq. 5; its first branch is garbled in print, this one grows to `k` as the
    text demands.) NaN angles give NaN.
    """
    return weight * np.minimum(angle / threshold_rad, 1.0)


def bhattacharyya_distance(
    models: NDArray[np.float32], seen: NDArray[np.float32]
) -> NDArray[np.float64]:
    """The distance of every model to every histogram seen: (people, detections), in 0 to 1.

    `rho = sum_u sqrt(p_u q_u)`, `Dc = sqrt(1 - rho)` ([Kawashita2012] eq. 3 and 4).

    Args:
        models: (people, bins), rows sum to 1. seen: (detections, bins), rows sum to 1.
    """
    rho = (np.sqrt(models) @ np.sqrt(seen).T).astype(np.float64)
    return np.sqrt(np.clip(1.0 - rho, 0.0, 1.0))
