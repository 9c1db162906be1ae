"""Curves through what was measured of many tracks at once, from the past and the future.

This is fixed-interval smoothing (H. E. Rauch, F. Tung, C. T. Striebel: Maximum Likelihood
Estimates of Linear Dynamic Systems, 1965), robust by weights that are found again in rounds
(S. Geman, D. E. McClure: Statistical Methods for Tomographic Image Reconstruction, 1987).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import solveh_banded

from tracking.arrays import Floats

_ROUNDS = 3
"""After so many rounds the weights of outliers hardly change."""
_LEAST_WEIGHT = 1e-9
"""Of every row, so that a track without any weight has one curve too."""


@dataclass(frozen=True, slots=True)
class Chains:
    """Tracks one behind the other, each sorted by frame.

    Attributes:
        frame, track: (n,) of each row.
    """

    frame: NDArray[np.integer]
    track: NDArray[np.integer]

    @property
    def steps(self) -> Floats:
        """(n - 1,) frames from each row to the next; NaN where the next track begins."""
        step = np.diff(self.frame).astype(np.float64)
        return np.where(np.diff(self.track) == 0, step, np.nan)


def smooth_levels(values: Floats, weight: Floats, chains: Chains, memory: float) -> Floats:
    """Levels (n,) that change little: the least sum of squared misses and squared changes.

    Args:
        values: (n,) measured. weight: (n,) from 0, not measured, to 1.
        memory: frames over which a change is spread.

    What Rauch, Tung and Striebel's smoother gives for a random walk, as one banded system.
    """
    steps = chains.steps
    stiffness = np.nan_to_num(memory**2 / steps)
    band = np.zeros((2, len(values)))
    band[0] = np.maximum(weight, _LEAST_WEIGHT)
    right = band[0] * values
    band[0, :-1] += stiffness
    band[0, 1:] += stiffness
    band[1, :-1] = -stiffness
    return np.asarray(solveh_banded(band[: len(values)], right, lower=True))


def smooth_paths(values: Floats, weight: Floats, chains: Chains, memory: float) -> Floats:
    """Paths (n, k) whose velocity changes little; cubic where nothing is measured.

    Args:
        values: (n, k) measured. weight: (n,) from 0, not measured, to 1.
        memory: frames over which a turn is spread.

    What Rauch, Tung and Striebel's smoother gives for a velocity that is a random walk, changed
    at the rows only, as one banded system.
    """
    count = len(values)
    values = _bridged(values, weight, chains)
    steps = chains.steps
    before, after = 1.0 / steps[:-1], 1.0 / steps[1:]
    bend = np.stack((before, -before - after, after)) * memory**2
    bend = np.nan_to_num(bend * np.sqrt(2.0 / (steps[:-1] + steps[1:])))
    band = np.zeros((3, count))
    band[0] = np.maximum(weight, _LEAST_WEIGHT)
    right = band[0][:, None] * values
    for first in range(3):
        for second in range(first, 3):
            product = bend[first] * bend[second]
            band[second - first, first : first + len(product)] += product
    return np.asarray(solveh_banded(band[:count], right, lower=True))


def _bridged(values: Floats, weight: Floats, chains: Chains) -> Floats:
    """Rows that are not measured on the straight line between the measured ones beside them.

    Their least weight then pulls nowhere. Rows beyond a track's first or last measured one take
    that one's value; a track without any keeps its values.
    """
    rows = np.arange(len(values))
    known = weight > _LEAST_WEIGHT
    before = np.maximum.accumulate(np.where(known, rows, 0))
    after = np.minimum.accumulate(np.where(known, rows, len(rows) - 1)[::-1])[::-1]
    has_before = known[before] & (chains.track[before] == chains.track)
    has_after = known[after] & (chains.track[after] == chains.track)
    before, after = np.where(has_before, before, after), np.where(has_after, after, before)
    length = np.maximum(chains.frame[after] - chains.frame[before], 1)
    share = ((chains.frame - chains.frame[before]) / length)[:, None]
    line = values[before] * (1.0 - share) + values[after] * share
    return np.where((known | ~(has_before | has_after))[:, None], values, line)


def trust(misses: Floats, scale: Floats | float) -> Floats:
    """1 for a value on its curve, towards 0 for outliers: the weights of Geman and McClure."""
    return np.asarray(1.0 / (1.0 + (misses / scale) ** 2) ** 2)


def robust_levels(
    values: Floats, weight: Floats, chains: Chains, memory: float, scale: float
) -> Floats:
    """`smooth_levels` that leaves out values which miss the level by much more than `scale`."""
    level = smooth_levels(values, weight, chains, memory)
    for _ in range(_ROUNDS):
        level = smooth_levels(values, weight * trust(values - level, scale), chains, memory)
    return level


def robust_paths(
    values: Floats, weight: Floats, chains: Chains, memory: float, scale: Floats
) -> Floats:
    """`smooth_paths` that leaves out places off the path by much more than `scale` (n,)."""
    path = smooth_paths(values, weight, chains, memory)
    for _ in range(_ROUNDS):
        miss = np.hypot(*(values - path).T)
        path = smooth_paths(values, weight * trust(miss, scale), chains, memory)
    return path


def slopes(path: Floats, chains: Chains) -> Floats:
    """Change a frame along paths (n, k); NaN for a track of a single row."""
    slope = np.diff(path, axis=0) / chains.steps[:, None]
    ends = np.full((1, path.shape[1]), np.nan)
    behind, ahead = np.concatenate((ends, slope)), np.concatenate((slope, ends))
    both = np.isfinite(behind) & np.isfinite(ahead)
    one = np.where(np.isfinite(behind), behind, ahead)
    return np.asarray(np.where(both, (behind + ahead) / 2, one))
