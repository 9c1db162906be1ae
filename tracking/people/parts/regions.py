"""The parts of one person, cut out of the pixels that are theirs."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.people.parts.lines import decompose
from tracking.people.parts.rectangles import inner_rectangles


@dataclass(frozen=True, slots=True)
class PartRegions:
    """Where somebody's parts are, in pixels of the picture looked at.

    Attributes:
        lines: (2,) rows of the lines under the head and under the torso.
        rectangles: (3, 4) cx, cy, width, height of the inner rectangles of head, torso and
            hip-leg; NaN where nothing of the part is seen.
    """

    lines: Floats
    rectangles: Floats


def part_regions(
    regions: NDArray[np.integer] | NDArray[np.bool_],
    label: int,
    picture: NDArray[np.uint8],
    box: Floats,
) -> PartRegions:
    """The parts of the person whose pixels bear a label.

    Args:
        regions: (height, width); a mask has the label 1.
        picture: (height, width, 3) of `ycbcr`.
        box: (4,) left, top, width, height in px of the whole person; it may reach out of the
            picture or of what is seen.
    """
    inside = around(box, picture.shape)
    corner = np.array((inside[1].start, inside[0].start), np.float64)
    mask = regions[inside] == label
    own = np.concatenate((box[:2] - corner, box[2:]))
    lines = decompose(mask, picture[inside], own)
    rectangles = inner_rectangles(mask, own, lines)
    rectangles[:, :2] += corner
    return PartRegions(lines + corner[1], rectangles)


def around(box: Floats, shape: tuple[int, ...]) -> tuple[slice, slice]:
    """The rows and columns of a picture of this shape that hold a box (4,), edges included."""
    size = np.array(shape[1::-1])
    low = np.clip(np.floor(box[:2]).astype(int), 0, size)
    high = np.clip(np.ceil(box[:2] + box[2:]).astype(int) + 1, low, size)
    return slice(int(low[1]), int(high[1])), slice(int(low[0]), int(high[0]))
