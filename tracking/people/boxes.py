"""Boxes of regions, and full-body boxes of people who may be seen only in part."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.geometry import Rectification, View
from tracking.people.runs import Runs
from tracking.people.silhouettes import AnyLabels
from tracking.tracks.boxes import boxes_of_corners, corners_of_boxes

Boxes = NDArray[np.float64]
GridBox = tuple[int, int, int, int]

_COVERED = 0.3
"""Share of a side along which somebody nearer must stand to hide what is behind."""
_TOUCHING = 1
"""Regions so close in a row of the grid touch there."""
_BESIDE_PLACES = 4
"""How far beside a region things that hide the rest of it are looked for: edges range badly."""
_EDGE_PLACES = 1
_FEWEST_PLACES = 2
_RINGS = ((0.0, 0.5), (0.45, 0.9), (0.8, 1.0), (1.0, 0.3))
"""A standing body as rings: height and radius as shares of its height and half its width."""
_RING_POINTS = 8


def region_boxes(labels: AnyLabels, count: int) -> list[GridBox]:
    """Left, top, width, height of the pixels labelled 1 to count; (0, 0, 0, 0) where none are.

    Rows and columns with a single pixel at a region's ends are left out: specks, not limbs.
    """
    place = np.flatnonzero(labels != 0)
    region = labels.ravel().take(place).astype(np.intp)
    row, column = np.divmod(place, labels.shape[1])
    top, height = _extents(region, row, count, labels.shape[0])
    left, width = _extents(region, column, count, labels.shape[1])
    return list(zip(left, top, width, height, strict=True))


def _extents(
    region: NDArray[np.intp], line: NDArray[np.intp], count: int, lines: int
) -> tuple[list[int], list[int]]:
    """First line and number of lines of the regions 1 to count, along rows or columns.

    Args:
        region, line: of each pixel. lines: of the picture.
    """
    pixels = np.bincount(region * lines + line, minlength=(count + 1) * lines)
    pixels = pixels.reshape(-1, lines)[1 : count + 1]
    several = pixels >= _FEWEST_PLACES
    shown = np.where(several.any(axis=1, keepdims=True), several, pixels > 0)
    first = shown.argmax(axis=1)
    number = np.where(shown.any(axis=1), lines - shown[:, ::-1].argmax(axis=1) - first, 0)
    return first.tolist(), number.tolist()


def hidden_sides(
    labels: AnyLabels, boxes: list[GridBox], sight: NDArray[np.float32]
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Where regions end at the picture's edge or behind somebody nearer.

    Args:
        labels: (rows, columns) uint8, k + 1 for the pixels of region k.
        boxes: of the regions.
        sight: (k, 2) m on the floor from the camera to each region.

    Returns:
        (k, 4) bool for the left, top, right and bottom side, and (k,) bool, touching the edge.
    """
    rows, columns = labels.shape
    left, top, width, height = np.array(boxes, np.intp).reshape(-1, 4).T
    right, bottom = left + width, top + height
    at_edge = np.array(
        (
            left <= _EDGE_PLACES,
            top <= _EDGE_PLACES,
            right >= columns - _EDGE_PLACES,
            bottom >= rows - _EDGE_PLACES,
        )
    )
    # With nobody above and below the picture, no side lies outside.
    padded = np.asarray(cv2.copyMakeBorder(labels, 1, 1, 0, 0, cv2.BORDER_CONSTANT, value=(0.0,)))
    above = top * columns + left
    first = np.concatenate((above, above + (height + 1) * columns))
    count = np.concatenate((width, width))
    side, place = _along(first, np.ones(len(count), np.intp), count)
    who_is_nearer = _who_is_nearer(sight)
    nearer = who_is_nearer[side % max(len(boxes), 1), padded.ravel().take(place)]
    across = (np.bincount(side, nearer, len(count)) > _COVERED * count).reshape(2, -1)
    down = _touched(labels, who_is_nearer) > _COVERED
    covered = np.array((down[0], across[0], down[1], across[1]))
    return (at_edge | covered).T, np.asarray(at_edge.any(axis=0), np.bool_)


def _touched(labels: AnyLabels, nearer: NDArray[np.bool_]) -> NDArray[np.float64]:
    """(2, k) the share of each region's rows that end, left and right, at somebody nearer.

    Who merely stands beside somebody nearer, with the background between them, is not hidden.

    Args:
        nearer: (k, k + 1) of `_who_is_nearer`.
    """
    runs = Runs.along(labels)
    runs = runs.chosen(runs.label > 0)
    left, right = runs.beside()
    count, rows = len(nearer), labels.shape[0]
    who = runs.label.astype(np.intp) - 1
    line = who * rows + runs.row
    number = np.arange(len(line))
    # Of several runs in a row the one written last counts: the first one, and the last.
    first, last = np.full((2, count * rows), -1)
    first[line[::-1]], last[line] = number[::-1], number
    there = np.flatnonzero(first >= 0)
    first, last, owner = first[there], last[there], there // rows
    gap = runs.start[first] - runs.stop[left[first]], runs.start[right[last]] - runs.stop[last]
    beside = runs.label[left[first]], runs.label[right[last]]
    ends = [
        nearer[owner, label] & (far <= _TOUCHING) for label, far in zip(beside, gap, strict=True)
    ]
    whole = np.maximum(np.bincount(owner, minlength=count), 1)
    return np.stack([np.bincount(owner, end, count) / whole for end in ends])


def _who_is_nearer(sight: NDArray[np.float32]) -> NDArray[np.bool_]:
    """(k, k + 1) whether the region of a label, of which 0 is nobody, is nearer than region k."""
    distance = np.hypot(sight[:, 0], sight[:, 1])
    nearer = np.zeros((len(sight), len(sight) + 1), np.bool_)
    nearer[:, 1:] = distance < distance[:, None]
    return nearer


def _along(
    first: NDArray[np.intp], step: NDArray[np.intp], count: NDArray[np.intp]
) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """All places of lines: the number of each one's line, and the place.

    Args:
        first: (lines,) where each begins. step: from place to place. count: how many it has.
    """
    line = np.repeat(np.arange(len(count)), count)
    ahead = np.arange(len(line)) - np.repeat(np.cumsum(count) - count, count)
    return line, first.take(line) + ahead * step.take(line)


def behind_things(
    boxes: list[GridBox], scene: NDArray[np.float32], limit: NDArray[np.float64]
) -> NDArray[np.bool_]:
    """Where regions end at something fixed that stands before them, such as a pillar.

    Args:
        boxes: of the regions.
        scene: (rows, columns) disparity of the empty scene, NaN where unknown.
        limit: (k,) the disparity from which on things are nearer than the people.

    Returns:
        (k, 4) bool for the left, top, right and bottom side; top and bottom are not looked at.
    """
    hidden = np.zeros((len(boxes), 4), np.bool_)
    left, top, width, height = np.array(boxes, np.intp).reshape(-1, 4).T
    # With unknown places to both sides of the scene, none that is looked at lies outside.
    beside = _BESIDE_PLACES
    padded = np.asarray(
        cv2.copyMakeBorder(scene, 0, 0, beside, beside, cv2.BORDER_CONSTANT, value=(np.nan,))
    )
    row = padded.shape[1]
    first = top * row + left + np.array(((0,), (beside,))) + np.array(((0,), (1,))) * width
    side, place = _along(first.ravel(), np.full(first.size, row), np.tile(height, 2))
    seen = padded.ravel().take(place + np.arange(beside)[:, None])
    nearer = (seen > np.tile(limit, 2).take(side)).any(axis=0)
    covered = np.bincount(side, nearer, first.size).reshape(2, -1) > _COVERED * height
    hidden[:, 0], hidden[:, 2] = covered
    return hidden


def recorded_boxes(boxes: Boxes, rectification: Rectification) -> Boxes:
    """Boxes (n, 4) in recorded pixels round boxes (n, 4) in rectified ones."""
    if rectification.identity:
        return boxes
    share = np.array((0, 0.5, 1))
    u = boxes[:, :1] + boxes[:, 2:3] * share
    v = boxes[:, 1:2] + boxes[:, 3:] * share
    outline = np.stack(np.broadcast_arrays(u[:, :, None], v[:, None, :]), axis=-1)
    recorded = rectification.recorded_from_rectified(outline.reshape(-1, 2))
    return _round(recorded.reshape(len(boxes), 9, 2))


def standing_boxes(view: View, xy: Boxes, height_m: Boxes, width_m: float) -> Boxes:
    """Boxes (n, 4) of bodies standing at floor places, each of its own height.

    Args:
        view: the camera on its floor.
        xy: (n, 2) m. height_m: (n,). width_m: from all sides.

    Returns:
        Pixels as recorded; NaN where a body is in part behind the camera.
    """
    (boxes,) = several_standing_boxes(view, xy, ((height_m, width_m),))
    return boxes


def several_standing_boxes(
    view: View, xy: Boxes, bodies: Sequence[tuple[Boxes, float]]
) -> tuple[Boxes, ...]:
    """`standing_boxes` of several bodies, heights and width each, at the same floor places.

    All are projected at once, which costs little more than one.
    """
    count = len(_RINGS) * _RING_POINTS
    points = np.empty((len(bodies), len(xy), count, 3))
    for standing, (height_m, width_m) in zip(points, bodies, strict=True):
        body = _body_points(width_m)
        standing[..., :2] = xy[:, None] + body[:, :2]
        standing[..., 2] = height_m[:, None] * body[:, 2]
    pixels = view.pixel_from_world(points.reshape(-1, 3)).reshape(-1, count, 2)
    return tuple(_round(pixels).reshape(len(bodies), len(xy), 4))


def with_feet(seen: Boxes, feet: Boxes, unseen: NDArray[np.bool_]) -> Boxes:
    """Boxes (n, 4) drawn out to where the feet stand, of those whose feet are not seen."""
    near, far = corners_of_boxes(seen), corners_of_boxes(feet)
    both = np.concatenate(
        (np.minimum(near[:, :2], far[:, :2]), np.maximum(near[:, 2:], far[:, 2:])), axis=1
    )
    corners = np.where(unseen[:, None] & np.isfinite(both), both, near)
    return boxes_of_corners(corners)


def full_body_boxes(seen: Boxes, standing: Boxes, reach: Boxes, hidden: NDArray[np.bool_]) -> Boxes:
    """Boxes of whole bodies, from what is seen where it is whole.

    Args:
        seen: (n, 4) left, top, width, height of the visible regions.
        standing: (n, 4) of a body of the measured height standing at the measured place.
        reach: (n, 4) the same of a body with arms and legs stretched: nobody reaches farther, and
            pixels that lie outside are somebody else's or a rest of shadow.
        hidden: (n, 4) bool; left, top, right, bottom side of the region ends at somebody nearer
            or at the picture's edge, so the body goes on behind it.

    Returns:
        (n, 4); a hidden side is taken from `standing` where that reaches farther.
    """
    near, far, limit = corners_of_boxes(seen), corners_of_boxes(standing), corners_of_boxes(reach)
    low = np.array([True, True, False, False])
    outer = np.where(low, np.minimum(near, far), np.maximum(near, far))
    corners = np.where(hidden & np.isfinite(far), outer, near)
    within = np.where(low, np.maximum(corners, limit), np.minimum(corners, limit))
    corners = np.where(np.isfinite(limit), within, corners)
    return boxes_of_corners(corners)


@lru_cache(maxsize=32)
def _body_points(width_m: float) -> Boxes:
    """Points (k, 3) on a body's outline: x, y in metres, z as a share of its height.

    Kept, as every frame asks for the same few; not to be written to.
    """
    angle = np.arange(_RING_POINTS) * (2 * np.pi / _RING_POINTS)
    circle = np.column_stack((np.cos(angle), np.sin(angle))) * (width_m / 2)
    points = np.concatenate(
        [np.column_stack((circle * r, np.full(_RING_POINTS, z))) for z, r in _RINGS]
    )
    points.flags.writeable = False
    return points


def _round(points: Boxes) -> Boxes:
    """The boxes (n, 4) round points (n, k, 2)."""
    # An axis a row: extremes along the points are then taken many at once.
    axes = np.ascontiguousarray(points.transpose(2, 0, 1))
    low, high = axes.min(axis=2), axes.max(axis=2)
    return np.concatenate((low, high - low)).T
