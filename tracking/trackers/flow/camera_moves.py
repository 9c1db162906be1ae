"""Whether the camera still stands as it did: marks of the background looked for again."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

Grey = NDArray[np.uint8]

_EVERY_S = 1.0
_MARKS, _FEWEST = 80, 15
_APART_PX = 24
_MOVED_PX, _ALIKE_PX = 2.0, 1.5
_SHARE = 0.5
"""Of the marks found, how many must have moved alike."""
_RETURN_PX = 1.0
_WINDOW = (15, 15)


class CameraWatch:
    """Marks taken from a picture, and found again about once a second.

    People cover some of them and never move most of them alike; a camera that was pushed does.
    """

    def __init__(self, fps: float) -> None:
        """`fps`: frames a second."""
        self._every = max(1, round(_EVERY_S * fps))
        self._count = 0
        self._grey: Grey | None = None
        self._marks: NDArray[np.float32] = np.zeros((0, 1, 2), np.float32)

    def moved(self, grey: Grey) -> bool:
        """Whether the camera stands otherwise than when the marks were taken; takes new ones then.

        Looks at every so-manieth picture only.
        """
        self._count += 1
        if self._grey is None:
            self._take(grey)
            return False
        if self._count % self._every:
            return False
        shift = self._shifts(self._grey, grey)
        if len(shift) < _FEWEST:
            self._take(grey)
            return False
        middle = np.median(shift, axis=0)
        alike = np.hypot(*(shift - middle).T) < _ALIKE_PX
        far = float(np.hypot(*middle)) > _MOVED_PX
        if not far or alike.mean() < _SHARE:
            return False
        self._take(grey)
        return True

    def _take(self, grey: Grey) -> None:
        marks = cv2.goodFeaturesToTrack(grey, _MARKS, 0.02, _APART_PX)
        self._grey = grey
        none = np.zeros((0, 1, 2), np.float32)
        self._marks = none if marks is None else np.asarray(marks, np.float32)

    def _shifts(self, before: Grey, grey: Grey) -> NDArray[np.float32]:
        """(k, 2) px by which the marks found again lie elsewhere."""
        if not len(self._marks):
            return np.zeros((0, 2), np.float32)
        there, found, _ = cv2.calcOpticalFlowPyrLK(
            before, grey, self._marks, np.empty(0), winSize=_WINDOW, maxLevel=4
        )
        back, again, _ = cv2.calcOpticalFlowPyrLK(
            grey, before, there, np.empty(0), winSize=_WINDOW, maxLevel=4
        )
        good = (found[:, 0] > 0) & (again[:, 0] > 0)
        good &= np.hypot(*(back - self._marks)[:, 0].T) < _RETURN_PX
        return np.asarray((there - self._marks)[good, 0], np.float32)
