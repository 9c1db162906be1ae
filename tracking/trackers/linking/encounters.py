"""Who came so near whom that one may have been taken for the other."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from tracking.tracks.boxes import common_px2

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
Integers = NDArray[np.int64]

NEAR_M = 0.75
"""Two bodies with their errors of place."""
_BEHIND_M = 1.6
"""Somebody hidden is looked for so far behind, or before, who hides them."""
_COVERED = 0.3
"""Share of the smaller box that two have in common from which on one may hide the other."""


@dataclass(frozen=True, slots=True)
class Encounters:
    """Pairs of tracks that were close in a frame.

    Attributes:
        met: (rows of the tracks,) somebody else was close.
        frame: (k,) sorted by pair and frame. pair: (k, 2) ids, the lower one first.
        distance_m: (k,) on the floor.
    """

    met: Flags
    frame: Integers
    pair: Integers
    distance_m: Floats

    def stretches(self, apart: int) -> list[slice]:
        """The rows of each meeting of two; those of the same two stand so many frames apart."""
        if len(self.frame) == 0:
            return []
        new = (np.diff(self.pair, axis=0) != 0).any(axis=1) | (np.diff(self.frame) > apart)
        ends = [0, *(np.flatnonzero(new) + 1).tolist(), len(self.frame)]
        return [slice(a, b) for a, b in pairwise(ends)]


def find_encounters(
    frame: NDArray[np.integer], track: NDArray[np.integer], place: Floats, box: Floats, known: Flags
) -> Encounters:
    """Who was close to whom, in which frames.

    Args:
        frame, track: (n,) of a run's tracks, sorted by frame. place: (n, 2) m. box: (n, 4) px.
        known: (n,) rows with a place and a box.
    """
    met = np.zeros(len(frame), bool)
    one, other, distances = [], [], []
    for step in range(1, len(frame)):
        same = np.flatnonzero(frame[step:] == frame[:-step])
        if len(same) == 0:
            break
        same = same[known[same] & known[same + step]]
        distance = np.hypot(*(place[same + step] - place[same]).T)
        close = distance < NEAR_M
        close |= (distance < _BEHIND_M) & (_common(box[same], box[same + step]) > _COVERED)
        one.append(same[close])
        other.append(same[close] + step)
        distances.append(distance[close])
    if not one:
        nothing = np.zeros(0, np.int64)
        return Encounters(met, nothing, np.zeros((0, 2), np.int64), np.zeros(0))
    first, second, distance_m = map(np.concatenate, (one, other, distances))
    met[first] = met[second] = True
    pair = np.sort(np.stack((track[first], track[second]), axis=1).astype(np.int64), axis=1)
    order = np.lexsort((frame[first], pair[:, 1], pair[:, 0]))
    return Encounters(met, frame[first][order].astype(np.int64), pair[order], distance_m[order])


def _common(one: Floats, other: Floats) -> Floats:
    """(n,) the share of the smaller box that two boxes (n, 4) have in common."""
    smaller = np.minimum(np.prod(one[:, 2:], axis=1), np.prod(other[:, 2:], axis=1))
    return np.asarray(common_px2(one, other) / np.maximum(smaller, 1e-9))
