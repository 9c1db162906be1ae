"""The right camera's view of the boxes drawn in the left one."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import Rectification

_MIDDLE_M = 0.85
"""Height of a person's middle: its range stands for the whole box."""


def boxes_in_right_image(
    rectification: Rectification, boxes: NDArray[np.float64], floor: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Boxes (n, 4) of the left camera as the right camera sees them, in its pixels as recorded.

    Each box is moved along the rectified rows by the disparity at its person's range. NaN where
    the place on the floor (n, 2) metres is unknown.
    """
    middle = np.column_stack((floor, np.full(len(floor), _MIDDLE_M)))
    disparity = rectification.disparity_from_world(middle)
    corners = _corners(boxes)
    rectified = rectification.rectified_from_recorded(corners.reshape(-1, 2)).reshape(-1, 4, 2)
    rectified[..., 0] -= disparity[:, None]
    right = rectification.right_recorded_from_rectified(rectified.reshape(-1, 2)).reshape(-1, 4, 2)
    low, high = right.min(axis=1), right.max(axis=1)
    return np.concatenate((low, high - low), axis=1)


def _corners(boxes: NDArray[np.float64]) -> NDArray[np.float64]:
    """(n, 4, 2) corners of the boxes."""
    left, top, width, height = boxes.T
    across = np.stack((left, left + width, left + width, left), axis=1)
    down = np.stack((top, top, top + height, top + height), axis=1)
    return np.stack((across, down), axis=2)
