"""The parts of all people of a frame."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.people.detections import Detections
from tracking.people.parts.lines import decompose
from tracking.people.parts.rectangles import inner_rectangles

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class PartRegions:
    """Where the parts of people are, a row a person; pixels of the picture looked at.

    Attributes:
        lines: (n, 2) rows of the lines under the head and under the torso.
        rectangles: (n, 3, 4) cx, cy, width, height of the inner rectangles of head, torso and
            hip-leg; NaN where nothing of the part is seen.
    """

    lines: Floats
    rectangles: Floats

    def __len__(self) -> int:
        """The number of people."""
        return len(self.lines)


def part_regions(people: Detections, picture: NDArray[np.uint8]) -> PartRegions:
    """The parts of everybody seen in a frame.

    Args:
        people: of the frame; `regions` and `box` in pixels of `picture`.
        picture: (height, width, 3) of `ycbcr`.
    """
    lines = np.zeros((len(people), 2))
    rectangles = np.zeros((len(people), 3, 4))
    for k, box in enumerate(people.box):
        left, top = np.clip(np.floor(box[:2]).astype(int), 0, picture.shape[1::-1])
        right, bottom = np.maximum(np.ceil(box[:2] + box[2:]).astype(int) + 1, (left, top))
        inside = np.s_[top:bottom, left:right]
        mask = people.regions[inside] == k + 1
        own = box - (left, top, 0, 0)
        cut = decompose(mask, picture[inside], own)
        lines[k] = cut + top
        rectangles[k] = inner_rectangles(mask, own, cut)
        rectangles[k, :, :2] += (left, top)
    return PartRegions(lines, rectangles)
