"""People of a stereo recording by its left camera alone, while the right one fails."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats, Mask
from tracking.foreground import PERHAPS, Subtraction
from tracking.geometry import Camera, Ground, Rectification, View
from tracking.people import upright
from tracking.people.body_scale import Standing
from tracking.people.boxes import recorded_boxes
from tracking.people.detections import Detections
from tracking.people.ghosts import without_ghosts
from tracking.people.region_features import described
from tracking.people.regions_of_people import people_regions
from tracking.people.settings import PeopleSettings

_FARTHEST_M = 25.0
"""Farther off, a pixel more or less of the feet is metres on the floor."""


@dataclass(frozen=True, slots=True, eq=False)
class RectifiedView(View):
    """The left camera as it looks after rectification.

    Attributes:
        turned: rotation (3, 3) and translation (3,) from its axes into the world.
    """

    turned: tuple[Floats, Floats]

    @property
    def world_from_camera(self) -> tuple[Floats, Floats]:
        """Rotation (3, 3) and translation (3,) in metres from camera axes into the world."""
        return self.turned


class OneCamera:
    """Finds people as in recordings of one camera: silhouettes on the floor, no range.

    Args:
        rectification: of the recording. ground: where the floor is.
        shrink: recorded pixels per working pixel. settings: of people.
    """

    def __init__(
        self, rectification: Rectification, ground: Ground, shrink: int, settings: PeopleSettings
    ) -> None:
        (cx, cy), focal = rectification.principal, rectification.focal_px
        matrix = np.array([[focal, 0.0, cx], [0.0, focal, cy], [0.0, 0.0, 1.0]])
        camera = Camera(matrix, np.zeros(0), *rectification.size)
        view = RectifiedView(camera, ground, rectification.world_from_rectified)
        self._rectification = rectification
        self._standing = Standing(view, shrink, settings)
        self._settings = settings

    def find(self, left: Subtraction, shadow: Mask) -> Detections:
        """The people in the left camera's foreground.

        Args:
            left: of this frame. shadow: (height, width) of `ShadowRemover`.
        """
        kind = left.mask.copy()
        kind[shadow == PERHAPS] = upright.PERHAPS
        kind[shadow == 255] = upright.SHADOW
        regions = people_regions(kind, self._standing)
        regions = without_ghosts(regions, left.picture, left.background, floor_known=True)
        width, height = self._rectification.size
        people = described(regions, left.picture, (height, width), self._standing, self._settings)
        people = people.chosen(_on_the_floor(people))
        return replace(people, box=recorded_boxes(people.box, self._rectification))


def _on_the_floor(people: Detections) -> NDArray[np.bool_]:
    """(n,) who stands somewhere near; at the horizon one camera places nobody."""
    away = np.hypot(people.position[:, 0], people.position[:, 1])
    return np.asarray(np.nan_to_num(away, nan=np.inf) < _FARTHEST_M, np.bool_)
