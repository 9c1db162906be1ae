"""Whether the camera stands still."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

Picture = NDArray[np.uint8]

_EVERY_S = 0.5
_WIDE_PX = 320
"""Width of the pictures compared."""
_POINTS, _FEWEST = 80, 15
_MOVED_PX = 1.0
"""Of such a picture, that counts as moved."""
_ALIKE_PX, _SHARE = 0.7, 0.6
"""So many of the points must have moved by about as much: people move some, a camera all."""


class Steadiness:
    """Compares each picture with one half a second before, by the corners of the scene.

    Attributes:
        moved_at: the first frame in which the camera had moved; None while it stands still.
    """

    def __init__(self, fps: float) -> None:
        self.moved_at: int | None = None
        self._every = max(1, round(fps * _EVERY_S))
        self._before: Picture | None = None

    def look(self, frame: int, picture: Picture) -> None:
        """Take notice of a frame; only one in half a second is looked at.

        Args:
            picture: (height, width, 3) uint8.
        """
        if self.moved_at is not None or frame % self._every:
            return
        small = _small(picture)
        if self._before is not None and _has_moved(self._before, small):
            self.moved_at = frame
        self._before = small


def _small(picture: Picture) -> Picture:
    height = max(2, round(picture.shape[0] * _WIDE_PX / picture.shape[1]))
    light = cv2.extractChannel(picture, 1)
    return np.asarray(cv2.resize(light, (_WIDE_PX, height), interpolation=cv2.INTER_AREA), np.uint8)


def _has_moved(before: Picture, now: Picture) -> bool:
    """Whether most corners are elsewhere, all by about as much."""
    corners = cv2.goodFeaturesToTrack(before, _POINTS, 0.02, 7.0)
    if corners is None or len(corners) < _FEWEST:
        return False
    start = np.asarray(corners, np.float32)
    found, state, _ = cv2.calcOpticalFlowPyrLK(before, now, start, np.zeros_like(start))
    good = state.ravel() == 1
    if np.count_nonzero(good) < _FEWEST:
        return False
    shift = (found - start).reshape(-1, 2)[good]
    middle = np.median(shift, axis=0)
    alike = np.hypot(*(shift - middle).T) < _ALIKE_PX
    return bool(np.hypot(*middle) > _MOVED_PX and alike.mean() > _SHARE)
