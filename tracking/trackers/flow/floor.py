"""From points of the picture to people on the floor, and back."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import View

Floats = NDArray[np.float64]

USUAL_Z_M = 1.2
_SURE_OF_Z = 0.02
"""How strongly heights are drawn to the usual one: it decides only straight below the camera."""
LOWEST_M = 0.05
_FOOT_M = 1e-6
"""Straight below the camera no direction leads away from it: that along y is taken."""
_NEAREST_M = 1e-9
"""What is no farther before the camera is not seen."""


class Floor:
    """The floor under a camera, for points whose height over it is known, or whose person is.

    A point's *slope* is where its ray goes, in metres along the floor for each metre of drop: at
    height z it is at `slope * (camera height - z)` from the camera's foot.
    """

    def __init__(self, view: View) -> None:
        self.view = view
        rotation, centre = view.world_from_camera
        self.camera_m = float(centre[2])
        self._onto = view.camera.matrix @ rotation.T
        self._moved = -self._onto @ centre
        self._bent = not view.camera.lens.is_ideal

    def slopes(self, points: Floats) -> Floats:
        """(n, 2) of points (n, 2) px; NaN at or above the horizon."""
        return self.view.floor_from_pixel(np.asarray(points, np.float64)) / self.camera_m

    def places(self, slope: Floats, z_m: Floats) -> Floats:
        """(n, 2) world metres of points with these slopes and heights."""
        return slope * (self.camera_m - z_m)[..., None]

    def heights(self, slope: Floats, axis: Floats) -> Floats:
        """(...,) m over the floor at which rays pass a person's upright axis most closely.

        Args:
            slope: (..., 2). axis: (..., 2) world metres.
        """
        steep = (slope**2).sum(axis=-1)
        drop = ((slope * axis).sum(axis=-1) + _SURE_OF_Z * (self.camera_m - USUAL_Z_M)) / (
            steep + _SURE_OF_Z
        )
        return np.asarray(self.camera_m - drop)

    def pixels(self, place: Floats, z_m: Floats) -> Floats:
        """(..., 2) px of points over floor places (..., 2) at heights (...)."""
        if not self._bent:
            return self._straight_pixels(place, z_m)
        z_m = np.broadcast_to(z_m, place.shape[:-1])
        world = np.concatenate((place, z_m[..., None]), axis=-1)
        return self.view.pixel_from_world(world.reshape(-1, 3)).reshape(place.shape)

    def _straight_pixels(self, place: Floats, z_m: Floats) -> Floats:
        """The same without a lens that bends: this is where the tracker spends its time."""
        x, y = place[..., 0], place[..., 1]
        shown = np.empty(place.shape)
        u, v, depth = (
            one[0] * x + one[1] * y + (one[2] * z_m + moved)
            for one, moved in zip(self._onto, self._moved, strict=True)
        )
        depth = np.where(depth > _NEAREST_M, depth, np.nan)
        np.divide(u, depth, out=shown[..., 0])
        np.divide(v, depth, out=shown[..., 1])
        return shown


def in_picture(place: Floats, z_m: float, floor: Floor) -> NDArray[np.bool_]:
    """(m,) whether what is so high over places (m, 2) lies in the picture."""
    pixel = floor.pixels(place, np.array(z_m))
    return np.asarray(((pixel > 0) & (pixel < np.array(floor.view.camera.size))).all(axis=-1))


def sight_axes(place: Floats) -> Floats:
    """(..., 2, 2) unit vectors on the floor: along the line of sight and across it."""
    x, y = place[..., 0], place[..., 1]
    distance = np.hypot(x, y)
    somewhere = distance > _FOOT_M
    distance = np.maximum(distance, _FOOT_M)
    axes = np.empty((*place.shape, 2))
    axes[..., 0, 0] = axes[..., 1, 1] = np.where(somewhere, x / distance, 0.0)
    axes[..., 0, 1] = axes[..., 1, 0] = np.where(somewhere, y / distance, 1.0)
    np.negative(axes[..., 1, 1], out=axes[..., 1, 1])
    return axes
