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
    eye: NDArray[np.float32],
    settings: PeopleSettings,
) -> NDArray[np.intp]:
    """(n,) index of the place each point belongs to, -1 where none is near."""
    if len(places) == 0:
        return np.full(len(points.pixel), -1, np.intp)
    squared = apart(places, points.world[:, :2], points.range_noise, eye, settings.body_width_m / 2)
    owner = squared.argmin(axis=0)
    nearest = squared.min(axis=0)
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
        unknown[labels > 0] = 0
    return labels


def measure(
    count: int,
    owner: NDArray[np.intp],
    points: SurfacePoints,
    eye: NDArray[np.float32],
    columns: int,
) -> Extent:
    """The real size of each region.

    Args:
        count: of the regions.
        owner: (n,) of `assign_points`.
        points: of the grid.
        eye: (2,) m.
        columns: of the grid.
    """
    middle = np.zeros((count, 3), np.float32)
    low, high, width, area = (np.zeros(count, np.float32) for _ in range(4))
    top = np.zeros(count, np.intp)
    order = np.argsort(owner, kind="stable")
    bounds = np.searchsorted(owner[order], np.arange(count + 1))
    for k in range(count):
        rows = order[bounds[k] : bounds[k + 1]]
        if len(rows) == 0:
            continue
        world, surface = points.world[rows], points.area[rows]
        area[k] = surface.sum()
        top[k] = points.pixel[rows[0]] // columns
        middle[k] = surface @ world / area[k]
        low[k], high[k] = _trimmed(world[:, 2], 0.02)
        sight = middle[k, :2] - eye
        normal = np.array((-sight[1], sight[0]), np.float32) / max(float(np.hypot(*sight)), 1e-3)
        left, right = _trimmed(world[:, :2] @ normal, 0.03)
        width[k] = right - left
    return Extent(middle, low, high, width, area, top)


def _trimmed(values: NDArray[np.float32], share: float) -> tuple[float, float]:
    """The lowest and the highest of the values with a share left out at both ends."""
    ordered = np.sort(values)
    left_out = int(share * len(ordered))
    return float(ordered[left_out]), float(ordered[-1 - left_out])
