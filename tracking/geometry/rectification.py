"""Rectified pictures of a stereo pair, and metres out of disparity."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.errors import CalibrationError
from tracking.geometry.camera import Camera
from tracking.geometry.ground import Ground
from tracking.geometry.rectified_rig import rectified_rig
from tracking.geometry.stereo_calibration import StereoCalibration

Image = NDArray[np.uint8]

_LEAST_COVERED = 0.5
_CHECK_STEP_PX = 8


class Rectification:
    """Recorded pixels, rectified pixels, disparity and the world of one stereo rig.

    Rectified images have the recorded size. Disparity is u_left - u_right of a point in the
    rectified pair; `disparity_offset_px` is that of a point at infinity. The world stands below
    the left camera as recorded: rectification turns the camera about its centre, and
    `world_from_rectified` takes that turn back.

    Where the recorded pair is rectified already, `identity` is True and nothing is computed or
    copied.

    Args:
        calibration: of two cameras.
        ground: where the floor is; without it whatever needs metres in the world raises.

    Raises:
        CalibrationError: there is no right camera, or hardly anything of the recorded picture
            would be left in the rectified one.
    """

    def __init__(self, calibration: StereoCalibration, ground: Ground | None) -> None:
        if calibration.right is None:
            raise CalibrationError("calibration: rectification needs two cameras, M2 is missing")
        self.calibration = calibration
        self.ground = ground
        self._left, self._right = calibration.left, calibration.right
        self._rig = rectified_rig(calibration, calibration.right)
        self._maps: tuple[_Map, _Map] | None = None
        if not self.identity:
            self._check_coverage()

    @property
    def identity(self) -> bool:
        """Whether the recorded images are rectified already."""
        return self._rig.identity

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of rectified images in px."""
        return self._left.size

    @property
    def focal_px(self) -> float:
        """Focal length of both rectified cameras."""
        return self._rig.focal_px

    @property
    def principal(self) -> tuple[float, float]:
        """Principal point (cx, cy) of the left rectified camera in px."""
        return self._rig.cx_left, self._rig.cy

    @property
    def disparity_offset_px(self) -> float:
        """Disparity of a point at infinity: cx of the left camera minus cx of the right one."""
        return self._rig.cx_left - self._rig.cx_right

    @property
    def baseline_m(self) -> float:
        """Distance between the camera centres."""
        return self._rig.baseline_m

    @property
    def world_from_rectified(self) -> tuple[Floats, Floats]:
        """Rotation (3, 3) and translation (3,) from rectified left camera axes into the world.

        Raises:
            CalibrationError: the recording does not say where the floor is.
        """
        if self.ground is None:
            raise CalibrationError(
                "ground: metres on the floor need the camera's height and tilt; "
                "give [ground] in recording.toml, or --height and --tilt"
            )
        rotation, centre = self.ground.world_from_camera
        return rotation @ self._rig.left_rotation.T, centre

    def rectify(self, left: Image, right: Image) -> tuple[Image, Image]:
        """Both cameras rectified; the very same arrays where they are so already.

        Pixels that were not recorded are black.
        """
        if self.identity:
            return left, right
        maps = self._both_maps()
        return maps[0].apply(left), maps[1].apply(right)

    def rectify_left(self, left: Image) -> Image:
        """The left camera rectified, as `rectify` does."""
        return left if self.identity else self._both_maps()[0].apply(left)

    def _both_maps(self) -> tuple[_Map, _Map]:
        if self._maps is None:
            pixels = self._grid(1)
            self._maps = (
                _Map(self._recorded(self._left, self._rig.left_rotation, pixels, 0.0), self.size),
                _Map(
                    self._recorded(
                        self._right, self._rig.right_rotation, pixels, self.disparity_offset_px
                    ),
                    self.size,
                ),
            )
        return self._maps

    def recorded_axes(self, direction: Floats) -> Floats:
        """A direction (3,) in rectified axes in those of the left camera as recorded."""
        return np.asarray(self._rig.left_rotation.T @ direction)

    def recorded_from_rectified(self, points: Floats) -> Floats:
        """Left pixels (n, 2) as recorded of rectified left pixels (n, 2)."""
        if self.identity:
            return np.asarray(points, float).reshape(-1, 2)
        return self._recorded(self._left, self._rig.left_rotation, points, 0.0)

    def right_recorded_from_rectified(self, points: Floats) -> Floats:
        """Right pixels (n, 2) as recorded of rectified right pixels (n, 2)."""
        if self.identity:
            return np.asarray(points, float).reshape(-1, 2)
        offset = self.disparity_offset_px
        return self._recorded(self._right, self._rig.right_rotation, points, offset)

    def rectified_from_recorded(self, points: Floats, *, right: bool = False) -> Floats:
        """Rectified pixels (n, 2) of pixels (n, 2) as recorded, both of the same camera."""
        if self.identity:
            return np.asarray(points, float).reshape(-1, 2)
        camera = self._right if right else self._left
        rotation = self._rig.right_rotation if right else self._rig.left_rotation
        rays = camera.undistort(points)
        turned = np.column_stack((rays, np.ones(len(rays)))) @ rotation.T
        return self._rectified(turned) - (self.disparity_offset_px if right else 0.0, 0.0)

    def world_from_disparity(self, u: Floats, v: Floats, disparity: Floats) -> Floats:
        """World points (n, 3) in metres of rectified left pixels and their disparity (n,) px.

        NaN where the disparity is that of infinity or less.
        """
        cx, cy = self.principal
        d = np.asarray(disparity, float) - self.disparity_offset_px
        per_px = np.divide(self.baseline_m, d, out=np.full(d.shape, np.nan), where=d > 0)
        points = np.empty((d.size, 3))
        points[:, 0] = (u - cx) * per_px
        points[:, 1] = (v - cy) * per_px
        points[:, 2] = self.focal_px * per_px
        rotation, centre = self.world_from_rectified
        return points @ rotation.T + centre

    def rectified_from_world(self, points: Floats) -> Floats:
        """Rectified left pixels (n, 2) of world points (n, 3); NaN behind the camera."""
        return self._rectified(self._in_rectified_axes(points))

    def disparity_from_world(self, points: Floats) -> Floats:
        """Disparity (n,) in px of world points (n, 3); NaN behind the camera."""
        depth = self._in_rectified_axes(points)[:, 2]
        depth = np.where(depth > 1e-9, depth, np.nan)
        return self.focal_px * self.baseline_m / depth + self.disparity_offset_px

    def right_pixel_from_world(self, points: Floats) -> Floats:
        """Right pixels (n, 2) as recorded of world points (n, 3); NaN behind the camera."""
        in_left = self._in_rectified_axes(points) @ self._rig.left_rotation
        in_right = in_left @ self.calibration.rotation.T + self.calibration.translation
        return self._right.project(in_right)

    def _in_rectified_axes(self, points: Floats) -> Floats:
        rotation, centre = self.world_from_rectified
        return (np.asarray(points, float).reshape(-1, 3) - centre) @ rotation

    def _rectified(self, points: Floats) -> Floats:
        """Rectified left pixels (n, 2) of points (n, 3) in rectified axes."""
        depth = np.where(points[:, 2:] > 1e-9, points[:, 2:], np.nan)
        return points[:, :2] / depth * self.focal_px + self.principal

    def _recorded(
        self, camera: Camera, rotation: Floats, points: Floats, offset_px: float
    ) -> Floats:
        """A camera's pixels (n, 2) as recorded of its rectified pixels (n, 2)."""
        points = np.asarray(points, float).reshape(-1, 2)
        cx, cy = self.principal
        rays = np.column_stack(
            (
                (points[:, 0] + offset_px - cx) / self.focal_px,
                (points[:, 1] - cy) / self.focal_px,
                np.ones(len(points)),
            )
        )
        return camera.project(rays @ rotation)

    def _grid(self, step: int) -> Floats:
        """Every step-th pixel (n, 2) of the rectified image, row by row."""
        u, v = np.meshgrid(*(np.arange(0.0, length, step) for length in self.size))
        return np.column_stack((u.ravel(), v.ravel()))

    def _check_coverage(self) -> None:
        grid, last = self._grid(_CHECK_STEP_PX), np.array(self.size) - 1
        covered = 1.0
        for recorded in (
            self.recorded_from_rectified(grid),
            self.right_recorded_from_rectified(grid),
        ):
            inside = ((recorded >= 0) & (recorded <= last)).all(axis=1)
            covered = min(covered, float(inside.mean()))
        if covered < _LEAST_COVERED:
            raise CalibrationError(
                "calibration: only {covered:.0%} of the rectified image would be covered; the "
                "stereo calibration is not usable, calibrate again",
                covered=covered,
            )


class _Map:
    """Where each rectified pixel comes from, in OpenCV's fast fixed-point form."""

    def __init__(self, recorded: Floats, size: tuple[int, int]) -> None:
        # Pixels behind the camera come from nowhere: far outside, so that they stay black.
        known = np.nan_to_num(recorded, nan=-1e4).astype(np.float32)
        known = known.clip(-1e4, 3e4).reshape(size[1], size[0], 2)
        self._whole, self._fraction = cv2.convertMaps(known, np.empty(0, np.float32), cv2.CV_16SC2)

    def apply(self, image: Image) -> Image:
        """The image seen through the map."""
        seen = cv2.remap(image, self._whole, self._fraction, cv2.INTER_LINEAR)
        return np.asarray(seen, np.uint8)
