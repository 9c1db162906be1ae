"""The pair of cameras that looks at a scene."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import Camera, Ground, StereoCalibration, View
from tracking.synthesis.specs import SceneSpec

BASELINE_M = 0.12
"""Distance of the cameras in [Kawashita2012] and [Kawashita2014]."""

NEAREST_M = 0.25
"""What is nearer to a camera than this is not drawn."""


@dataclass(frozen=True, slots=True, eq=False)
class Rig:
    """A rectified, distortion-free stereo pair over its floor.

    Attributes:
        view: the left camera on the floor.
        calibration: both cameras.
    """

    view: View
    calibration: StereoCalibration

    @classmethod
    def of_scene(cls, spec: SceneSpec, size: tuple[int, int]) -> Rig:
        """The rig of a scene for images of `size` (width, height) px."""
        width, height = size
        focal = spec.focal * width
        # Real lenses sit a little beside the sensor's middle.
        centre = ((width - 1) / 2 + 0.0044 * width, (height - 1) / 2 - 0.003 * height)
        matrix = np.array([[focal, 0.0, centre[0]], [0.0, focal, centre[1]], [0.0, 0.0, 1.0]])
        camera = Camera(matrix, np.zeros(5), width, height)
        translation = np.array([-BASELINE_M, 0.0, 0.0])
        return cls(
            View(camera, Ground(spec.height_m, spec.tilt_deg, spec.roll_deg)),
            StereoCalibration(camera, camera, np.eye(3), translation),
        )

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of the images in px."""
        return self.view.camera.size

    @property
    def focal_px(self) -> float:
        """Focal length, the same both ways and in both cameras."""
        return float(self.view.camera.matrix[0, 0])

    @property
    def principal_px(self) -> tuple[float, float]:
        """Where the optical axis meets the image, the same in both cameras."""
        return float(self.view.camera.matrix[0, 2]), float(self.view.camera.matrix[1, 2])

    def left_camera_points(self, world: NDArray[np.floating]) -> NDArray[np.float64]:
        """World points (..., 3) in the axes of the left camera."""
        rotation, centre = self.view.world_from_camera
        return (world - centre) @ rotation

    def project(self, points: NDArray[np.float64], side: int) -> NDArray[np.float64]:
        """Pixels and inverse depth (..., 3) of points (..., 3) in left camera axes.

        Args:
            points: as `left_camera_points` gives them.
            side: 0 left, 1 right.

        Returns:
            u, v, 1 / z; NaN where the point is nearer than `NEAREST_M`.
        """
        depth = np.where(points[..., 2] > NEAREST_M, points[..., 2], np.nan)
        inverse = 1.0 / depth
        across = points[..., 0] - side * BASELINE_M
        u = self.focal_px * across * inverse + self.principal_px[0]
        v = self.focal_px * points[..., 1] * inverse + self.principal_px[1]
        return np.stack((u, v, inverse), axis=-1)

    def floor_to_pixel(self, side: int) -> NDArray[np.float64]:
        """Homography (3, 3) from floor x, y in metres to pixels of a camera."""
        rotation, centre = self.view.world_from_camera
        shift = -rotation.T @ centre - np.array([side * BASELINE_M, 0.0, 0.0])
        flat = np.column_stack((rotation.T[:, 0], rotation.T[:, 1], shift))
        return np.asarray(self.view.camera.matrix @ flat, float)

    def rays(self, pixels: NDArray[np.float64]) -> NDArray[np.float64]:
        """World directions (..., 3) of pixels (..., 2), the same for both cameras."""
        rotation, _ = self.view.world_from_camera
        u0, v0 = self.principal_px
        camera = np.stack(
            (
                (pixels[..., 0] - u0) / self.focal_px,
                (pixels[..., 1] - v0) / self.focal_px,
                np.ones(pixels.shape[:-1]),
            ),
            axis=-1,
        )
        return np.asarray(camera @ rotation.T, float)

    def camera_centre(self, side: int) -> NDArray[np.float64]:
        """World position (3,) of a camera."""
        rotation, centre = self.view.world_from_camera
        return np.asarray(centre + side * BASELINE_M * rotation[:, 0], float)

    def sees(self, box: NDArray[np.float64], margin_px: float = 0.0) -> bool:
        """Whether a box (left, top, width, height) of the left image lies partly in a camera.

        A box that cannot be told (partly behind the camera) counts as seen.
        """
        width, height = self.size
        if np.isnan(box).any():
            return True
        # The right camera sees a person up to this much farther left.
        parallax = self.focal_px * BASELINE_M
        left, top, right, bottom = box[0], box[1], box[0] + box[2], box[1] + box[3]
        return bool(
            right > -margin_px
            and left - parallax < width + margin_px
            and bottom > -margin_px
            and top < height + margin_px
        )
