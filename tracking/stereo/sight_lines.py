"""Where every pixel of the rectified left camera looks in the world."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import Rectification

Floats = NDArray[np.float32]


class SightLines:
    """Rays of a rectified left camera, at the working scale.

    A point seen at depth Z lies at `centre + Z * rays[v, u]`; Z is metres along the optical axis.

    Attributes:
        shrink: recorded pixels per working pixel.
        centre: (3,) world metres of the left camera.
        rightward: (3,) unit vector in the world along the picture's rows.
        rays: (height, width, 3) float32, world metres per metre of depth.
        focal_baseline: px m; depth is this over the disparity less `offset`, in working pixels.
        offset: px, the disparity of a point infinitely far away.
    """

    def __init__(self, rectification: Rectification, shrink: int = 1) -> None:
        width, height = (side // shrink for side in rectification.size)
        u, v = np.meshgrid(
            (np.arange(width) + 0.5) * shrink - 0.5, (np.arange(height) + 0.5) * shrink - 0.5
        )
        product = rectification.focal_px * rectification.baseline_m
        near, far = (
            rectification.world_from_disparity(
                u.ravel(),
                v.ravel(),
                np.full(u.size, product / z + rectification.disparity_offset_px),
            )
            for z in (1.0, 2.0)
        )
        self.shrink = shrink
        self.rays: Floats = (far - near).reshape(height, width, 3).astype(np.float32)
        across = self.rays[0, 1] - self.rays[0, 0]
        self.rightward: Floats = across / np.linalg.norm(across)
        self.centre: NDArray[np.float64] = np.asarray((2 * near - far).mean(axis=0))
        self.focal_baseline = product / shrink
        self.focal = rectification.focal_px / shrink
        self.offset = rectification.disparity_offset_px / shrink

    @property
    def shape(self) -> tuple[int, int]:
        """Height and width in working pixels."""
        return self.rays.shape[0], self.rays.shape[1]

    def disparity_at_height(self, z_m: float, nearest_m: float, farthest_m: float) -> Floats:
        """(height, width) the disparity of the level z = z_m where each pixel sees it.

        The level lies below the camera for pixels that look down; others see it nowhere and get the
        disparity of `farthest_m`. Clipped to the given depths.
        """
        down = np.minimum(self.rays[..., 2], -1e-6)
        depth = (z_m - self.centre[2]) / down if z_m < self.centre[2] else np.full_like(down, 0)
        depth = np.clip(depth, nearest_m, farthest_m)
        return np.asarray(self.focal_baseline / depth + self.offset, np.float32)

    def depth(self, disparity: Floats) -> Floats:
        """Depth in metres along the optical axis; NaN where the disparity is NaN."""
        return np.asarray(self.focal_baseline / (disparity - self.offset), np.float32)
