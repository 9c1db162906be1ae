"""Regions of people in one camera's picture, measured."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.people.boxes import GridBox, hidden_sides, region_boxes
from tracking.people.colours import clothes_colours, colour_histograms
from tracking.people.detections import Detections
from tracking.people.settings import PeopleSettings
from tracking.people.silhouettes import Labels
from tracking.people.standing import Standing

Floats = NDArray[np.float64]

_LEFT, _TOP, _RIGHT, _BOTTOM = range(4)
_ONE_WIDE = 1.2
"""A region this many times as broad as high is several people, where nothing is in metres."""


class Describer:
    """Gives regions their boxes, places and colours.

    Args:
        standing: sizes of people.
        settings: of people.
    """

    def __init__(self, standing: Standing, settings: PeopleSettings) -> None:
        self._standing = standing
        self._settings = settings

    def describe(self, regions: Labels, picture: NDArray[np.uint8]) -> Detections:
        """The people of one frame.

        Args:
            regions: (height, width) k + 1 for the pixels of person k.
            picture: (height, width, 3) BGR.
        """
        boxes = region_boxes(regions, int(regions.max(initial=0)))
        seen = np.array(boxes, np.float64).reshape(len(boxes), 4)
        top, foot = _ends(regions, boxes)
        at_edge = seen[:, 1] + seen[:, 3] >= regions.shape[0] - 1
        position = self._standing.positions(top, foot, ~at_edge)
        hidden, truncated = self._hidden(regions, boxes, seen, position)
        position = self._standing.positions(top, foot, ~hidden[:, _BOTTOM])
        size = self._sizes(seen, position)
        hsv = np.asarray(cv2.cvtColor(picture, cv2.COLOR_BGR2HSV), np.uint8)
        upper, lower, middle = colour_histograms(hsv[..., :2], regions, boxes, self._settings)
        return Detections(
            box=self._standing.whole(seen, position, hidden),
            position=position,
            size=size,
            merged=self._merged(seen, size),
            truncated=truncated,
            upper=upper,
            lower=lower,
            middle=middle,
            regions=regions.astype(np.int32),
            clothes=clothes_colours(picture, regions, boxes),
        )

    def _hidden(
        self, regions: Labels, boxes: list[GridBox], seen: Floats, position: Floats
    ) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        away = self._standing.distances(position, seen)
        # Only the order counts: who stands nearer.
        rank = away.argsort(kind="stable").argsort(kind="stable") + 1.0
        sight = np.column_stack((np.zeros(len(boxes)), rank)).astype(np.float32)
        return hidden_sides(regions, boxes, sight)

    def _sizes(self, seen: Floats, position: Floats) -> Floats:
        """(n, 2) m width and height."""
        width = seen[:, 2] * self._standing.metres_per_pixel(position)
        return np.column_stack((width, 2 * position[:, 2]))

    def _merged(self, seen: Floats, size: Floats) -> NDArray[np.bool_]:
        """[Kawashita2014] section 3.4: larger than one person by the set ratio."""
        settings = self._settings
        wide = size[:, 0] > settings.merged_ratio * 2 * settings.body_width_m
        flat = np.isnan(size[:, 0]) & (seen[:, 2] > _ONE_WIDE * seen[:, 3])
        return np.asarray(wide | flat, np.bool_)


def _ends(regions: Labels, boxes: list[GridBox]) -> tuple[Floats, Floats]:
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
