"""A first picture of another kind than those after it."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.recording.frame import Image

_DARK = 40
_FLAT = 6
_LEAST_BAR_SHARE = 0.03
_LEAST_LIKENESS = 0.5


def first_frame_note(name: str, first: Image, second: Image) -> str | None:
    """What is odd about a source's first picture, in words; None where it is like the next.

    Cameras often begin with a picture in another mode: letterboxed, black or grey.
    """
    bars, later = _bar_px(first), _bar_px(second)
    if bars - later > _LEAST_BAR_SHARE * min(first.shape[:2]):
        return f"{name}: frame 0 is letterboxed (bars of {bars} px), unlike those after it"
    if _likeness(first, second) < _LEAST_LIKENESS:
        return f"{name}: frame 0 shows something else than those after it"
    return None


def _likeness(first: Image, second: Image) -> float:
    """Correlation of the two pictures, made small; 1 where the second one has no contents."""
    one, two = (
        cv2.resize(image, (64, 48), interpolation=cv2.INTER_AREA).ravel()
        for image in (first, second)
    )
    if two.std() < _FLAT:
        return 1.0
    return float(np.corrcoef(one, two)[0, 1]) if one.std() > 0 else 0.0


def _bar_px(image: Image) -> int:
    """The width of the widest dark, flat bar along an edge of the picture."""
    green = image[..., 1]
    bars = []
    for axis in (0, 1):
        brightest = green.max(axis=axis)
        dark = (brightest < _DARK) & (brightest - green.min(axis=axis) < _FLAT)
        bars += [_leading(dark), _leading(dark[::-1])]
    return max(bars)


def _leading(flags: NDArray[np.bool_]) -> int:
    """How many are set before the first that is not."""
    return len(flags) if flags.all() else int(np.argmin(flags))
