"""What the foreground says of where people are: bodies that fill it from head to feet."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.trackers.flow.floor import Floor, sight_axes
from tracking.trackers.flow.half_resolution import half_size

Floats = NDArray[np.float64]
Mask = NDArray[np.uint8]
Cover = NDArray[np.float32]

USUAL_HEIGHT_M = 1.70
SHADE, BODY = 1, 2
"""Values of a mask of the foreground. Plain grey clothes look like shadow."""

_BODY = np.array(
    (
        *((0.0, 1.62, 0.0, 1.5), (-0.05, 1.52, 0.0, 1.0), (0.05, 1.52, 0.0, 1.0)),
        *((0.0, 1.35, 0.0, 1.0), (-0.12, 1.35, 0.0, 1.0), (0.12, 1.35, 0.0, 1.0)),
        *((0.0, 1.15, 0.0, 1.0), (-0.16, 1.15, 0.0, 1.0), (0.16, 1.15, 0.0, 1.0)),
        *((0.0, 0.9, 0.0, 1.0), (-0.12, 0.9, 0.0, 1.0), (0.12, 0.9, 0.0, 1.0)),
        *((0.0, 0.65, 0.0, 1.0), (-0.08, 0.4, 0.0, 1.0), (0.08, 0.4, 0.0, 1.0)),
        *((-0.06, 0.12, 0.12, 2.0), (0.06, 0.12, 0.12, 2.0), (0.0, 0.03, 0.12, 2.5)),
    )
)
"""Spots of a body: m across the sight, over the floor, nearer than the axis; how much they tell.

The lowest that is seen of walkers is the shoe in front: feet on the axis put them too near."""
_BESIDE = np.array(
    (
        *((0.0, 1.87, 0.0, 1.5), (-0.08, 1.92, 0.0, 1.0), (0.08, 1.92, 0.0, 1.0)),
        *((-0.42, 1.2, 0.0, 0.7), (0.42, 1.2, 0.0, 0.7)),
        *((-0.42, 0.7, 0.0, 0.7), (0.42, 0.7, 0.0, 0.7)),
        *((0.0, 0.0, 0.3, 1.0), (-0.1, 0.0, 0.38, 1.0), (0.1, 0.0, 0.38, 1.0)),
        *((-0.06, 0.0, 0.6, 1.0), (0.06, 0.0, 0.6, 1.0), (0.0, 0.0, 0.9, 1.0)),
    )
)
"""Spots where a body is not: over the head, at the sides, on the floor before the feet."""
_SPOTS = np.concatenate((_BODY, _BESIDE))
_OUTLINE = ((-0.1, 1.78), (-0.22, 1.5), (-0.2, 0.8), (-0.12, 0.0))
"""Half the outline of a body that hides what is behind it: m across the sight, over the floor."""
_FARTHEST_PX = 1e4
_AHEAD_M = 0.25
"""Who is so much nearer stands before a body."""
_BESIDE_WEIGHT = 0.8
_ONE, _FOREIGN_WEIGHT = np.float32(1.0), np.float32(0.25)
_FILLED = np.array((0.0, 0.75, 1.0), np.float32)
"""How well a body is filled by what is no foreground, may be shadow, is foreground."""
_SOLID = np.array((0.0, 0.0, 1.0), np.float32)
_BODY_TELLS, _BESIDE_TELLS = _BODY[:, 3].astype(np.float32), _BESIDE[:, 3].astype(np.float32)
_SAME_M = 1e-3
_ALONG = np.linspace(-0.12, 0.12, 7)
_ACROSS_M = np.array([-0.16, -0.08, 0.0, 0.08, 0.16])
"""Places that are tried round the one believed: as shares of the distance, and in m."""
_FAR_ALONG = np.concatenate((np.linspace(-0.4, 0.0, 8)[:-1], np.linspace(0.0, 0.7, 9)))
_FAR_ACROSS_M = np.array([-0.2, 0.0, 0.2])
_POOR, _CLEARLY = 0.85, 0.1
"""Whose body suits no better is looked for farther off, and taken there if it suits it clearly."""
_SHARPNESS = 24.0
_LEAST_ERROR_M = 0.08
_LEAST_SEEN = 0.18


@dataclass(frozen=True, slots=True, eq=False)
class Pixels:
    """Pixels of the mask and the cover: of k bodies, j each.

    Attributes:
        at: (k, j) their number in the flattened picture. inside: (k, j) whether they are in it.
    """

    at: NDArray[np.intp]
    inside: NDArray[np.bool_]

    def of(self, spots: slice) -> Pixels:
        """Those of some of the spots."""
        return Pixels(self.at[:, spots], self.inside[:, spots])


@dataclass(frozen=True, slots=True, eq=False)
class SilhouetteScore:
    """How well bodies suit the foreground.

    Attributes:
        score: (...,) share of the body in the foreground less most of that beside it.
        seen: (...,) share of the body that nobody nearer hides, and that is in the picture.
        own: (...,) share of what is seen of it that is in the foreground and explained by nobody.
    """

    score: Floats
    seen: Floats
    own: Floats


@dataclass(frozen=True, slots=True, eq=False)
class SilhouetteFit:
    """Where the foreground draws people.

    Attributes:
        place: (m, 2) m; NaN where it cannot tell. error_m: (m, 2) along and across the sight.
        score: (m,) of the best place; NaN where too little of the body is in sight.
    """

    place: Floats
    error_m: Floats
    score: Floats


def draw_cover(place: Floats, floor: Floor) -> Cover:
    """(rows, columns) how far away, in m, the nearest of the people stands that hides a pixel.

    Infinite where there is nobody. At half resolution.

    Args:
        place: (m, 2) m.
    """
    columns, rows = half_size(floor.view.camera.size)
    cover = np.full((rows, columns), np.inf, np.float32)
    if not len(place):
        return cover
    left = np.array(_OUTLINE)
    half = np.concatenate((left, left[::-1] * (-1.0, 1.0)))
    outline = spot_pixels(place, np.column_stack((half, np.zeros(len(half)))), floor) / 2
    distance = np.hypot(place[:, 0], place[:, 1])
    drawable = np.asarray((np.abs(outline) < _FARTHEST_PX).all(axis=(1, 2)))  # NaN: not
    corners = np.rint(np.where(drawable[:, None, None], outline, 0.0)).astype(np.int32)
    for person in np.argsort(-distance, kind="stable"):
        if drawable[person]:
            cv2.fillConvexPoly(cover, corners[person], float(distance[person]))
    return cover


def score_silhouettes(
    place: Floats, mask: Mask, cover: Cover, floor: Floor, own: Floats | None = None
) -> SilhouetteScore:
    """How well bodies at places (k, 2) suit the foreground.

    What is hidden by somebody nearer does not count, nor what lies beside the body and is
    explained by somebody else; the foreground of somebody farther away counts little.

    Args:
        mask: (rows, columns) `SHADE` where the foreground may be shadow, `BODY` where not, at half
            resolution.
        own: (k,) how far away they stand themselves in the cover; None: they are not in it.
    """
    distance = np.hypot(place[:, 0], place[:, 1])[:, None].astype(np.float32)
    pixels = _half_pixels(spot_pixels(place, _SPOTS, floor), floor.view.camera.size)
    body, beside = pixels.of(slice(len(_BODY))), pixels.of(slice(len(_BODY), None))
    seen, nearest = _sample(mask, cover, body)
    free = np.isinf(nearest) | _is_same(nearest, own)
    hidden = (nearest < distance - _AHEAD_M) & ~free
    open_ = (body.inside & ~hidden) * _BODY_TELLS
    filled = _share(_FILLED[seen], open_ * np.where(free, _ONE, _FOREIGN_WEIGHT))
    around, owner = _sample(mask, cover, beside)
    unclaimed = beside.inside & (np.isinf(owner) | _is_same(owner, own))
    overflow = _share(_SOLID[around], unclaimed * _BESIDE_TELLS)
    return SilhouetteScore(
        filled - _BESIDE_WEIGHT * overflow,
        (body.inside & free).mean(axis=1),
        _share(_SOLID[seen] * free, open_),
    )


def _is_same(nearest: Cover, own: Floats | None) -> NDArray[np.bool_]:
    """Where the person in the cover is the one looked for."""
    if own is None:
        return np.zeros(nearest.shape, bool)
    return np.asarray(np.abs(nearest - own[:, None]) < _SAME_M)


def fit_silhouettes(place: Floats, mask: Mask, cover: Cover, floor: Floor) -> SilhouetteFit:
    """Where people believed at places (m, 2) are, by the foreground near there.

    Bodies are tried on a small grid along and across the line of sight; the mean of the places,
    weighed by how well they suit, is where somebody is drawn to, and how far they spread is how
    little that says: in the middle of a crowd, nothing.
    """
    near = _search_grid(place, _ALONG, _ACROSS_M, mask, cover, floor)
    poor = np.flatnonzero((near.score < _POOR) & np.isfinite(near.place).all(axis=1))
    if not len(poor):
        return near
    far = _search_grid(place[poor], _FAR_ALONG, _FAR_ACROSS_M, mask, cover, floor)
    better = far.score > near.score[poor] + _CLEARLY
    rows = poor[better]
    near.place[rows], near.error_m[rows] = far.place[better], far.error_m[better]
    near.score[rows] = far.score[better]
    return near


def _search_grid(
    place: Floats, along: Floats, across: Floats, mask: Mask, cover: Cover, floor: Floor
) -> SilhouetteFit:
    """`fit_silhouettes` over a grid: along as shares of the distance, across in m."""
    people = len(place)
    axes = sight_axes(place)
    distance = np.maximum(np.hypot(place[:, 0], place[:, 1]), 1.0)
    along, across = (grid.ravel() for grid in np.meshgrid(along, across))
    off = np.stack(
        (along * distance[:, None], np.broadcast_to(across, (people, len(across)))), axis=-1
    )
    tried = place[:, None] + np.einsum("mki,mij->mkj", off, axes)
    own = np.repeat(np.hypot(place[:, 0], place[:, 1]), off.shape[1])
    fit = score_silhouettes(tried.reshape(-1, 2), mask, cover, floor, own)
    score = fit.score.reshape(people, -1)
    weight = np.exp(_SHARPNESS * (score - score.max(axis=1, keepdims=True)))
    weight /= weight.sum(axis=1, keepdims=True)
    mean = np.einsum("mk,mki->mi", weight, off)
    spread = np.einsum("mk,mki->mi", weight, (off - mean[:, None]) ** 2)
    known = (fit.seen.reshape(people, -1).mean(axis=1) > _LEAST_SEEN)[:, None]
    where = place + np.einsum("mi,mij->mj", mean, axes)
    error = np.sqrt(_LEAST_ERROR_M**2 + 2 * spread)
    return SilhouetteFit(
        np.where(known, where, np.nan),
        np.where(known, error, np.nan),
        np.where(known[:, 0], score.max(axis=1), np.nan),
    )


def spot_pixels(place: Floats, spots: Floats, floor: Floor) -> Floats:
    """(k, j, 2) px of spots (j, 3), see `_BODY`, of people at places (k, 2)."""
    axes = sight_axes(place)
    level = place[:, None] + axes[:, None, 1] * spots[:, :1] - axes[:, None, 0] * spots[:, 2:3]
    return floor.pixels(level, spots[:, 1])


def _half_pixels(pixels: Floats, size: tuple[int, int]) -> Pixels:
    """Pixels (k, j, 2) of a picture of that width and height, at half resolution."""
    columns, rows = half_size(size)
    whole = np.fmin(np.fmax(pixels * 0.5, -9.0), 30000.0).astype(np.int32)  # NaN becomes -9
    u, v = whole[..., 0], whole[..., 1]
    inside = (u >= 0) & (v >= 0) & (u < columns) & (v < rows)
    return Pixels(np.where(inside, v * columns + u, 0).astype(np.intp), inside)


def _sample(mask: Mask, cover: Cover, pixels: Pixels) -> tuple[Mask, Cover]:
    """The mask and the cover at pixels; what lies outside the picture means nothing."""
    return mask.ravel()[pixels.at], cover.ravel()[pixels.at]


def _share(hit: NDArray[np.float32], weight: NDArray[np.float32]) -> Floats:
    """(k,) the share of the weight (k, j) that is hit; 0 where there is none."""
    total = np.einsum("kj,kj->k", hit, weight)
    return np.asarray(total / np.maximum(weight.sum(axis=1), 1e-9), np.float64)
