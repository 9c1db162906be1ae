"""Both cameras rectified, with level lines: what a calibration does to the images of a pair."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from tracking.calibration.rough import match_images
from tracking.geometry import Rectification, StereoCalibration
from tracking.recording.frame import Image

_LINES = 12
_LINE = (90, 220, 120)
"""BGR."""
_FEWEST = 20
"""Matched points by which rows are judged."""
_FAR_PX = 20.0
"""Matches whose rows are farther apart are wrong, or tell that the calibration does not fit."""


@dataclass(frozen=True, slots=True, eq=False)
class RectifiedPreview:
    """A rectified pair.

    Attributes:
        image: left and right beside each other, with level lines.
        row_error_px: usual distance of rows of the same point in both; None: too few were matched.
        points: matched.
    """

    image: Image
    row_error_px: float | None
    points: int


def rectified_preview(
    calibration: StereoCalibration, left: Image, right: Image
) -> RectifiedPreview:
    """Rectify a pair of images as recorded.

    Raises:
        CalibrationError: the two cameras cannot be rectified.
    """
    views = Rectification(calibration, None).rectify(left, right)
    points = match_images([views]).points
    rows = np.abs(points[:, 0, 1] - points[:, 1, 1])
    rows = rows[rows < _FAR_PX]
    error_px = float(np.median(rows)) if len(rows) >= _FEWEST else None
    image = np.concatenate(views, axis=1).copy()
    for y in np.linspace(0, image.shape[0] - 1, _LINES + 2)[1:-1].round().astype(int).tolist():
        cv2.line(image, (0, y), (image.shape[1] - 1, y), _LINE, max(1, image.shape[1] // 1000))
    return RectifiedPreview(image, error_px, len(rows))
