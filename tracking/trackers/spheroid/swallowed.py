"""Two people who came in close together and are followed as one: the second is found again."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import Ellipses, FlatView, standing_ellipses
from tracking.trackers.spheroid.followed import Followed
from tracking.trackers.spheroid.judging import bounds

Floats = NDArray[np.float64]

_STEP_M, _STEPS = 0.2, 4
"""Of the net of places about somebody where two may stand."""
_APART_M = 0.5
"""Two who stand closer than that cannot be told from one."""
_BALANCE = 0.35
"""B from which on a pixel speaks for people, below against."""
_GAIN = 0.04
"""What two explain more than one, less what speaks against them, over a silhouette's size."""
_SLIM = 0.72
"""Slimmer than spheroids usually are: two slim bodies explain what is between two people worst."""
_YOUNG_S = 2.0
_GROWN_M = 0.03
"""Who is younger, or so much taller than usual, may be two."""
_ACROSS = 40
"""Samples of the picture along the longer side about somebody."""


def suspected(people: Followed, usual_m: float) -> NDArray[np.intp]:
    """Rows of those who may be two: newcomers, and spheroids that grew to cover both."""
    grown = people.height > usual_m + _GROWN_M
    return np.flatnonzero((people.age_s < _YOUNG_S) | grown)


def second_place(
    ramp: NDArray[np.uint8],
    free: NDArray[np.bool_],
    flat: FlatView,
    xy: Floats,
    height_m: float,
    radius_m: float,
) -> Floats | None:
    """Where a second person stands, m, if two explain much more than one; else None.

    A spheroid between two people explains so much of both that neither is missed: all pairs of
    places about it are tried.

    Args:
        ramp: (height, width) uint8, B times 255. free: (height, width) pixels that prove anything:
            behind nothing and nobody else.
        xy: (2,) m where somebody is followed.
    """
    gain, places = pair_gains(ramp, free, flat, xy, height_m, radius_m)
    if len(places) == 0:
        return None
    alone = float(np.diag(gain).max())
    apart = np.hypot(*(places[:, None] - places[None]).transpose(2, 0, 1))
    pairs = np.where(apart >= _APART_M, gain, -np.inf)
    one, other = np.unravel_index(int(pairs.argmax()), pairs.shape)
    if not pairs[one, other] - alone > _GAIN:
        return None
    away = np.hypot(*(places[[one, other]] - xy).T)
    return np.asarray(places[(one, other)[int(away.argmax())]])


def pair_gains(
    ramp: NDArray[np.uint8],
    free: NDArray[np.bool_],
    flat: FlatView,
    xy: Floats,
    height_m: float,
    radius_m: float,
) -> tuple[Floats, Floats]:
    """(n, n) what people at two places explain, in silhouettes; and the places (n, 2) m.

    On the diagonal stands what one explains. A sum over the union of two silhouettes is that over
    both less that over what they share, so that one product of matrices says all.
    """
    side = np.arange(-_STEPS, _STEPS + 1) * _STEP_M
    offset = np.stack(np.meshgrid(side, side), axis=-1).reshape(-1, 2)
    places = xy + offset[np.hypot(*offset.T) <= _STEPS * _STEP_M]
    outlines = standing_ellipses(
        flat.projection, places, np.full(len(places), height_m), _SLIM * radius_m
    )
    known = np.isfinite(outlines.areas())
    places, outlines = places[known], outlines[known]
    if len(places) == 0:
        return np.zeros((0, 0)), places
    (left,), (top,), (right,), (bottom,) = bounds(outlines[None], ramp.shape)
    step = max(1, int(max(right - left, bottom - top) // _ACROSS))
    part = np.s_[top:bottom:step, left:right:step]
    value = np.where(free[part], ramp[part] / 255.0 - _BALANCE, 0.0).ravel()
    inside = _held(outlines, np.arange(left, right, step), np.arange(top, bottom, step))
    both = (inside * value) @ inside.T
    one = np.diag(both)
    scale = step**2 / float(np.median(outlines.areas()))
    gain = (one[:, None] + one[None] - both) * scale
    np.fill_diagonal(gain, one * scale)
    return gain, places


def _held(outlines: Ellipses, u: Floats, v: Floats) -> Floats:
    """(n, lines * columns) 1 where pixels lie in each outline, else 0."""
    begin, end = outlines.ends(np.broadcast_to(v.astype(float), (len(outlines.u), len(v))))
    with np.errstate(invalid="ignore"):
        inside = (u >= begin[..., None]) & (u <= end[..., None])
    return inside.reshape(len(outlines.u), -1).astype(np.float64)
