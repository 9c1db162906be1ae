"""Pictures as a network wants them: scaled to the size of its input, beside grey, normalised.

Scaling is bilinear between pixel centres, without smoothing, in floating point: as the programs
that trained these networks do, but without their rounding to whole grey values.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.networks.network_spec import CENTRE, LETTERBOX, NetworkSpec

Picture = NDArray[np.uint8]


@dataclass(frozen=True, slots=True)
class Placement:
    """Where a picture lies in the input of a network.

    Attributes:
        size_px: (width, height) of the picture as recorded.
        scaled_px: the same in the input. left, top: its corner there, px.
    """

    size_px: tuple[int, int]
    scaled_px: tuple[int, int]
    left: int
    top: int

    @classmethod
    def of(cls, size_px: tuple[int, int], spec: NetworkSpec) -> Placement:
        """That of a picture of this size.

        Around the middle, sizes are rounded and the odd row of grey is below, as YOLOv5 has it; in
        the corner sizes are cut, as YOLOX has it.
        """
        (width, height), (wide, high) = size_px, spec.size_px
        if spec.fit != LETTERBOX:
            return cls(size_px, spec.size_px, 0, 0)
        scale = min(wide / width, high / height)
        whole = round if spec.align == CENTRE else int
        scaled = max(whole(width * scale), 1), max(whole(height * scale), 1)
        if spec.align != CENTRE:
            return cls(size_px, scaled, 0, 0)
        return cls(size_px, scaled, (wide - scaled[0]) // 2, (high - scaled[1]) // 2)

    def to_picture(self, corners: NDArray[np.float64]) -> NDArray[np.float64]:
        """(n, 4) left, top, right, bottom px of the picture of corners (n, 4) px of the input."""
        scale = np.divide(self.size_px, self.scaled_px)
        moved: NDArray[np.float64] = (corners - np.tile((self.left, self.top), 2)) * np.tile(
            scale, 2
        )
        return moved


def network_input(
    pictures: Sequence[Picture], spec: NetworkSpec
) -> tuple[NDArray[np.float32], tuple[Placement, ...]]:
    """Pictures as one batch, and where each of them lies in its part of it.

    Args:
        pictures: (height, width, 3) each, in BGR order.

    Returns (n, 3, height, width) with the size of the input.
    """
    width, height = spec.size_px
    batch = np.empty((len(pictures), 3, height, width), np.float32)
    placed = []
    mean, std = (np.array(values, np.float32) for values in (spec.mean, spec.std))
    for at, picture in enumerate(pictures):
        placement = Placement.of((picture.shape[1], picture.shape[0]), spec)
        canvas = np.full((height, width, 3), spec.pad, np.float32)
        wide, high = placement.scaled_px
        rows = slice(placement.top, placement.top + high)
        columns = slice(placement.left, placement.left + wide)
        canvas[rows, columns] = cv2.resize(
            picture.astype(np.float32), (wide, high), interpolation=cv2.INTER_LINEAR
        )
        if spec.channels == "rgb":
            canvas = canvas[:, :, ::-1]
        batch[at] = ((canvas / np.float32(spec.divide_by) - mean) / std).transpose(2, 0, 1)
        placed.append(placement)
    return batch, tuple(placed)
