"""What a background holds of places that were overexposed when it was learnt."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Mask, Picture

_OVEREXPOSED = 250
_DIMMED = 0.95
"""Share of the light it was learnt in, below which more is seen of what was overexposed."""
_SLACK = 8
"""Grey levels by which noise may go below the bound."""


class Overexposure:
    """Places that were as bright as a camera can tell, and the light since then.

    In less light they are darker by nobody knows how much: the background in that light is but a
    bound, and what is brighter is no foreground.
    """

    def __init__(self, learnt: Picture) -> None:
        """`learnt`: (height, width, 3) the background, in the light it was learnt in."""
        self._where: Mask = (learnt.max(axis=2) >= _OVEREXPOSED).view(np.uint8)
        self._any = bool(cv2.hasNonZero(self._where))
        self._light = np.ones(3, np.float32)

    def follow(self, ratio: NDArray[np.float32]) -> None:
        """Take a change of light (3,) of the channels."""
        self._light = self._light * ratio

    @property
    def is_uncovered(self) -> bool:
        """Whether there is so much less light that the background there is but a bound."""
        return self._any and bool(self._light.min() < _DIMMED)

    def seen_through(self, picture: Picture, background: Picture) -> Picture:
        """(height, width, 3) the background, with the picture where that keeps to the bound.

        Args:
            picture: (height, width, 3). background: the same, in the light of the picture.
        """
        bound = np.asarray(cv2.subtract(background, np.full(4, _SLACK, np.float64)), np.uint8)
        keeps = (picture >= bound).all(axis=2).view(np.uint8) & self._where
        return np.asarray(cv2.copyTo(picture, keeps, background.copy()), np.uint8)
