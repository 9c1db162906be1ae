"""The frame products that trackers step on."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, TypeVar

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Mask
from tracking.foreground import in_size
from tracking.people.appearance_source import Embed
from tracking.people.detections import Detections

T = TypeVar("T", np.uint8, np.float32)

Disparity = NDArray[np.float32]

_SHADOW = 127


class Overlays:
    """Pictures a view may lay over the left camera, in pixels of the rectified left image.

    They are made when asked for: most frames are tracked and never shown.

    Args:
        foreground: (rows, columns) 255 in the foreground, 0 elsewhere; with what is shadow as 127,
            or with `shadow` beside it.
        disparity: (rows, columns) working px, of any grid; None without stereo.
        shadow: (rows, columns) of any grid, 255 where what is foreground is shadow.
        size: width and height of the pictures; None for those of `foreground`.
        shrink: pixels a working pixel is wide.
    """

    def __init__(
        self,
        foreground: Mask,
        disparity: Disparity | None,
        shadow: Mask | None = None,
        size: tuple[int, int] | None = None,
        shrink: int = 1,
    ) -> None:
        self._foreground = foreground
        self._disparity = disparity
        self._shadow = shadow
        self._size = size or (foreground.shape[1], foreground.shape[0])
        self._shrink = shrink

    @property
    def foreground(self) -> Mask:
        """(height, width) uint8: 0 background, 127 shadow, 255 foreground."""
        shown = self._foreground
        if self._shadow is not None:
            shadow = in_size(self._shadow, (shown.shape[1], shown.shape[0]))
            shown = np.where((shadow == 255) & (shown > 0), np.uint8(_SHADOW), shown)
        return _resized(shown, self._size)

    @property
    def disparity(self) -> Disparity | None:
        """(height, width) float32 px, NaN where unknown; None without stereo."""
        if self._disparity is None:
            return None
        return _resized(self._disparity, self._size) * np.float32(self._shrink)

    def ranged(self, every_px: int) -> tuple[int, int]:
        """Of every n-th pixel across and down, how many are foreground and no shadow.

        Returns the number of these, and of those among them that have a disparity.
        """
        if self._disparity is None:
            return 0, 0
        moving = self._every(self._foreground, every_px) == 255
        if self._shadow is not None:
            moving &= self._every(self._shadow, every_px) != 255
        known = np.isfinite(self._every(self._disparity, every_px)[moving])
        return int(np.count_nonzero(moving)), int(np.count_nonzero(known))

    def _every(self, picture: NDArray[Any], step: int) -> NDArray[Any]:
        """Every n-th pixel of the picture as shown."""
        columns, rows = (
            np.arange(0, shown, step) * stored // shown
            for shown, stored in zip(self._size, picture.shape[::-1], strict=True)
        )
        # One side after the other: several times as fast as both at once.
        return np.asarray(picture.take(rows, axis=0).take(columns, axis=1))


def _resized(picture: NDArray[T], size: tuple[int, int]) -> NDArray[T]:
    if picture.shape == size[::-1]:
        return picture
    return np.asarray(cv2.resize(picture, size, interpolation=cv2.INTER_NEAREST), picture.dtype)


@dataclass(frozen=True, slots=True)
class Observation:
    """The frame products a tracker steps on: everything seen, nothing remembered.

    Attributes:
        frame: frame number in the recording.
        time_s: seconds since the recording's first frame.
        people: who is seen.
        overlays: for the views.
        picture: (height, width, 3) BGR, what single-camera perception looked at: the left (or only)
            camera as recorded, in whose pixels everything else is; None where perception does not
            hand it on.
        embed: what describes people by an appearance network; None: there is none.
    """

    frame: int
    time_s: float
    people: Detections
    overlays: Overlays
    picture: NDArray[np.uint8] | None = None
    embed: Embed | None = None
