"""Whether the camera stands still."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

_EVERY_S = 0.5
_WIDE_PX = 160
"""Width of the pictures compared."""
_MOVED_PX = 1.0
"""Of such a picture, that counts as moved."""
_CLEAR = 0.15
"""Height of the correlation's peak from which it tells anything."""
_LOOKS = 3
"""So many looks that tell of a movement, to be sure: a light switched on moves nothing."""


class Steadiness:
    """Compares each picture with one half a second before, as a whole.

    People who walk move parts of the picture; a camera that turns moves all of it by as much.

    Attributes:
        moved_at: the first frame in which it had moved; None while it stands still.
    """

    def __init__(self, fps: float) -> None:
        self.moved_at: int | None = None
        self._every = max(1, round(fps * _EVERY_S))
        self._before: NDArray[np.float32] | None = None
        self._window = np.zeros(0, np.float32)
        self._suspected: list[int] = []

    def look(self, frame: int, picture: NDArray[np.uint8]) -> None:
        """Take notice of a frame; only one in half a second is looked at.

        Args:
            picture: (height, width, 3) uint8.
        """
        if self.moved_at is not None or frame % self._every:
            return
        small = _small(picture)
        if self._before is not None and self._before.shape == small.shape:
            (right, down), clear = cv2.phaseCorrelate(self._before, small, self._window)
            if np.hypot(right, down) > _MOVED_PX and clear > _CLEAR:
                self._suspected.append(frame)
        else:
            self._window = np.asarray(cv2.createHanningWindow(small.shape[::-1], cv2.CV_32F))
        self._before = small
        if len(self._suspected) >= _LOOKS:
            self.moved_at = self._suspected[0]


def _small(picture: NDArray[np.uint8]) -> NDArray[np.float32]:
    height = round(picture.shape[0] * _WIDE_PX / picture.shape[1])
    light = cv2.extractChannel(picture, 1)
    shrunk = cv2.resize(light, (_WIDE_PX, max(height, 2)), interpolation=cv2.INTER_AREA)
    return np.asarray(cv2.Laplacian(shrunk, cv2.CV_32F), np.float32)
