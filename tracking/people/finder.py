"""From range inside the foreground to people with box, place and colours."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.foreground import in_size
from tracking.geometry import Ground, Rectification
from tracking.people.body_boxes import BodyBoxes, axis_positions
from tracking.people.boxes import behind_things, hidden_sides, region_boxes
from tracking.people.colours import clothes_colours, colour_histograms
from tracking.people.detections import Detections
from tracking.people.heads_above import split_by_heads
from tracking.people.plan_view import SurfacePoints, find_people, surface_points
from tracking.people.regions import Extent, assign_points, measure, paint
from tracking.people.seams import without_seams
from tracking.people.settings import PeopleSettings
from tracking.stereo import STEP, SightLines

_CERTAIN = 255
_BEFORE_M = 0.5
"""What is nearer than people by this may hide them."""
_CUT_ROWS = 6
"""What is ranged up to so many rows of the grid below the picture's upper edge goes on above it."""
_MOST_PEOPLE = 255
"""Labels of 8 bits tell no more apart."""
_LEAST_BELOW_EDGE_M = 0.5
"""Nobody's legs are seen less high where the upper edge cuts off the rest."""


class PeopleFinder:
    """Tells people apart in range, gives them their pixels and measures them.

    Args:
        rectification: of the recording.
        ground: where the floor is.
        lines: sight lines of the rectified left camera at the working scale.
        settings: of people.

    Attributes:
        scene: (rows, columns) disparity of the empty scene on the grid; None before it is known.
    """

    def __init__(
        self,
        rectification: Rectification,
        ground: Ground,
        lines: SightLines,
        settings: PeopleSettings,
    ) -> None:
        self.scene: NDArray[np.float32] | None = None
        self._size = rectification.size
        self._rectification = rectification
        self._boxes = BodyBoxes(rectification, ground, lines.shrink, settings)
        self._lines = lines
        self._rays = np.ascontiguousarray(lines.rays[::STEP, ::STEP])
        self._camera_xy = lines.centre[:2].astype(np.float32)
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
            body: (rows, columns) uint8 on the grid, 0 in background and shadow, 255 in foreground
                that is neither, in between where it is shadow if it lies on the floor.
            picture: (height, width, 3) the left camera at the working scale.
        """
        settings = self._settings
        certain = (body == _CERTAIN).view(np.uint8) * np.uint8(255)
        high = points.world[:, 2] > settings.min_point_height_m
        places = find_people(points.chosen(np.flatnonzero(high)), self._camera_xy, settings)
        owner = assign_points(places, points, self._camera_xy, settings)
        told = split_by_heads(places, owner, points, self._camera_xy, settings)
        if len(places) < len(told) <= _MOST_PEOPLE:
            places, owner = told, assign_points(told, points, self._camera_xy, settings)
        # What lies on the floor and looks like shadow is nobody's foot.
        owner[~high & (certain.ravel().take(points.pixel) == 0)] = -1
        owner = without_seams(owner, points, certain.shape)
        extent = measure(len(places), owner, points, self._camera_xy, certain.shape[1])
        real = self._are_people(extent)
        owner = _renumbered(owner, real)
        labels = paint(owner, points, certain)
        kept = Extent(*(getattr(extent, name)[real] for name in Extent.__slots__))
        return self._describe(places[real], kept, labels, picture)

    def _are_people(self, extent: Extent) -> NDArray[np.bool_]:
        """(k,) which regions are high and large enough; of some the edge leaves the legs only."""
        settings = self._settings
        least_m = np.where(
            extent.top < _CUT_ROWS, _LEAST_BELOW_EDGE_M, np.float32(settings.min_height_m)
        )
        return np.asarray(
            (extent.high >= least_m) & (extent.area >= settings.min_area_m2), np.bool_
        )

    def _describe(
        self,
        places: NDArray[np.float32],
        extent: Extent,
        labels: NDArray[np.uint8],
        picture: NDArray[np.uint8],
    ) -> Detections:
        settings = self._settings
        boxes = region_boxes(labels, len(places))
        hidden, truncated = hidden_sides(labels, boxes, extent.middle[:, :2] - self._camera_xy)
        if self.scene is not None:
            hidden |= behind_things(boxes, self.scene, self._nearer_than(extent))
        position = axis_positions(places, extent, hidden, self._lines, settings)
        upper, lower, middle = colour_histograms(picture, labels, boxes, settings, STEP)
        width = np.maximum(extent.width, 0)
        return Detections(
            box=self._boxes.whole(boxes, position, extent, hidden),
            position=position,
            size=np.stack((width, extent.high), axis=1).astype(np.float64),
            merged=self._merged(extent),
            truncated=truncated,
            upper=upper,
            lower=lower,
            middle=middle,
            regions=in_size(labels, self._size),
            clothes=clothes_colours(picture, labels, boxes, STEP),
            from_detector=np.zeros(len(boxes), bool),
        )

    def _nearer_than(self, extent: Extent) -> NDArray[np.float64]:
        """(k,) the working disparity of what stands clearly before each region."""
        lines = self._lines
        seen = (
            self._rectification.disparity_from_world(extent.middle.astype(np.float64))
            / lines.shrink
        )
        depth = lines.focal_baseline / np.maximum(seen - lines.offset, 1e-6)
        return lines.focal_baseline / np.maximum(depth - _BEFORE_M, 0.1) + lines.offset

    def _merged(self, extent: Extent) -> NDArray[np.bool_]:
        """[Kawashita2014] section 3.4: larger than one person by the set ratio."""
        ratio, settings = self._settings.merged_ratio, self._settings
        wide = extent.width > ratio * settings.body_width_m
        high = extent.high - extent.low > ratio * settings.body_height_m
        return np.asarray(wide | high, np.bool_)


def _renumbered(owner: NDArray[np.intp], kept: NDArray[np.bool_]) -> NDArray[np.intp]:
    """The owners counted among those kept; -1 for the others."""
    number = np.where(kept, np.cumsum(kept) - 1, -1)
    return np.concatenate((number, [-1])).take(owner)
