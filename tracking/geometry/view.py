"""The left camera standing over its floor: pixels to world and back."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from tracking.arrays import Floats
from tracking.geometry.camera import Camera
from tracking.geometry.ground import Ground

_BODY_RINGS = ((0.0, 0.35), (0.1, 0.8), (0.5, 1.0), (0.8, 1.0), (0.93, 0.5), (1.0, 0.3))
"""A standing person as rings: height and radius as shares of body height and half width."""
_RING_POINTS = 12
_BORDER_POINTS = 24
_AT_ONCE = 10_000
"""People whose outlines are projected in one go: those of hours of footage outgrow memory."""


@dataclass(frozen=True, slots=True, eq=False)
class View:
    """The left (or only) camera on the floor.

    Attributes:
        camera: the camera as it records.
        ground: where the floor is.
    """

    camera: Camera
    ground: Ground

    @property
    def world_from_camera(self) -> tuple[Floats, Floats]:
        """Rotation (3, 3) and translation (3,) in metres from camera axes into the world."""
        return self.ground.world_from_camera

    def floor_from_pixel(self, points: Floats, z_m: float | Floats = 0.0) -> Floats:
        """World x, y (n, 2) in metres of pixels (n, 2) as recorded, on the plane z = z_m.

        Args:
            points: pixels of the image as recorded.
            z_m: height of the horizontal plane, one for all points or (n,).

        Returns:
            NaN where the pixel's ray never meets the plane: at or above the horizon.
        """
        rays = self._rays(points)
        rotation, centre = self.world_from_camera
        directions = rays @ rotation.T
        with np.errstate(divide="ignore", invalid="ignore"):
            along = (np.asarray(z_m, float) - centre[2]) / directions[:, 2]
        # A hair's breadth below the horizon is a floor point light-years away: none either.
        along = np.where((along > 0) & (along < 1e6), along, np.nan)
        return directions[:, :2] * along[:, None] + centre[:2]

    def pixel_from_world(self, points: Floats) -> Floats:
        """Pixels (n, 2) as recorded of world points (n, 3) in metres; NaN behind the camera."""
        rotation, centre = self.world_from_camera
        points = np.asarray(points, float).reshape(-1, 3)
        return self.camera.project((points - centre) @ rotation)

    def field_of_view(self, max_range_m: float = 30.0) -> Floats:
        """The floor the camera sees, as a polygon (k, 2) of world metres.

        It runs round the image's border clockwise from the top left corner; what lies farther
        than `max_range_m` from the origin, or above the horizon, is drawn in to that distance.
        """
        rotation, centre = self.world_from_camera
        directions = self._rays(_border(*self.camera.size)) @ rotation.T
        level = np.hypot(directions[:, 0], directions[:, 1])
        with np.errstate(divide="ignore"):
            reach = np.where(directions[:, 2] < 0, centre[2] * level / -directions[:, 2], np.inf)
        reach = np.minimum(reach, max_range_m)
        return directions[:, :2] / np.maximum(level, 1e-12)[:, None] * reach[:, None]

    def box_of_person(self, xy: Floats, height_m: float, width_m: float) -> Floats:
        """Boxes (n, 4), left, top, width, height in px as recorded, of people standing at xy.

        Args:
            xy: (n, 2) floor positions in metres.
            height_m: body height.
            width_m: body width, from all sides.

        Returns:
            NaN for people who are in part behind the camera; boxes may reach out of the image.
        """
        xy = np.asarray(xy, float).reshape(-1, 2)
        if len(xy) > _AT_ONCE:
            parts = np.array_split(xy, -(-len(xy) // _AT_ONCE))
            return np.concatenate([self.box_of_person(part, height_m, width_m) for part in parts])
        body = _body(height_m, width_m)
        points = np.concatenate((xy, np.zeros((len(xy), 1))), axis=1)[:, None] + body
        pixels = self.pixel_from_world(points.reshape(-1, 3)).reshape(len(xy), len(body), 2)
        low, high = pixels.min(axis=1), pixels.max(axis=1)
        return np.concatenate((low, high - low), axis=1)

    def _rays(self, points: Floats) -> Floats:
        """Directions (n, 3) in camera axes with z = 1."""
        rays = self.camera.undistort(points)
        return np.column_stack((rays, np.ones(len(rays))))


def _border(width: int, height: int) -> Floats:
    """Pixels (k, 2) along the image's outer edge, clockwise from the top left."""
    share = np.arange(_BORDER_POINTS) / _BORDER_POINTS
    corners = np.array([[0, 0], [width, 0], [width, height], [0, height], [0, 0]]) - 0.5
    return np.concatenate([a + share[:, None] * (b - a) for a, b in pairwise(corners)])


def _body(height_m: float, width_m: float) -> Floats:
    """Points (k, 3) on a standing person's outline, feet at the origin."""
    angle = np.arange(_RING_POINTS) * (2 * np.pi / _RING_POINTS)
    circle = np.column_stack((np.cos(angle), np.sin(angle))) * (width_m / 2)
    rings = [
        np.column_stack((circle * radius, np.full(_RING_POINTS, z * height_m)))
        for z, radius in _BODY_RINGS
    ]
    return np.concatenate(rings)
