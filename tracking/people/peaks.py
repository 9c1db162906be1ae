"""Peaks of a line, and how far they rise."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def peaks_of(line: Floats, least: float) -> tuple[NDArray[np.intp], Floats]:
    """Where a line is higher than on either side, and how far it rises there.

    The same as `scipy.signal.find_peaks`, whose import takes longer than that of all the rest.

    Args:
        line: (n,) heights.
        least: peaks that rise less are left out; above 0.

    Returns:
        (peaks,) columns, of a flat top the middle one; (peaks,) prominences: the way down to the
        higher one of the lowest places that lie between the peak and what is higher than it.
    """
    ends = np.append((line[1:] != line[:-1]).nonzero()[0], len(line) - 1)
    level: list[float] = line[ends].tolist()  # of stretches that are level
    tops, rises = [], []
    for at in range(1, len(level) - 1):
        if level[at - 1] < level[at] > level[at + 1]:
            rise = level[at] - max(_lowest(level, at, -1), _lowest(level, at, 1))
            if rise >= least:
                tops.append(at)
                rises.append(rise)
    top = np.array(tops, np.intp)
    return (ends[top - 1] + 1 + ends[top]) // 2, np.array(rises, np.float64)


def _lowest(level: list[float], top: int, step: int) -> float:
    """The lowest place on the way from a peak to one side, as far as nothing is higher than it."""
    peak = lowest = level[top]
    for height in level[top + step :: step]:
        if height > peak:
            break
        if height < lowest:
            lowest = height
    return lowest
