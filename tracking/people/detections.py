"""People seen in one frame, before anything is known of who they are."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats


@dataclass(frozen=True, slots=True)
class Detections:
    """The people of one frame, a row each. All arrays have n rows.

    Attributes:
        box: (n, 4) left, top, width, height in 0-based pixels of the left image as recorded.
        position: (n, 3) world metres; x, y where the person stands on the floor (the 3-D centre
            of the region carried down), z the height of that centre above the floor.
        size: (n, 2) real-world width and height of the region in metres.
        merged: (n,) bool; larger than one person can be ([Kawashita2014] section 3.4), so it is
            not to be used as an observation of one.
        truncated: (n,) bool; the region touches the image's edge.
        upper, lower: (n, h) hue histograms of the upper and the lower body, each summing to 1
            ([Kawashita2012]).
        middle: (n, hs) hue and saturation histogram of the region's middle, summing to 1
            ([Kawashita2014]).
        regions: (height, width) int32 or uint8 of the *rectified* left image: 0 background, k the
            pixels of row k - 1.
        clothes: (n, 2, 3) CIELAB of the upper and the lower body, mean lightness (0 to 100), a
            and b; NaN where it is not known.
        from_detector: (n,) bool; detected by another program, whose box is of one person and of
            the whole body, hidden or not.
    """

    box: Floats
    position: Floats
    size: Floats
    merged: NDArray[np.bool_]
    truncated: NDArray[np.bool_]
    upper: NDArray[np.float32]
    lower: NDArray[np.float32]
    middle: NDArray[np.float32]
    regions: NDArray[np.int32] | NDArray[np.uint8]
    clothes: NDArray[np.float32]
    from_detector: NDArray[np.bool_]

    def __len__(self) -> int:
        """The number of people seen."""
        return len(self.box)

    def chosen(self, kept: NDArray[np.bool_]) -> Detections:
        """Some of the people; the pixels of the others are nobody's."""
        number = np.concatenate(([0], np.where(kept, np.cumsum(kept), 0))).astype(np.int32)
        rows = {name: getattr(self, name)[kept] for name in self.__slots__ if name != "regions"}
        return Detections(**rows, regions=number[self.regions])

    @classmethod
    def none(cls, shape: tuple[int, ...]) -> Detections:
        """Nobody, in a picture of this height and width."""
        flags, histograms = np.zeros(0, bool), np.zeros((0, 1), np.float32)
        return cls(
            box=np.zeros((0, 4)),
            position=np.zeros((0, 3)),
            size=np.zeros((0, 2)),
            merged=flags,
            truncated=flags,
            upper=histograms,
            lower=histograms,
            middle=histograms,
            regions=np.broadcast_to(np.int32(0), shape),
            clothes=np.zeros((0, 2, 3), np.float32),
            from_detector=flags,
        )
