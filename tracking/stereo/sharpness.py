"""Which camera sees more sharply, and how much it must be smoothed to see as the other one does."""

from __future__ import annotations

import math

import cv2
import numpy as np
from numpy.typing import NDArray

Grey = NDArray[np.uint8]

_FINE, _COARSE = (3, 5), (7, 15)
"""Squares between which what is averaged away is fine detail, and coarser detail that every lens
shows. Noise is finer than either."""
_SAME, _SAME_AGAIN = 1.1, 1.05
"""Ratios of fine detail up to which two cameras are equally sharp, as they never see quite the
same: before one was found out of focus, and afterwards."""
_FAINTEST = 1.5
"""Coarser detail, grey levels, of which something can be told: noise alone makes 1.3."""
_SPREADS_PX = (0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.15, 1.3, 1.5, 1.75, 2.0)
"""Standard deviations of the smoothing that may be needed; what is out of focus by more is lost."""


class EvenSharpness:
    """Smooths the sharper one of two cameras where the other is a little out of focus.

    Block matching compares how steep brightness is. In a camera that is out of focus edges are less
    steep, and what fits a steep edge best is something else. The measure and the remedy are ours.

    Attributes:
        spread_px: standard deviations of the smoothing of the left and of the right camera; 0:
            none.
    """

    def __init__(self) -> None:
        self.spread_px = (0.0, 0.0)

    def learn(self, left: Grey, right: Grey) -> None:
        """Compare how sharply both cameras see the empty scene: (height, width) each.

        What is known stays as it is where there is little to see.
        """
        if min(_detail(image, _COARSE) for image in (left, right)) < _FAINTEST:
            return
        left_detail, right_detail = _fine_detail(left), _fine_detail(right)
        same = _SAME_AGAIN if any(self.spread_px) else _SAME
        if max(left_detail, right_detail) <= same * min(left_detail, right_detail):
            self.spread_px = (0.0, 0.0)
        elif left_detail > right_detail:
            self.spread_px = (_spread_to(right_detail, left), 0.0)
        else:
            self.spread_px = (0.0, _spread_to(left_detail, right))

    def even(self, left: Grey, right: Grey) -> tuple[Grey, Grey]:
        """Both cameras as sharp as the less sharp one."""
        return _smoothed(left, self.spread_px[0]), _smoothed(right, self.spread_px[1])


def _fine_detail(image: Grey) -> float:
    """Fine detail over coarser one, whatever the contrast."""
    fine, coarse = (_detail(image, sides) for sides in (_FINE, _COARSE))
    return fine / max(coarse, 1e-6)


def _detail(image: Grey, sides: tuple[int, int]) -> float:
    """What averaging over the larger one of two squares takes away of what the smaller leaves.

    Grey levels, the root of the mean of squares, so that edges count, which matching goes by.
    """
    near = cv2.blur(image, (sides[0], sides[0]))
    away = cv2.norm(near, cv2.blur(near, (sides[1], sides[1])), cv2.NORM_L2)
    return away / math.sqrt(image.size)


def _spread_to(detail: float, image: Grey) -> float:
    """The smoothing that leaves a camera as much fine detail."""
    left = [abs(_fine_detail(_smoothed(image, spread)) - detail) for spread in _SPREADS_PX]
    return _SPREADS_PX[int(np.argmin(left))]


def _smoothed(image: Grey, spread_px: float) -> Grey:
    if not spread_px:
        return image
    return np.asarray(cv2.GaussianBlur(image, (0, 0), spread_px), np.uint8)
