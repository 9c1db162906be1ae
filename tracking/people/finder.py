"""From range inside the foreground to people with box, place and colours."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.geometry import Ground, Rectification, View
from tracking.people.boxes import (
    GridBox,
    full_body_boxes,
    hidden_sides,
    region_boxes,
    standing_boxes,
    with_feet,
)
from tracking.people.colours import colour_histograms
from tracking.people.detections import Detections
from tracking.people.plan_view import SurfacePoints, find_people, surface_points
from tracking.people.regions import Extent, assign_points, measure, paint
from tracking.people.settings import PeopleSettings
from tracking.stereo import STEP, SightLines

_CERTAIN = 255
_FEET_SEEN_M = 0.25
_ANKLE_M, _FEET_WIDTH = 0.08, 0.6
_HEIGHTS_M = (1.0, 2.1)
_ABOVE_HIGHEST_M = 0.03
"""The top of the head over the highest points, which leave outliers out."""
_SLACK_M = 0.04
_TORSO = 0.9
"""Seen width of a whole body as a share of its breadth."""
_STRETCH = 1.8
"""How much wider than a body arms and legs make it."""


class PeopleFinder:
    """Tells people apart in range, gives them their pixels and measures them.

    Args:
        rectification: of the recording.
        ground: where the floor is.
        lines: sight lines of the rectified left eye at the working scale.
        settings: of people.
    """

    def __init__(
        self,
        rectification: Rectification,
        ground: Ground,
        lines: SightLines,
        settings: PeopleSettings,
    ) -> None:
        self._rectification = rectification
        self._view = View(rectification.calibration.left, ground)
        self._lines = lines
        self._rays = np.ascontiguousarray(lines.rays[::STEP, ::STEP])
        self._eye = lines.centre[:2].astype(np.float32)
        self._settings = settings

    def points(self, disparity: NDArray[np.float32]) -> SurfacePoints:
        """The matched surface on the grid.

        Args:
            disparity: (rows, columns) working px, of `SubtractionStereo`.
        """
        return surface_points(
            disparity, self._lines, self._rays, STEP * STEP, self._settings.disparity_noise_px
        )

    def find(
        self,
        points: SurfacePoints,
        body: NDArray[np.uint8],
        picture: NDArray[np.uint8],
    ) -> Detections:
        """The people of one frame.

        Args:
            points: of this frame.
            body: (height, width) uint8, 0 in background and shadow, 255 in foreground that is
                neither, in between where it is shadow if it lies on the floor.
            picture: (height, width, 3) the left eye, both at the working scale.
        """
        settings = self._settings
        certain = (body[::STEP, ::STEP] == _CERTAIN).view(np.uint8) * np.uint8(255)
        high = points.world[:, 2] > settings.lowest_m
        places = find_people(points.chosen(high), self._eye, settings)
        owner = assign_points(places, points, self._eye, settings)
        # What lies on the floor and looks like shadow is nobody's foot.
        owner[~high & (certain.ravel()[points.pixel] == 0)] = -1
        extent = measure(len(places), owner, points, self._eye)
        real = (extent.high >= settings.least_height_m) & (extent.area >= settings.least_area_m2)
        owner = _renumbered(owner, real)
        labels = paint(owner, points, certain)
        kept = Extent(*(getattr(extent, name)[real] for name in Extent.__slots__))
        return self._describe(places[real], kept, labels, picture)

    def _describe(
        self,
        places: NDArray[np.float32],
        extent: Extent,
        labels: NDArray[np.uint8],
        picture: NDArray[np.uint8],
    ) -> Detections:
        settings = self._settings
        boxes = region_boxes(labels, len(places))
        hidden, truncated = hidden_sides(labels, boxes, extent.middle[:, :2] - self._eye)
        position = self._positions(places, extent, hidden)
        colours = np.ascontiguousarray(picture[::STEP, ::STEP])
        colours = np.asarray(cv2.cvtColor(colours, cv2.COLOR_BGR2HSV), np.uint8)
        upper, lower, middle = colour_histograms(colours[..., :2], labels, boxes, settings)
        width = np.maximum(extent.width, 0)
        return Detections(
            box=self._boxes(boxes, position, extent, hidden),
            position=position,
            size=np.stack((width, extent.high), axis=1).astype(np.float64),
            merged=self._merged(extent),
            truncated=truncated,
            upper=upper,
            lower=lower,
            middle=middle,
            regions=self._full_size(labels),
        )

    def _positions(
        self, places: NDArray[np.float32], extent: Extent, hidden: NDArray[np.bool_]
    ) -> NDArray[np.float64]:
        """(k, 3) the person's axis: behind the surface that faces the camera.

        Of somebody half hidden on one side, what is seen lies to the other side of the axis.
        """
        sight = places - self._eye
        distance = np.hypot(sight[:, 0], sight[:, 1])
        drop = self._lines.centre[2] - extent.middle[:, 2]
        level = distance / np.maximum(np.hypot(distance, drop), 1e-6)
        step = self._settings.body_depth_m * level / np.maximum(distance, 1e-6)
        one_side = hidden[:, 2].astype(np.float32) - hidden[:, 0]
        unseen = np.maximum(self._settings.body_width_m * _TORSO - extent.width, 0)
        axis = places + sight * step[:, None]
        axis += (one_side * unseen / 2)[:, None] * self._lines.rightward[:2]
        return np.concatenate((axis, extent.middle[:, 2:]), axis=1).astype(np.float64)

    def _boxes(
        self,
        boxes: list[GridBox],
        position: NDArray[np.float64],
        extent: Extent,
        hidden: NDArray[np.bool_],
    ) -> NDArray[np.float64]:
        """(k, 4) full-body boxes in pixels as recorded."""
        settings, xy = self._settings, position[:, :2]
        seen_height = np.clip(extent.high + _ABOVE_HIGHEST_M, *_HEIGHTS_M)
        usual = np.maximum(seen_height, settings.body_height_m)
        height = np.where(hidden[:, 1], usual, seen_height).astype(np.float64)
        ankles = np.full(len(xy), _ANKLE_M)
        feet = standing_boxes(self._view, xy, ankles, settings.body_width_m * _FEET_WIDTH)
        return full_body_boxes(
            with_feet(self._recorded_boxes(boxes), feet, extent.low > _FEET_SEEN_M),
            standing_boxes(self._view, xy, height, settings.body_width_m),
            standing_boxes(self._view, xy, height + _SLACK_M, settings.body_width_m * _STRETCH),
            hidden,
        )

    def _merged(self, extent: Extent) -> NDArray[np.bool_]:
        """[Kawashita2014] section 3.4: larger than one person by the set ratio."""
        ratio, settings = self._settings.merged_ratio, self._settings
        wide = extent.width > ratio * settings.body_width_m
        high = extent.high - extent.low > ratio * settings.body_height_m
        return np.asarray(wide | high, np.bool_)

    def _recorded_boxes(self, boxes: list[GridBox]) -> NDArray[np.float64]:
        """(k, 4) boxes of the grid as boxes of the recorded picture."""
        if not boxes:
            return np.zeros((0, 4))
        scale = STEP * self._lines.shrink
        left, top, width, height = np.array(boxes, np.float64).T * scale
        share = np.array((0, 0.5, 1))
        u = left[:, None] + width[:, None] * share
        v = top[:, None] + height[:, None] * share
        outline = np.stack(np.broadcast_arrays(u[:, :, None], v[:, None, :]), axis=-1)
        recorded = self._rectification.recorded_from_rectified(outline.reshape(-1, 2) - 0.5)
        corners = recorded.reshape(len(boxes), 9, 2)
        low, high = corners.min(axis=1), corners.max(axis=1)
        return np.concatenate((low, high - low), axis=1)

    def _full_size(self, labels: NDArray[np.uint8]) -> NDArray[np.int32]:
        size = self._rectification.size
        return cv2.resize(labels, size, interpolation=cv2.INTER_NEAREST).astype(np.int32)


def _renumbered(owner: NDArray[np.intp], kept: NDArray[np.bool_]) -> NDArray[np.intp]:
    """The owners counted among those kept; -1 for the others."""
    number = np.where(kept, np.cumsum(kept) - 1, -1)
    return np.concatenate((number, [-1]))[owner]
