"""Where people stand, and the boxes of their whole bodies."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.geometry import Ground, Rectification, View
from tracking.people.boxes import (
    GridBox,
    full_body_boxes,
    recorded_boxes,
    several_standing_boxes,
    with_feet,
)
from tracking.people.regions import Extent
from tracking.people.settings import PeopleSettings
from tracking.stereo import STEP, SightLines

_FEET_SEEN_M = 0.15
"""A region that comes down so far shows its feet."""
_ANKLE_M, _FEET_WIDTH = 0.08, 0.6
_HEIGHTS_M = (1.0, 2.1)
_ABOVE_HIGHEST_M = 0.03
"""The top of the head over the highest points, which leave outliers out."""
_SLACK_M = 0.04
_TORSO = 0.9
"""Seen width of a whole body as a share of its breadth."""
_STRETCH = 1.8
"""How much wider than a body arms and legs make it."""


def axis_positions(
    places: NDArray[np.float32],
    extent: Extent,
    hidden: NDArray[np.bool_],
    lines: SightLines,
    settings: PeopleSettings,
) -> Floats:
    """(k, 3) the person's axis on the floor and the height of what is seen, in metres.

    The axis lies behind the surface, which faces the camera, as seen from above. Of somebody half
    hidden on one side, what is seen lies to the other side of the axis.
    """
    sight = places - lines.centre[:2]
    distance = np.hypot(sight[:, 0], sight[:, 1])
    # Straight below the camera all sides are seen, and their middle is the axis.
    behind = settings.body_depth_m / (distance + settings.body_width_m / 2)
    one_side = hidden[:, 2].astype(np.float64) - hidden[:, 0]
    unseen = np.maximum(settings.body_width_m * _TORSO - extent.width, 0)
    axis = places + sight * behind[:, None]
    axis += (one_side * unseen / 2)[:, None] * lines.rightward[:2]
    return np.concatenate((axis, extent.middle[:, 2:]), axis=1).astype(np.float64)


class BodyBoxes:
    """Full-body boxes in pixels as recorded, hidden or not."""

    def __init__(
        self,
        rectification: Rectification,
        ground: Ground,
        shrink: int,
        settings: PeopleSettings,
    ) -> None:
        self._rectification = rectification
        self._view = View(rectification.calibration.left, ground)
        self._grid_px = STEP * shrink
        self._settings = settings

    def whole(
        self,
        boxes: list[GridBox],
        position: Floats,
        extent: Extent,
        hidden: NDArray[np.bool_],
    ) -> Floats:
        """(k, 4) boxes of the bodies of which regions are seen.

        Args:
            boxes: of the regions on the grid.
            position: (k, 3) of `axis_positions`.
            extent: of the regions.
            hidden: (k, 4) which sides are hidden.
        """
        xy, width_m = position[:, :2], self._settings.body_width_m
        height = self._heights(xy, extent, hidden)
        ankles = np.full(len(xy), _ANKLE_M)
        bodies = (
            (ankles, width_m * _FEET_WIDTH),
            (height, width_m),
            (height + _SLACK_M, width_m * _STRETCH),
        )
        feet, standing, reach = several_standing_boxes(self._view, xy, bodies)
        seen = with_feet(self._recorded(boxes), feet, extent.low > _FEET_SEEN_M)
        return full_body_boxes(seen, standing, reach, hidden)

    def _heights(self, xy: Floats, extent: Extent, hidden: NDArray[np.bool_]) -> Floats:
        """(k,) m; the usual height at least where the head is hidden or outside the picture."""
        lowest, highest = map(np.float32, _HEIGHTS_M)
        seen = np.minimum(np.maximum(extent.high + _ABOVE_HIGHEST_M, lowest), highest)
        usual = np.full((len(xy), 1), self._settings.body_height_m)
        head = self._view.pixel_from_world(np.concatenate((xy, usual), axis=1))
        inside = ((head >= 0) & (head < np.array(self._rectification.size))).all(axis=1)
        unseen = hidden[:, 1] | ~inside
        least = np.where(unseen, self._settings.body_height_m, 0.0)
        return np.asarray(np.maximum(seen, least), np.float64)

    def _recorded(self, boxes: list[GridBox]) -> Floats:
        """(k, 4) boxes of the grid as boxes of the recorded picture."""
        left, top, width, height = np.array(boxes, np.float64).reshape(-1, 4).T * self._grid_px
        rectified = np.stack((left - 0.5, top - 0.5, width, height), axis=1)
        return recorded_boxes(rectified, self._rectification)
