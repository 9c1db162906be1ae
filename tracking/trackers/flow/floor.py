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


class Floor:
    """The floor under a camera, for points whose height over it is known, or whose person is.

    A point's *slope* is where its ray goes, in metres along the floor for each metre of drop: at
    height z it is at `slope * (camera height - z)` from the camera's foot.
    """

    def __init__(self, view: View) -> None:
        self.view = view
        self.camera_m = float(view.world_from_camera[1][2])

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
        z_m = np.broadcast_to(z_m, place.shape[:-1])
        world = np.concatenate((place, z_m[..., None]), axis=-1)
        return self.view.pixel_from_world(world.reshape(-1, 3)).reshape(place.shape)


def sight_axes(place: Floats) -> Floats:
    """(..., 2, 2) unit vectors on the floor: along the line of sight and across it."""
    distance = np.hypot(place[..., 0], place[..., 1])[..., None]
    along = np.where(distance > 1e-6, place / np.maximum(distance, 1e-6), (0.0, 1.0))
    across = np.stack((along[..., 1], -along[..., 0]), axis=-1)
    return np.stack((along, across), axis=-2)
