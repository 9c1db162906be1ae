"""Regions of people in one camera's picture, measured."""

from __future__ import annotations

from typing import TypeVar

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.people.body_scale import Standing
from tracking.people.boxes import GridBox, hidden_sides, region_boxes
from tracking.people.colours import Histogram, clothes_colours, colour_histograms
from tracking.people.detections import Detections
from tracking.people.settings import PeopleSettings
from tracking.people.silhouettes import AnyLabels

Pixel = TypeVar("Pixel", bound=np.uint8 | np.uint16)

_BOTTOM = 3
_STEP = 2
"""Only every second pixel's colour is looked at."""
_ONE_WIDE = 1.2
"""A region this many times as broad as high is several people, where nothing is in metres."""


def described(
    regions: AnyLabels,
    picture: NDArray[np.uint8],
    shape: tuple[int, ...],
    standing: Standing,
    settings: PeopleSettings,
) -> Detections:
    """The people of one frame, with boxes, places and colours.

    Args:
        regions: (height, width) k + 1 for the pixels of person k.
        picture: (height, width, 3) BGR, both at the working scale.
        shape: of the picture as recorded.
        standing: sizes of people. settings: of people.
    """
    boxes = region_boxes(regions, int(regions.max(initial=0)))
    seen = np.array(boxes, np.float64).reshape(len(boxes), 4)
    position, hidden, truncated = _placed(regions, boxes, seen, standing)
    size = _sizes(seen, position, standing)
    upper, lower, middle, clothes = _colours(regions, picture, boxes, settings)
    return Detections(
        box=standing.whole(seen, position, hidden),
        position=position,
        size=size,
        merged=_merged(seen, size, settings),
        truncated=truncated,
        upper=upper,
        lower=lower,
        middle=middle,
        regions=in_full(regions, shape).astype(np.int32),
        clothes=clothes,
        from_detector=np.zeros(len(boxes), bool),
    )


def in_full(picture: NDArray[Pixel], shape: tuple[int, ...]) -> NDArray[Pixel]:
    """A picture of labels at the size of the recorded one."""
    if picture.shape[:2] == shape[:2]:
        return picture
    size = (shape[1], shape[0])
    resized = cv2.resize(picture, size, interpolation=cv2.INTER_NEAREST)
    return np.asarray(resized, picture.dtype)


def _placed(
    regions: AnyLabels, boxes: list[GridBox], seen: Floats, standing: Standing
) -> tuple[Floats, NDArray[np.bool_], NDArray[np.bool_]]:
    """Positions (n, 3), hidden sides (n, 4) and which touch the picture's edge (n,)."""
    top, foot = _ends(regions, boxes)
    at_edge = seen[:, 1] + seen[:, 3] >= regions.shape[0] - 1
    position = standing.positions(top, foot, ~at_edge)
    away = standing.distances(position, seen)
    # Only the order counts: who stands nearer.
    rank = away.argsort(kind="stable").argsort(kind="stable") + 1.0
    sight = np.column_stack((np.zeros(len(boxes)), rank)).astype(np.float32)
    hidden, truncated = hidden_sides(regions, boxes, sight)
    if (hidden[:, _BOTTOM] != at_edge).any():
        position = standing.positions(top, foot, ~hidden[:, _BOTTOM])
    return position, hidden, truncated


def _sizes(seen: Floats, position: Floats, standing: Standing) -> Floats:
    """(n, 2) m width and height."""
    width = seen[:, 2] * standing.metres_per_pixel(position)
    return np.column_stack((width, 2 * position[:, 2]))


def _merged(seen: Floats, size: Floats, settings: PeopleSettings) -> NDArray[np.bool_]:
    """[Kawashita2014] section 3.4: larger than one person by the set ratio.

    Strides and arms make a silhouette twice as broad as the body that carries them.
    """
    wide = size[:, 0] > settings.merged_ratio * 2 * settings.body_width_m
    flat = np.isnan(size[:, 0]) & (seen[:, 2] > _ONE_WIDE * seen[:, 3])
    return np.asarray(wide | flat, np.bool_)


def _colours(
    regions: AnyLabels,
    picture: NDArray[np.uint8],
    boxes: list[GridBox],
    settings: PeopleSettings,
) -> tuple[Histogram, Histogram, Histogram, Histogram]:
    """Histograms of the upper body, the lower body and the middle, and the clothes' colours."""
    labels = np.ascontiguousarray(regions[::_STEP, ::_STEP])
    small = [(a // _STEP, b // _STEP, c // _STEP, d // _STEP) for a, b, c, d in boxes]
    upper, lower, middle = colour_histograms(picture, labels, small, settings, _STEP)
    return upper, lower, middle, clothes_colours(picture, labels, small, _STEP)


def _ends(regions: AnyLabels, boxes: list[GridBox]) -> tuple[Floats, Floats]:
    """The top and the foot (n, 2) px of each region, in the middle of what is there."""
    ends = np.zeros((2, len(boxes), 2))
    for k, (left, top, width, height) in enumerate(boxes):
        own = regions[top : top + height, left : left + width] == k + 1
        band = max(1, height // 8)
        for end, rows in ((0, own[:band]), (1, own[height - band :])):
            columns = np.flatnonzero(rows.any(axis=0))
            middle = float(columns.mean()) if len(columns) else width / 2
            ends[end, k] = left + middle, top if end == 0 else top + height - 1
    return ends[0], ends[1]
