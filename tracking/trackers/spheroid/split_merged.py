"""Two people who came in close together and are followed as one: the second is recovered."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import Ellipses, FlatView, standing_ellipses
from tracking.trackers.spheroid.hypotheses import SpheroidPeople
from tracking.trackers.spheroid.hypothesis_scores import JudgedFrame, bounds, count_covering
from tracking.trackers.spheroid.settings import SpheroidSettings
from tracking.trackers.spheroid.weights import axes_of, silhouettes

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
_ACROSS = 40
"""Samples of the picture along the longer side about somebody."""


def split_merged(
    people: SpheroidPeople,
    rows: NDArray[np.intp],
    judged: JudgedFrame,
    flat: FlatView,
    tallest_m: float,
    settings: SpheroidSettings,
) -> tuple[SpheroidPeople, Floats]:
    """The people, each at one place if there are two in his, and states (n, 4) of the others.

    Args:
        rows: of those who are looked at. judged: with everybody's silhouettes as cover.
        tallest_m: heights beyond are not trusted, they may be those of two.
    """
    own = silhouettes(people, flat, settings)
    axes = axes_of(people, settings)
    mean, state, found = people.mean.copy(), people.state.copy(), []
    for row in rows:
        others = judged.cover - count_covering(judged.cover.shape, own[row : row + 1])
        free = judged.counted & (others == 0)
        height_m = min(float(people.height[row]), tallest_m)
        both = two_places(judged.ramp, free, flat, axes[row], height_m, settings.radius_m)
        if both is None or _is_near(both[1], np.delete(axes, row, axis=0)):
            continue
        own_m, other_m = both - axes[row]
        state[row, :, :2] += own_m.astype(np.float32)
        found.append(mean[row] + (*other_m, 0.0, 0.0))
        mean[row, :2] += own_m
    return people.replace(mean=mean, state=state), np.array(found).reshape(-1, 4)


def _is_near(place: Floats, xy: Floats) -> bool:
    return bool((np.hypot(*(xy - place).T) < _APART_M).any())


def two_places(
    ramp: NDArray[np.uint8],
    free: NDArray[np.bool_],
    flat: FlatView,
    xy: Floats,
    height_m: float,
    radius_m: float,
) -> Floats | None:
    """(2, 2) m where two people stand if they explain much more than one, the nearer first.

    A spheroid between two people explains so much of both that neither is missed: all pairs of
    places about it are tried. None if one person explains it all.

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
    both = places[[one, other]]
    return np.asarray(both[np.argsort(np.hypot(*(both - xy).T))])


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
    inside = _is_inside(outlines, np.arange(left, right, step), np.arange(top, bottom, step))
    both = (inside * value) @ inside.T
    one = np.diag(both)
    scale = step**2 / float(np.median(outlines.areas()))
    gain = (one[:, None] + one[None] - both) * scale
    np.fill_diagonal(gain, one * scale)
    return gain, places


def _is_inside(outlines: Ellipses, u: Floats, v: Floats) -> Floats:
    """(n, lines * columns) 1 where pixels lie in each outline, else 0."""
    begin, end = outlines.ends(np.broadcast_to(v.astype(float), (len(outlines.u), len(v))))
    with np.errstate(invalid="ignore"):
        inside = (u >= begin[..., None]) & (u <= end[..., None])
    return inside.reshape(len(outlines.u), -1).astype(np.float64)
