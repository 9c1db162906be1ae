"""People whose bodies merge seen from above, told apart by their heads."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.people.plan_view import SurfacePoints, apart
from tracking.people.settings import PeopleSettings

Floats = NDArray[np.float32]

_SPREAD_M = 0.19
"""Bodies seen from above that spread farther from their middle than this may be two."""
_LOWEST_HEAD_M = 1.1
"""Children's are no lower; hands and bags mostly are."""
_HEAD_M = 0.22
"""How high a head is."""
_HEAD_RADIUS_M = 0.13
"""With hair and the noise of range."""
_APART_M = 0.3
"""Heads are no nearer to each other."""
_HEAD_AREA_M2 = 0.01
"""Surface a head shows at the least: less than half of one seen from above."""
_VALLEY_M = 0.1
"""Between two heads what is seen is lower by this than the lower one, or is not there."""
_BODY_SHARE = 0.2
"""Each head has this share of what is seen nearer to it than to the other."""
_MOST_HEADS = 4
"""So many people are told apart at one place."""
_TRIMMED = 0.03
"""Share of the highest points that are taken for noise."""
_FEWEST = 15
"""Points that no head has yet, in which another one is looked for."""


def split_by_heads(
    places: Floats,
    owner: NDArray[np.intp],
    points: SurfacePoints,
    camera_xy: Floats,
    settings: PeopleSettings,
) -> Floats:
    """(k, 2) the places, those over which several heads rise replaced by one a head.

    Shoulders and arms close the gaps between people who walk side by side; heads keep off each
    other.

    Args:
        places: (n, 2) m. owner: whose each point is, of `assign_points`.
        points: of the frame. camera_xy: (2,) m, the floor point below the camera.
        settings: of people.
    """
    found = [places[k : k + 1] for k in range(len(places))]
    for k in np.flatnonzero(_spreads(len(places), owner, points) > _SPREAD_M**2).tolist():
        own = (owner == k) & (points.world[:, 2] > settings.min_point_height_m)
        heads = _heads(points.chosen(np.flatnonzero(own)), camera_xy)
        if len(heads) > 1:
            found[k] = np.array(heads, np.float32)
    return np.concatenate(found) if found else places


def _spreads(count: int, owner: NDArray[np.intp], points: SurfacePoints) -> Floats:
    """(count,) m² how far the upper bodies of each place spread, less the noise of range."""
    rows = np.flatnonzero((points.world[:, 2] > _LOWEST_HEAD_M) & (owner >= 0))
    whose, mass, noise = owner.take(rows), points.mass.take(rows), points.range_noise.take(rows)
    x, y, _ = points.world.take(rows, axis=0).T
    total = np.maximum(np.bincount(whose, mass, count), 1e-9)
    middle = np.array([np.bincount(whose, mass * values, count) / total for values in (x, y)])
    squared = x**2 + y**2 - noise**2
    spread = np.bincount(whose, mass * squared, count) / total - (middle**2).sum(axis=0)
    return np.asarray(spread, np.float32)


def _heads(points: SurfacePoints, camera_xy: Floats) -> list[Floats]:
    """Where heads with bodies under them rise over the points of one place."""
    high = points.chosen(np.flatnonzero(points.world[:, 2] > _LOWEST_HEAD_M))
    free = high.mass == high.area
    heads: list[Floats] = []
    tops: list[float] = []
    while np.count_nonzero(free) >= _FEWEST and len(heads) < _MOST_HEADS:
        found = _highest(high, free, camera_xy)
        if found is None:
            break
        place, top = found
        if all(_is_another(place, top, other, high, camera_xy) for other in heads):
            heads.append(place)
            tops.append(top)
        free &= apart(place[None], high.world[:, :2], high.range_noise, camera_xy, _APART_M)[0] > 1
    return [heads[k] for k in _with_bodies(heads, points, camera_xy)]


def _highest(
    points: SurfacePoints, free: NDArray[np.bool_], camera_xy: Floats
) -> tuple[Floats, float] | None:
    """Place and height of the highest head among the free points; None: what is there is none."""
    z = points.world[free, 2]
    top = float(np.sort(z)[-1 - int(_TRIMMED * len(z))])
    crown = free & (points.world[:, 2] > top - _HEAD_M)
    highest = free & (points.world[:, 2] >= top - _HEAD_M / 4)
    place = np.asarray(points.world[highest, :2].mean(axis=0), np.float32)
    for _ in range(2):
        xy, noise = points.world[:, :2], points.range_noise
        near = crown & (apart(place[None], xy, noise, camera_xy, _HEAD_RADIUS_M)[0] < 1)
        if float(points.area[near].sum()) < _HEAD_AREA_M2:
            return None
        area = points.area[near]
        place = np.asarray(area @ xy[near] / area.sum(), np.float32)
    return place, top


def _is_another(
    place: Floats, top: float, other: Floats, points: SurfacePoints, camera_xy: Floats
) -> bool:
    """Whether a head is somebody else's than another one: apart from it, and lower between."""
    noise = points.range_noise
    usual = np.median(noise, keepdims=True)
    if apart(other[None], place[None], usual, camera_xy, _APART_M)[0, 0] < 1:
        return False
    middle = np.asarray((place + other)[None] / 2, np.float32)
    between = apart(middle, points.world[:, :2], noise, camera_xy, _HEAD_RADIUS_M / 2)[0] < 1
    if np.count_nonzero(between) < 3:
        return True
    return float(np.quantile(points.world[between, 2], 0.9)) < top - _VALLEY_M


def _with_bodies(heads: list[Floats], points: SurfacePoints, camera_xy: Floats) -> list[int]:
    """Which of the heads have a body under them."""
    if len(heads) < 2:
        return list(range(len(heads)))
    squared = apart(
        np.array(heads, np.float32), points.world[:, :2], points.range_noise, camera_xy, 1.0
    )
    area = np.bincount(squared.argmin(axis=0), points.area, len(heads))
    return np.flatnonzero(area > _BODY_SHARE * area.sum()).tolist()
