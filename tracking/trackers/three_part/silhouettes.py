"""Parts that leave their places in their own silhouette, and those that are lost there."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import Clouds
from tracking.people import Detections
from tracking.people.parts import around, part_regions
from tracking.trackers.three_part.claims import Claims, seen_whole
from tracking.trackers.three_part.initiation import group_by_filter, regions_rectangles
from tracking.trackers.three_part.people import Flags, Floats, Layout, PartPeople
from tracking.tracks import HIP_LEG
from tracking.tracks.on_part import MOST_FOREIGN, corners_of, foreign_share

_LARGEST = 4.0
"""Lost is a rectangle whose area is more than so many times the inner one's, or less by that."""

_HOME_S = 0.1
"""In what time parts are drawn most of the way to where a silhouette has them."""


def legs_elsewhere(
    people: PartPeople, seen: Detections, claims: Claims, picture: NDArray[np.uint8]
) -> tuple[Flags, Floats]:
    """Whose hip-leg is not where the silhouette has its legs, and where it belongs.

    Where we go past [ZhaoLee2009]: a hip-leg that slid up the body, or grew over it, stands where
    a hip-leg may be, and on foreground. Only of people seen alone and whole. Heads and torsos are
    left to the other rules: the line between them is a few pixels off too often.

    Args:
        picture: (height, width, 3) of `ycbcr`.

    Returns:
        (people,) and (people, 4) rectangles, NaN of those who were not looked at.
    """
    rectangles = people.rectangles[:, HIP_LEG]
    off = np.zeros(len(people), bool)
    belong = np.full(rectangles.shape, np.nan)
    for row in np.flatnonzero(seen_whole(claims, seen, people.height) & ~people.hidden):
        section, inner = _legs(seen, int(claims.region[row]), picture)
        off[row] = np.isfinite(inner).all() and _is_off(rectangles[row], section, inner)
        belong[row] = inner
    return off, belong


def drawn_home(
    people: PartPeople,
    seen: Detections,
    claims: Claims,
    picture: NDArray[np.uint8],
    elapsed_s: float,
    layout: Layout,
) -> PartPeople:
    """The people with their parts drawn to where the silhouettes have them.

    Where we go past [ZhaoLee2009]: colours alone let a head slide to the neck long before anything
    can be called lost. Estimates and particles of those seen alone and whole move a share of the
    way to the inner rectangles, so that a line between parts that is off in one frame does little.

    Args:
        picture: (height, width, 3) of `ycbcr`.
    """
    rows = np.flatnonzero(seen_whole(claims, seen, people.height) & ~people.hidden)
    if not len(rows) or elapsed_s <= 0.0:
        return people
    home = regions_rectangles(seen, claims.region[rows], picture, layout)
    step = np.zeros(people.rectangles.shape)
    share = 1.0 - np.exp(-elapsed_s / _HOME_S)
    step[rows] = share * np.nan_to_num(home - people.rectangles[rows])
    step[people.cut] = 0.0
    state, clouds = people.state.copy(), people.clouds
    state[..., :4] += step
    moved = clouds.state.copy()
    moved[..., :4] += group_by_filter(step, layout)[clouds.owner].astype(np.float32)
    return people.replace(state=state, clouds=Clouds(moved, clouds.weight, clouds.start))


def _legs(seen: Detections, region: int, picture: NDArray[np.uint8]) -> tuple[Floats, Floats]:
    """(4,) corners of what is seen below the hip line, and (4,) the inner rectangle there."""
    box = seen.box[region]
    parts = part_regions(seen.regions, region + 1, picture, box)
    down, across = around(box, picture.shape)
    hip = int(np.clip(np.ceil(parts.lines[1]), down.start, down.stop))
    below = seen.regions[hip : down.stop, across] == region + 1
    columns = np.flatnonzero(below.any(axis=0)) + across.start
    if not len(columns):
        return np.full(4, np.nan), np.full(4, np.nan)
    edges = columns[0] - 0.5, parts.lines[1], columns[-1] + 0.5, box[1] + box[3]
    return np.array(edges), parts.rectangles[HIP_LEG]


def _is_off(rectangle: Floats, section: Floats, inner: Floats) -> bool:
    foreign = float(foreign_share(corners_of(rectangle), section))
    ratio = float(np.prod(rectangle[2:])) / max(float(np.prod(inner[2:])), 1e-9)
    return foreign > MOST_FOREIGN or not 1.0 / _LARGEST <= ratio <= _LARGEST
