"""Which pixels belong to whom."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.people.plan_view import SurfacePoints, apart
from tracking.people.settings import PeopleSettings

Labels = NDArray[np.uint8]
_GROWTH = cv2.getStructuringElement(cv2.MORPH_RECT, (9, 9))
_GROWTH_STEPS = 4
_FARTHEST = 2.0
_FLOOR_SLACK_M = 0.12
_FAR_APART = 4096.0
"""Added to the values of one region after another, so that all are sorted at once, m."""


@dataclass(frozen=True, slots=True)
class Extent:
    """What the points of each region measure, a row a region.

    Attributes:
        middle: (k, 3) world metres, the area-weighted mean of the region's points.
        low, high: (k,) m, heights of its lowest and highest points, outliers left out.
        width: (k,) m across the line of sight, outliers left out.
        area: (k,) m² of surface.
        top: (k,) the grid row of its highest place in the picture.
    """

    middle: NDArray[np.float32]
    low: NDArray[np.float32]
    high: NDArray[np.float32]
    width: NDArray[np.float32]
    area: NDArray[np.float32]
    top: NDArray[np.intp]


def assign_points(
    places: NDArray[np.float32],
    points: SurfacePoints,
    camera_xy: NDArray[np.float32],
    settings: PeopleSettings,
) -> NDArray[np.intp]:
    """(n,) index of the place each point belongs to, -1 where none is near."""
    if len(places) == 0:
        return np.full(len(points.pixel), -1, np.intp)
    squared = apart(
        places, points.world[:, :2], points.range_noise, camera_xy, settings.body_width_m / 2
    )
    nearest = squared.min(axis=0)
    # Of two equally near the later one: many times as fast as argmin along the first axis.
    number = np.arange(len(places), dtype=np.uint8)[:, None]
    owner = ((squared == nearest).view(np.uint8) * number).max(axis=0).astype(np.intp)
    far = nearest > _FARTHEST**2
    # Close to the floor only feet are people; they stand nearer to the middle than shadows reach.
    low = points.world[:, 2] < _FLOOR_SLACK_M + 0.2 * points.range_noise
    far |= low & (nearest > 1.0)
    return np.where(far, -1, owner)


def paint(
    owner: NDArray[np.intp],
    points: SurfacePoints,
    body: NDArray[np.uint8],
) -> Labels:
    """Label picture of the grid: 0 nobody, k + 1 the pixels of place k.

    Foreground whose range is unknown goes to the person it touches.

    Args:
        owner: (n,) of `assign_points`.
        points: of the grid.
        body: (rows, columns) uint8, 255 where the grid shows foreground that is no shadow, else 0.
    """
    labels = np.zeros(body.shape, np.uint8)
    labels.ravel()[points.pixel] = owner + 1
    unknown = body.copy()
    unknown.ravel()[points.pixel] = 0
    for _ in range(_GROWTH_STEPS):
        grown = cv2.dilate(labels, _GROWTH)
        fill = cv2.bitwise_and(grown, unknown)
        labels = np.asarray(cv2.max(labels, fill), np.uint8)
        _, filled = cv2.threshold(fill, 0, 255, cv2.THRESH_BINARY)
        unknown = np.asarray(cv2.subtract(unknown, filled), np.uint8)
    return labels


def measure(
    count: int,
    owner: NDArray[np.intp],
    points: SurfacePoints,
    camera_xy: NDArray[np.float32],
    columns: int,
) -> Extent:
    """The real size of each region.

    Args:
        count: of the regions.
        owner: (n,) of `assign_points`.
        points: of the grid.
        camera_xy: (2,) m.
        columns: of the grid.
    """
    rows = np.flatnonzero(owner >= 0)
    region, surface = owner.take(rows), points.area.take(rows)
    x, y, z = np.ascontiguousarray(points.world.take(rows, axis=0).T)
    pixels = np.bincount(region, minlength=count)
    area = np.bincount(region, surface, count)
    sums = [np.bincount(region, surface * values, count) for values in (x, y, z)]
    middle = (np.column_stack(sums) / np.maximum(area, 1e-9)[:, None]).astype(np.float32)
    low, high = _trimmed(z, region, pixels, 0.02)
    sight = middle[:, :2] - camera_xy
    across = np.array((-sight[:, 1], sight[:, 0]))
    across /= np.maximum(np.hypot(sight[:, 0], sight[:, 1]), np.float32(1e-3))
    sideways = x * across[0].take(region) + y * across[1].take(region)
    left, right = _trimmed(sideways, region, pixels, 0.03)
    top = np.zeros(count, np.intp)
    # The first row of each is written last.
    top[region[::-1]] = points.pixel.take(rows[::-1]) // columns
    return Extent(middle, low, high, right - left, area.astype(np.float32), top)


def _trimmed(
    values: NDArray[np.float32], region: NDArray[np.intp], pixels: NDArray[np.intp], share: float
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """(regions,) the lowest and the highest values, a share of each left out at both ends.

    Args:
        values: (n,) m. region: (n,) whose. pixels: (regions,) how many each has; 0 gives 0.
    """
    ordered = np.concatenate((np.sort(region * _FAR_APART + values), [0.0]))
    stop = np.cumsum(pixels)
    left_out = (share * pixels).astype(np.intp)
    ends = np.array((stop - pixels + left_out, np.maximum(stop - 1 - left_out, 0)))
    found = ordered[ends] - np.arange(len(pixels)) * _FAR_APART
    low, high = np.where(pixels > 0, found, 0.0).astype(np.float32)
    return low, high
