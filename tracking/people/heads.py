"""Heads as peaks of a silhouette's upper contour."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.people.body_scale import Bodies, Standing
from tracking.people.silhouette_split import placed

Bools = NDArray[np.bool_]

_RISES = 0.045
_RISES_UNKNOWN = 0.07
"""A head rises over the valleys beside it by this share of the person's height at least; by more
where that height is only guessed at."""
_APART = 0.4
"""Heads are this many breadths of a person off other people's axes at least."""
_REACHES_DOWN = 0.5
"""Under a head a body is seen for this share of its height at least."""
_HEAD_WIDTH, _HEAD_REACH = 0.055, 0.06
_HEAD_ROWS = (0.03, 0.09)
"""Between these rows under its top a head is so broad at least, within reach of the peak; a raised
hand is not. All as shares of the height."""


def bodies_in(own: Bools, left: int, top: int, standing: Standing) -> Bodies:
    """The bodies whose heads rise over a silhouette's contour, one at least.

    Args:
        own: (height, width) the silhouette in its box.
        left, top: of the box, working px.
        standing: sizes of people.
    """
    contour = np.where(own.any(axis=0), own.argmax(axis=0), own.shape[0]).astype(np.float64)
    padded = np.concatenate(([own.shape[0]], contour, [own.shape[0]])).astype(np.float64)
    peaks, rises = peaks_of(-padded, 1.0)
    columns = np.clip(peaks - 1, 0, own.shape[1] - 1)
    head = np.column_stack((columns + left, contour[columns] + top)).astype(np.float64)
    bodies = standing.below(head, lowest(own, columns) + float(top))
    share = _RISES if standing.calibrated else _RISES_UNKNOWN
    good = rises >= share * bodies.height
    good &= _broad(own, columns, contour, bodies.height * bodies.stretch)
    seen = lowest(own, columns) - contour[columns]
    good &= seen >= _REACHES_DOWN * bodies.height
    if not good.any():
        good[contour[columns].argmin()] = True
    rows = np.flatnonzero(good)
    downwards = rows[np.argsort(contour[columns[rows]], kind="stable")]
    return bodies.chosen(_distinct(bodies, downwards, standing))


def lowest(own: Bools, columns: NDArray[np.intp]) -> Floats:
    """(n,) the lowest row of the silhouette near each column."""
    reach = max(2, own.shape[0] // 12)
    low = own.shape[0] - 1 - own[::-1].argmax(axis=0)
    low = np.where(own.any(axis=0), low, 0)
    near = [low[max(u - reach, 0) : u + reach + 1].max() for u in columns.tolist()]
    return np.array(near, np.float64) + 1


def _broad(own: Bools, columns: NDArray[np.intp], contour: Floats, height: Floats) -> Bools:
    """Which peaks are as broad as a head somewhere near their tops; hair may have holes."""
    found = []
    for u, v, h in zip(columns.tolist(), contour[columns].tolist(), height.tolist(), strict=True):
        first, stop = (int(v + share * h) for share in _HEAD_ROWS)
        reach = int(_HEAD_REACH * h) + 1
        near = own[first : max(stop, first + 2), max(u - reach, 0) : u + reach + 1]
        found.append(near.sum(axis=1).max(initial=0) >= _HEAD_WIDTH * h)
    return np.array(found, np.bool_)


def _distinct(bodies: Bodies, order: NDArray[np.intp], standing: Standing) -> NDArray[np.intp]:
    """Of the bodies in order those whose heads are on no body kept before.

    Seen from high up bodies lean outwards: an elbow or a hip then peaks beside its own head.
    """
    kept: list[int] = []
    for k in order.tolist():
        if not kept or _is_another(bodies, k, bodies.chosen(np.array(kept)), standing):
            kept.append(k)
    return np.array(kept, np.intp)


def _is_another(bodies: Bodies, k: int, kept: Bodies, standing: Standing) -> bool:
    """Whether body k is somebody else than the bodies kept."""
    across = placed(bodies.head[k, :1], bodies.head[k, 1:], kept).across[0]
    if across < _APART:
        return False
    one = bodies.chosen(np.array([k]))
    return bool((one.away_from(kept) if standing.calibrated else one.as_tall_as(kept))[0])


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
