"""From the foreground of one camera to a region a person."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.people.body_scale import Bodies, Standing, nobody
from tracking.people.heads import bodies_in, lowest
from tracking.people.silhouette_split import placed
from tracking.people.silhouettes import Box, Labels, silhouettes
from tracking.people.upright import SHADOW, body_pixels

_LEAST_HEIGHT = 1 / 16
"""Of the picture, where nothing is known in metres: what is lower is nobody."""
_LEAST_SHARE = 0.35
"""Of a standing person's height, where it is known: people may crouch."""
_LEAST_FILL = 0.1
"""Of the square over a person's height, that the person's pixels cover at least."""
_ABOVE = 0.1
"""Of a body's height, that hair may reach above what was first seen of it."""
_UNEXPLAINED = 1.13
"""Pixels so far down a body, its height being 1, belong to somebody who stands nearer."""
_NEARER_FILL = 0.03
"""Of the square over the nearer person's height, that those pixels cover at least."""
_MOST_NEARER = 2
_MOST_PEOPLE = 120
"""Where more seem to be, what is seen is noise."""
_BODY_AREA = 0.19
"""Pixels of a body over the square over its height."""
_LEAST_SEEN = 0.22
"""Share of a body that must be seen."""
_LIMB_AREA, _LIMB_ACROSS, _LIMB_INSIDE = 0.3, 1.1, 0.6
"""A fragment is a limb if it is smaller than this share of a body and this share of it lies within
so many breadths of the body's axis."""


@dataclass(frozen=True, slots=True)
class Silhouette:
    """A silhouette and the bodies in it.

    Attributes:
        label: its pixels' in the picture of labels.
        box: left, top, width, height in working px.
        bodies: whose heads are seen, or whose feet.
    """

    label: int
    box: Box
    bodies: Bodies


def people_regions(kind: NDArray[np.uint8], standing: Standing) -> Labels:
    """(height, width) k + 1 for the pixels of person k, 0 elsewhere.

    Args:
        kind: (height, width) uint8, 0 in the background, else of `tracking.people.upright`.
        standing: sizes of people.
    """
    certain = np.where((kind > 0) & (kind != SHADOW), np.uint8(255), np.uint8(0))
    labels, boxes = silhouettes(certain)
    regions = np.zeros_like(labels)
    everybody = nobody()
    # From the top down: a head without a chest finds it before its own feet look for one.
    for k in sorted(range(len(boxes)), key=lambda k: boxes[k][1]):
        if _absorbed(regions, kind, _inside(labels, boxes[k]) == k + 1, boxes[k], everybody):
            continue
        if len(everybody) > _MOST_PEOPLE:
            break
        found = _silhouette(labels, k + 1, boxes[k], standing)
        if _paint(regions, kind, labels, found, len(everybody), standing):
            everybody = everybody.with_others(found.bodies)
    return _seen_enough(regions, everybody)


def _seen_enough(regions: Labels, everybody: Bodies) -> Labels:
    """The regions without those of bodies of which hardly anything is seen; their numbers stay."""
    pixels = np.bincount(regions.ravel(), minlength=len(everybody) + 1)[1:]
    gone = pixels < _LEAST_SEEN * _BODY_AREA * everybody.height**2 * everybody.stretch
    return regions * np.concatenate(([False], ~gone)).astype(np.uint8)[regions]


def _absorbed(
    regions: Labels,
    kind: NDArray[np.uint8],
    own: NDArray[np.bool_],
    box: Box,
    everybody: Bodies,
) -> bool:
    """Whether a fragment is a limb of somebody found already; its pixels are painted so."""
    if len(everybody) == 0:
        return False
    left, top, width, height = box
    inside = np.s_[top : top + height, left : left + width]
    v, u = np.nonzero(own)
    place = placed(u + left, v + top, everybody)
    limb = (place.across < _LIMB_ACROSS) & (place.along > 0) & (place.along < 1)
    most = np.bincount(place.body).argmax()
    whole = _BODY_AREA * everybody.height[most] ** 2 * everybody.stretch[most]
    if limb.mean() < _LIMB_INSIDE or len(v) > _LIMB_AREA * whole:
        return False
    limb &= body_pixels(kind[inside][v, u], place, u, everybody.reach)
    regions[inside][v[limb], u[limb]] = place.body[limb] + 1
    return True


def _silhouette(labels: Labels, label: int, box: Box, standing: Standing) -> Silhouette:
    left, top = box[:2]
    own = _inside(labels, box) == label
    bodies = bodies_in(own, left, top, standing)
    if standing.calibrated:
        bodies = _beheaded(bodies, own, box, labels.shape[0], standing)
        v, u = np.nonzero(own)
        for _ in range(_MOST_NEARER):
            nearer = _nearer(u + left, v + top, bodies, standing)
            if nearer is None:
                break
            bodies = bodies.with_others(nearer)
    return Silhouette(label, box, bodies)


def _inside(labels: Labels, box: Box) -> Labels:
    left, top, width, height = box
    return labels[top : top + height, left : left + width]


def _beheaded(
    bodies: Bodies, own: NDArray[np.bool_], box: Box, rows: int, standing: Standing
) -> Bodies:
    """The bodies, those whose heads are above the picture's edge measured from their feet."""
    if box[1] > 1 or box[1] + box[3] >= rows - 1:
        return bodies
    cut = np.flatnonzero(bodies.head[:, 1] <= 1)
    column = (bodies.head[cut, 0] - box[0]).astype(np.intp)
    foot = np.column_stack((bodies.head[cut, 0], lowest(own, column) + (box[1] - 1)))
    taller = standing.above(foot)
    cut, taller = cut[taller.head[:, 1] < 0], taller.chosen(taller.head[:, 1] < 0)
    return bodies.chosen(np.setdiff1d(np.arange(len(bodies)), cut)).with_others(taller)


def _nearer(
    u: NDArray[np.intp], v: NDArray[np.intp], bodies: Bodies, standing: Standing
) -> Bodies | None:
    """Somebody whose feet are seen below all others' and whose head nothing shows.

    None also where those feet are at or above the horizon: nobody stands on the floor there.
    """
    place = placed(u, v, bodies)
    rest = place.along > np.minimum(_UNEXPLAINED, bodies.reach[place.body])
    if not rest.any():
        return None
    low = int(v[rest].max())
    body = standing.above(np.array([[float(np.median(u[rest])), float(low)]]))
    if not np.isfinite(body.height[0]):
        return None
    enough = _NEARER_FILL * body.height[0] ** 2 * body.stretch[0]
    if np.count_nonzero(rest) < enough or body.head[0, 1] >= low:
        return None
    return body if body.away_from(bodies)[0] else None


def _paint(
    regions: Labels,
    kind: NDArray[np.uint8],
    labels: Labels,
    silhouette: Silhouette,
    count: int,
    standing: Standing,
) -> bool:
    """Give pixels of a silhouette, and what looks like shadow in its bodies, to the bodies.

    Returns:
        Whether there are people; nothing is painted otherwise.
    """
    bodies = silhouette.bodies
    inside = _reach(silhouette, labels.shape, standing.calibrated)
    top, left = inside[0].start, inside[1].start
    own = labels[inside] == silhouette.label
    shadow = (labels[inside] == 0) & (kind[inside] == SHADOW) & (regions[inside] == 0)
    v, u = np.nonzero(own | shadow)
    place = placed(u + left, v + top, bodies)
    found = kind[inside][v, u]
    kept = body_pixels(found, place, u, bodies.reach)
    if not _are_people(u[kept] + left, v[kept] + top, bodies, labels.shape[0], standing):
        return False
    regions[inside][v[kept], u[kept]] = place.body[kept] + count + 1
    return True


def _reach(silhouette: Silhouette, shape: tuple[int, ...], metric: bool) -> tuple[slice, slice]:
    """The rows and columns in which a silhouette's bodies may have pixels."""
    left, top, width, height = silhouette.box
    bodies = silhouette.bodies
    right, bottom = left + width, top + height
    top = max(0, top - int(_ABOVE * bodies.height.max()))
    if metric:
        bottom = max(bottom, int(bodies.foot[:, 1].max()))
        left = min(left, int((bodies.head[:, 0] - bodies.width / 2).min()))
        right = max(right, int((bodies.head[:, 0] + bodies.width / 2).max()))
    return slice(top, min(bottom, shape[0])), slice(max(left, 0), min(right, shape[1]))


def _are_people(
    u: NDArray[np.intp], v: NDArray[np.intp], bodies: Bodies, rows: int, standing: Standing
) -> bool:
    """Whether these pixels are enough for people.

    Args:
        u, v: columns and rows in working px.
        bodies: in them.
        rows: of the picture.
    """
    if len(v) == 0:
        return False
    low = int(v.max())
    seen, usual = low - int(v.min()) + 1, float(bodies.height.min())
    if standing.calibrated and low < rows - 2:
        foot = np.array([[float(u[v == low].mean()), float(low)]])
        usual = float(np.nan_to_num(standing.above(foot).height[0], nan=usual))
    if seen < _LEAST_HEIGHT * rows or (standing.calibrated and seen < _LEAST_SHARE * usual):
        return False
    return bool(len(v) >= _LEAST_FILL * min(seen, usual) ** 2)
