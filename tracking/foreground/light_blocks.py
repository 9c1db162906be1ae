"""A picture beside its background in blocks: where both show the same, in whatever light."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Flags, Mask, Picture

Floats = NDArray[np.float32]

_BLOCK_PX = 16
"""Side of the squares compared: smaller than a person, with detail enough to be told again."""
_STEP = 2
"""Every so-manieth pixel is compared: they are smoothed."""
_FINE = (9, 9)
"""Width of details, in pixels compared."""
_MOSTLY = 0.5
"""A block is looked at if this share of it differs from the background."""
_ALIKE = 0.6
"""Correlation of a block's detail with the background's from which on it is the same thing."""
_DETAIL = 1.5
"""Deviation of brightness, grey levels, below which a block has no detail to compare."""
_NOISE, _REST = 4.0, 0.5
"""What another light does not explain of a block: deviation in grey levels, or as a share of the
background's own; more is another thing with edges at the same places."""
_COLOURED = 1.5
"""The light that changes is at most so much stronger in one channel than in another."""
_RATIOS = (0.2, 5.0)
"""Changes of light that are believed."""


@dataclass(frozen=True, slots=True, eq=False)
class Blocks:
    """What is known of each block; all (rows, columns).

    Attributes:
        differs: most of it does. detail: picture and background both have some to compare.
        busy: one of them has. alike: both show the same. brighter: the picture is.
    """

    differs: Flags
    detail: Flags
    busy: Flags
    alike: Flags
    brighter: Flags

    @classmethod
    def of(cls, picture: Picture, background: Picture, mask: Mask) -> Blocks:
        """The blocks of a picture beside its background.

        The same thing in another light has the same detail, weaker or stronger as its brightness
        is, and nearly the same colour.

        Args:
            picture, background: (height, width, 3). mask: (height, width) 255 where they differ.
        """
        size = grid(mask.shape)
        images = [np.ascontiguousarray(image[::_STEP, ::_STEP]) for image in (picture, background)]
        now, usual = (np.asarray(cv2.extractChannel(image, 1), np.float32) for image in images)
        colours = [np.asarray(means(image, size), np.float32) for image in images]
        brighter = quotient(colours[0][..., 1], colours[1][..., 1])
        here, there, alike = _compared(now, usual, brighter)
        # Across the edge of a patch the light changes, but hardly within the width of a detail.
        fine = [np.asarray(image - cv2.blur(image, _FINE), np.float32) for image in (now, usual)]
        _, fine_there, fine_alike = _compared(fine[0], fine[1], brighter)
        alike |= fine_alike & fine_there
        alike &= _of_one_colour(*colours)
        return cls(filled(mask, size), here & there, here | there, alike, brighter > 1)


def _compared(now: Floats, usual: Floats, brighter: Floats) -> tuple[Flags, Flags, Flags]:
    """Where the picture and the background have detail, and where it is the same.

    Args:
        now, usual: of both. brighter: (rows, columns) how much the light of each block grew.
    """
    size = (brighter.shape[1], brighter.shape[0])
    light, before = means(now, size), means(usual, size)
    variance, variance_before = (
        np.maximum(means(image * image, size) - mean * mean, 0)
        for image, mean in ((now, light), (usual, before))
    )
    common = means(now * usual, size) - light * before
    expected = brighter * brighter * variance_before
    rest = variance - 2 * brighter * common + expected
    alike = common > _ALIKE * np.sqrt(variance * variance_before)
    alike &= rest < np.maximum(_NOISE**2, _REST**2 * expected)
    return variance > _DETAIL**2, variance_before > _DETAIL**2, np.asarray(alike, np.bool_)


def _of_one_colour(now: Floats, usual: Floats) -> Flags:
    """(rows, columns) whether light alone makes the difference between two colours."""
    ratio = (now + 1) / (usual + 1)
    return np.asarray(ratio.max(axis=2) < _COLOURED * ratio.min(axis=2), np.bool_)


def quotient(now: cv2.typing.MatLike, usual: cv2.typing.MatLike) -> Floats:
    """How much brighter, 1 where there is nothing to compare."""
    share = np.clip(now / np.maximum(usual, 1e-3), *_RATIOS)
    return np.where(usual > 0.5, share, np.float32(1)).astype(np.float32)


def grid(shape: tuple[int, ...]) -> tuple[int, int]:
    """How many blocks lie across and down a picture."""
    return -(-shape[1] // _BLOCK_PX), -(-shape[0] // _BLOCK_PX)


def filled(mask: Mask, size: tuple[int, int]) -> Flags:
    """(rows, columns) the blocks of which most is in the mask."""
    share = cv2.resize(mask, size, interpolation=cv2.INTER_AREA)
    return np.asarray(share > _MOSTLY * 255, np.bool_)


def means(values: Floats | Picture, size: tuple[int, int]) -> Floats:
    """The mean of each block, channel by channel."""
    return np.asarray(cv2.resize(values, size, interpolation=cv2.INTER_AREA), np.float32)


def white(where: NDArray[np.bool_]) -> Mask:
    """255 where it is true."""
    return where.view(np.uint8) * np.uint8(255)
