"""One camera: a pinhole with lens distortion, or a fisheye."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from tracking.arrays import Floats
from tracking.errors import CalibrationError
from tracking.geometry.fisheye_lens import FisheyeLens
from tracking.geometry.lens import Lens

DISTORTION_LENGTHS = (0, 4, 5, 8, 12, 14)
"""Numbers of distortion coefficients that OpenCV's model knows."""
FISHEYE_LENGTHS = (0, 4)
"""Those of its fisheye model."""
MOST_SIDE_PX = 100_000
"""Of an image; files that tell more are damaged."""


@dataclass(frozen=True, slots=True, eq=False)
class Camera:
    """A camera as OpenCV has it: x right, y down, z forward.

    Attributes:
        matrix: (3, 3) focal lengths and principal point in px; pixel centres at integers.
        distortion: (k,) OpenCV's coefficients; empty or zero: none, or an exact fisheye.
        width, height: size in px of the images it takes.
        fisheye: the lens follows Kannala and Brandt's model (OpenCV's `fisheye`, "equidistant").

    Raises:
        CalibrationError: a value has the wrong shape, is not finite or makes no camera.
    """

    matrix: Floats
    distortion: Floats
    width: int
    height: int
    fisheye: bool = False
    lens: Lens | FisheyeLens = field(init=False, repr=False)

    def __post_init__(self) -> None:
        matrix = np.array(self.matrix, float)
        distortion = np.array(self.distortion, float).ravel()
        _check_matrix(matrix)
        lengths = FISHEYE_LENGTHS if self.fisheye else DISTORTION_LENGTHS
        if distortion.size not in lengths or not np.isfinite(distortion).all():
            raise CalibrationError(
                "calibration: {size} distortion coefficients are not one of {lengths} finite "
                "numbers; calibrate with OpenCV's pinhole or fisheye model",
                size=distortion.size,
                lengths=lengths,
            )
        if max(self.width, self.height) > MOST_SIDE_PX:
            raise CalibrationError(
                "calibration: an image of more than {most} px a side is none; set image_width and "
                "image_height",
                most=MOST_SIDE_PX,
            )
        if self.width < 1 or self.height < 1:
            raise CalibrationError(
                "calibration: an image of {width} x {height} px is none; set image_width and "
                "image_height",
                width=self.width,
                height=self.height,
            )
        object.__setattr__(self, "matrix", matrix)
        object.__setattr__(self, "distortion", distortion)
        kind = FisheyeLens if self.fisheye else Lens
        object.__setattr__(self, "lens", kind.from_coefficients(distortion))

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of its images in px."""
        return self.width, self.height

    def scaled_to(self, size: tuple[int, int]) -> Camera:
        """The same camera whose images were made this large (width, height)."""
        scale = np.array(size, float) / self.size
        matrix = self.matrix.copy()
        matrix[:2] *= scale[:, None]
        matrix[:2, 2] += 0.5 * scale - 0.5  # pixel centres are whole numbers
        return Camera(matrix, self.distortion, *size, fisheye=self.fisheye)

    def undistort(self, points: Floats) -> Floats:
        """Ideal rays (n, 2), x / z and y / z, of pixels (n, 2) as recorded."""
        points = np.asarray(points, float).reshape(-1, 2)
        y = (points[:, 1] - self.matrix[1, 2]) / self.matrix[1, 1]
        x = (points[:, 0] - self.matrix[0, 2] - self.matrix[0, 1] * y) / self.matrix[0, 0]
        return self.lens.undistort(np.column_stack((x, y)))

    def project(self, points_camera: Floats) -> Floats:
        """Pixels (n, 2) as recorded of points (n, 3) in camera axes; NaN at or behind it."""
        points = np.asarray(points_camera, float).reshape(-1, 3)
        depth = np.where(points[:, 2:] > 1e-9, points[:, 2:], np.nan)
        shown = self.lens.distort(points[:, :2] / depth)
        return shown @ self.matrix[:2, :2].T + self.matrix[:2, 2]


def _check_matrix(matrix: Floats) -> None:
    if matrix.shape != (3, 3) or not np.isfinite(matrix).all():
        raise CalibrationError(
            "calibration: the camera matrix is {shape}, not 3 x 3 finite numbers",
            shape=matrix.shape,
        )
    upright = matrix[0, 0] > 0 and matrix[1, 1] > 0 and matrix[1, 0] == 0
    if not upright or not np.array_equal(matrix[2], (0, 0, 1)):
        raise CalibrationError(
            "calibration: the camera matrix is not [fx s cx; 0 fy cy; 0 0 1] with positive "
            "focal lengths; calibrate again"
        )
