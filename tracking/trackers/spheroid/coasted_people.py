"""People who were lost a moment ago, and newcomers who are them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.spheroid.appearance import difference
from tracking.trackers.spheroid.hypotheses import Floats, Followed, together

_REACH_M, _WALK_M_PER_S, _FARTHEST_M = 0.7, 1.3, 4.0
"""How far from where they were expected people are found again."""
_UNLIKE = 0.3
"""Difference of colours from which on somebody is somebody else."""
_FAR = 0.3
"""What the whole reach counts beside the colours."""
_LED_ON_S = 1.0
"""Somebody out of sight is thought to walk on for so long."""


@dataclass(frozen=True, slots=True, eq=False)
class Lost:
    """Those who were let go.

    Attributes:
        people: as they were last. at_s: (people,) when.
    """

    people: Followed
    at_s: Floats

    def with_others(self, people: Followed, now_s: float) -> Lost:
        """Together with people let go now."""
        at_s = np.concatenate((self.at_s, np.full(len(people), now_s)))
        return Lost(together([self.people, people]), at_s)

    def kept(self, rows: NDArray[np.bool_]) -> Lost:
        """Some of them."""
        return Lost(self.people.select(rows), self.at_s[rows])


def found_again(lost: Lost, newcomers: Followed, now_s: float) -> NDArray[np.intp]:
    """(newcomers,) the row of the lost each of them is; -1: somebody new.

    The pair that fits best is taken first.
    """
    found = np.full(len(newcomers), -1)
    if len(lost.people) == 0 or len(newcomers) == 0:
        return found
    cost = _costs(lost, newcomers, now_s)
    while np.isfinite(cost).any():
        new, old = np.unravel_index(int(cost.argmin()), cost.shape)
        found[new] = old
        cost[new], cost[:, old] = np.inf, np.inf
    return found


def _costs(lost: Lost, newcomers: Followed, now_s: float) -> Floats:
    """(newcomers, lost) infinite where they cannot be the same."""
    gone_s = now_s - lost.at_s + lost.people.missed_s
    led_on = lost.people.mean[:, 2:] * np.minimum(gone_s, _LED_ON_S)[:, None]
    apart = newcomers.xy[:, None] - (lost.people.xy + led_on)
    reach = np.minimum(_REACH_M + _WALK_M_PER_S * gone_s, _FARTHEST_M)
    far = np.hypot(apart[..., 0], apart[..., 1]) / reach
    unlike = difference(
        newcomers.looks[:, None], newcomers.counts[:, None], lost.people.looks, lost.people.counts
    )
    return np.where((far < 1.0) & (unlike < _UNLIKE), unlike + _FAR * far, np.inf)
