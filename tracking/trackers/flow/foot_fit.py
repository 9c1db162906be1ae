"""How well places suit the feet seen in the foreground below tracklets.

A tracklet's *ratio* is the logarithm of how far away the feet below it stand over how far away its
body is thought to be: 0 where they are its own. Below 0 somebody nearer hides them. Above 0 the
foreground ends before it comes to where they should be: nobody is there.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_NEAREST_M = 0.1
"""Bodies nearer than this count as so far: a logarithm is taken."""
_NEAR, _FAR = 0.1, 0.2
"""Ratios up to which feet are one's own in full, and from which on they are not at all."""
_NOWHERE, _HIDDEN = 2.0, 0.7
"""What it costs a tracklet's misfit when no feet are where they should be, or they are hidden."""
_OWN = 0.06
"""Off a scale by no more than this, feet are the body's own at it."""
_SCALES = np.arange(-0.6, 0.61, 0.03)
"""Logarithms by which a body may be farther away than was thought, finer than `_OWN`."""
_NOWHERE_SHARE, _CHANGE = 0.7, 0.15
"""Against the share of feet that are one's own: of feet nowhere, and of each change of scale."""
_FEWEST, _PLENTY, _LIKELY = 8, 40, 0.5
"""Tracklets with feet below which these say nothing; those, and the share of them that are one's
own, from which on they say all they can."""
_ERROR = 0.04
"""Of what feet say then, as a share of the distance."""
_SEED_OWN, _SEED_WEIGHT, _SEED_FEWEST = 0.08, 6.0, 3
"""The same for one tracklet: ratio of own feet, weight of all feet, and how many are needed."""


def ratios(feet_m: Floats, away_m: Floats) -> Floats:
    """(...,) of feet and of bodies, m along the floor; NaN where no feet are known."""
    return np.asarray(np.log(feet_m / np.maximum(away_m, _NEAREST_M)))


def feet_misfit(ratio: Floats) -> Floats:
    """(n,) what feet add to the misfit of tracklets; 0 where they are not known."""
    ratio = np.nan_to_num(ratio)
    nowhere, hidden = (np.clip((off - _NEAR) / (_FAR - _NEAR), 0.0, 1.0) for off in (ratio, -ratio))
    return np.asarray(_NOWHERE * nowhere + _HIDDEN * hidden)


def estimate_scale(ratio: Floats) -> list[tuple[float, float]]:
    """By how much farther away a body is, as a logarithm, and its weight; nothing if unknown.

    That at which most feet are the body's own and few are nowhere: those that are hidden say
    little, so their mean, or median, would put whoever walks behind others too near.
    """
    known = ratio[np.isfinite(ratio)]
    if len(known) < _FEWEST:
        return []
    own = np.abs(known[:, None] - _SCALES) < _OWN
    share = own.mean(axis=0)
    nowhere = (known[:, None] > _SCALES + _OWN).mean(axis=0)
    best = int((share - _NOWHERE_SHARE * nowhere - _CHANGE * np.abs(_SCALES)).argmax())
    near = known[own[:, best]]
    if not len(near):
        return []
    much = min(len(near) / _PLENTY, 1.0) * min(float(share[best]) / _LIKELY, 1.0)
    return [(float(np.median(near)), much / _ERROR**2)]


def feet_cost(ratio: Floats) -> Floats:
    """(k,) what speaks against each of k distances of one tracklet, by its feet (n, k)."""
    known = ratio[np.isfinite(ratio).all(axis=1)]
    if len(known) < _SEED_FEWEST:
        return np.zeros(ratio.shape[1])
    own, nowhere = np.abs(known) < _SEED_OWN, known > _SEED_OWN
    return np.asarray(_SEED_WEIGHT * (nowhere.mean(axis=0) - own.mean(axis=0)))
