"""Light that changes on a part of the scene only, told from people by what it leaves as it was."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

Picture = NDArray[np.uint8]
Mask = NDArray[np.uint8]
Flags = NDArray[np.bool_]
Floats = NDArray[np.float32]
Box = tuple[slice, slice]

_BLOCK_PX = 16
"""Side of the squares compared: smaller than a person, with detail enough to be told again."""
_MOSTLY = 0.5
"""A block is looked at if this share of it differs from the background."""
_ALIKE = 0.6
"""Correlation of a block's detail with the background's from which on it is the same thing."""
_DETAIL = 1.5
"""Deviation of brightness, grey levels, below which a block has no detail to compare."""
_NOISE, _REST = 4.0, 0.5
"""What another light does not explain of a block: deviation in grey levels, or as a share of the
background's own; more is another thing with edges at the same places."""
_COLOURED = 1.3
"""The light that changes is at most so much stronger in one channel than in another."""
_SHARE = 0.3
"""Of the blocks that differ and have detail, so many must be the same thing in other light."""
_PATCH_SHARE, _PATCH_BLOCKS = 0.5, 4
"""The same of a patch, and how many these are at least: nobody's clothes look so like the floor."""
_NEAR = (7, 7)
"""Blocks that cannot be told have the light of those so near."""
_RATIOS = (0.2, 5.0)
"""Changes of light that are believed."""
_HOLES = np.ones((9, 9), np.uint8)
"""Holes so wide in what differs are as lit as what is round them: they only differ less."""
_EVEN_PX = (31, 31)
"""Light is even over so many pixels, and goes on as far into blocks that it fills by less."""
_BESIDE = np.ones((3, 3), np.uint8)


def change_of_light(picture: Picture, background: Picture, mask: Mask) -> Floats | None:
    """How much brighter each pixel's place became, 1 where nothing is known; None: no change.

    Where only the light changed, a block of the picture shows the same detail as the background,
    brighter or darker as a whole. People cover the detail with their own; behind them the light
    is that of the places near by.

    Args:
        picture, background: (height, width, 3). mask: (height, width), 255 where they differ.

    Returns:
        (height, width, 3) float32, channel by channel: lamps and the sun have colours.
    """
    blocks = _Blocks.of(picture, background, mask)
    told = blocks.differs & blocks.detail
    lit = told & blocks.alike
    if not lit.any() or lit.sum() < _SHARE * told.sum():
        return None
    hidden = blocks.differs & ~lit & _mostly_lit(lit, blocks.differs)
    return _ratio(picture, background, mask, lit, hidden)


def patches_of_light(
    picture: Picture, background: Picture, steady: Mask
) -> tuple[Box, Floats] | None:
    """The change of light on patches that keep still, however small; None: there are none.

    A patch is what hangs together, with people who stand in it; the larger part of it must show
    the background's own detail. Nothing is said of blocks that show another.

    Args:
        picture, background: (height, width, 3).
        steady: (height, width), 255 where the picture differs from the background and kept still.

    Returns:
        box: rows and columns round the patches.
        ratio: (rows, columns, 3) float32, 1 where the light is as it was.
    """
    box = _box_of_patches(_filled(steady), steady.shape)
    if box is None:
        return None
    inside = picture[box], background[box], steady[box]
    blocks = _Blocks.of(*inside)
    lit = _of_patches(blocks)
    if not lit.any():
        return None
    flat = blocks.differs & ~blocks.detail & ~blocks.busy
    return box, _ratio(*inside, lit, flat & _mostly_lit(lit, blocks.differs))


@dataclass(frozen=True, slots=True, eq=False)
class _Blocks:
    """What is known of each block; all (rows, columns).

    Attributes:
        differs: most of it does. detail: picture and background both have some to compare.
        busy: one of them has. alike: both show the same.
    """

    differs: Flags
    detail: Flags
    busy: Flags
    alike: Flags

    @classmethod
    def of(cls, picture: Picture, background: Picture, mask: Mask) -> _Blocks:
        size = _grid(mask.shape)
        now, usual = (np.asarray(eye[..., 1], np.float32) for eye in (picture, background))
        light, before = _means(now, size), _means(usual, size)
        variance, variance_before = (
            np.maximum(_means(eye * eye, size) - mean * mean, 0)
            for eye, mean in ((now, light), (usual, before))
        )
        common = _means(now * usual, size) - light * before
        here, there = variance > _DETAIL**2, variance_before > _DETAIL**2
        brighter = np.clip((light + 1) / (before + 1), *_RATIOS)
        expected = brighter * brighter * variance_before
        rest = variance - 2 * brighter * common + expected
        alike = (common > _ALIKE * np.sqrt(variance * variance_before)) & (
            rest < np.maximum(_NOISE**2, _REST**2 * expected)
        )
        alike &= _of_one_colour(_means(picture, size) + 1, _means(background, size) + 1)
        return cls(_filled(mask), here & there, here | there, np.asarray(alike, np.bool_))


def _of_one_colour(now: Floats, usual: Floats) -> Flags:
    """(rows, columns) whether light alone makes the difference between two colours."""
    ratio = now / usual
    return np.asarray(ratio.max(axis=2) < _COLOURED * ratio.min(axis=2), np.bool_)


def _box_of_patches(solid: Flags, shape: tuple[int, ...]) -> Box | None:
    """The pixels of the patches that are large enough, with a block more on each side."""
    _, _, stats, _ = cv2.connectedComponentsWithStats(solid.view(np.uint8), connectivity=4)
    large = stats[1:][stats[1:, cv2.CC_STAT_AREA] >= _PATCH_BLOCKS]
    if not len(large):
        return None
    left, top = large[:, :2].min(axis=0) - 1
    right, bottom = (large[:, :2] + large[:, 2:4]).max(axis=0) + 1
    rows = _pixels_of(int(top), int(bottom), shape[0], solid.shape[0])
    return rows, _pixels_of(int(left), int(right), shape[1], solid.shape[1])


def _pixels_of(first: int, end: int, pixels: int, blocks: int) -> slice:
    """The pixels of blocks along one side of the picture."""
    return slice(max(first, 0) * pixels // blocks, min(end, blocks) * pixels // blocks)


def _of_patches(blocks: _Blocks) -> Flags:
    """The lit blocks of patches of which most are lit."""
    count, patch = cv2.connectedComponents(blocks.differs.view(np.uint8), connectivity=4)
    told = blocks.differs & blocks.detail
    lit = told & blocks.alike
    of_told, of_lit = (np.bincount(patch[which], minlength=count) for which in (told, lit))
    real = (of_lit >= _PATCH_BLOCKS) & (of_lit >= _PATCH_SHARE * of_told)
    return np.asarray(lit & real[patch], np.bool_)


def _mostly_lit(lit: Flags, differs: Flags) -> Flags:
    """The blocks near which more are lit than are as they were."""
    more = lit.astype(np.float32) - ~differs
    return np.asarray(cv2.boxFilter(more, -1, _NEAR, normalize=False) > 0.5, np.bool_)


def _ratio(picture: Picture, background: Picture, mask: Mask, lit: Flags, guessed: Flags) -> Floats:
    """(height, width, 3) the change of light: measured on lit blocks, taken over on guessed ones.

    What differs beside a lit block, too little to fill its own, has the lit block's light.
    """
    size = mask.shape[1], mask.shape[0]
    changed = np.asarray(cv2.morphologyEx(mask, cv2.MORPH_CLOSE, _HOLES), np.uint8)
    measured = changed & _enlarged(lit.view(np.uint8) * np.uint8(255), size)
    guess = _enlarged((guessed & ~lit).view(np.uint8) * np.uint8(255), size)
    taken = (changed & _enlarged(_around(lit, _BESIDE), size)) | guess
    lights = [cv2.copyTo(eye, measured).astype(np.float32) for eye in (picture, background)]
    now, usual = (cv2.boxFilter(light, -1, _EVEN_PX, normalize=False) for light in lights)
    far_now, far_usual = (
        cv2.boxFilter(_means(light, lit.shape[::-1]), -1, _NEAR, normalize=False)
        for light in lights
    )
    far = np.asarray(
        cv2.resize(_quotient(far_now, far_usual), size, interpolation=cv2.INTER_LINEAR)
    )
    ratio = np.where(usual > _EVEN_PX[0], _quotient(now, usual), far)
    ratio[taken == 0] = 1.0
    return np.asarray(ratio, np.float32)


def _quotient(now: cv2.typing.MatLike, usual: cv2.typing.MatLike) -> Floats:
    """How much brighter, 1 where there is nothing to compare."""
    share = np.clip(now / np.maximum(usual, 1e-3), *_RATIOS)
    return np.where(usual > 0.5, share, np.float32(1)).astype(np.float32)


def _around(blocks: Flags, shape: Mask) -> Mask:
    """255 in blocks and round them."""
    return np.asarray(cv2.dilate(blocks.view(np.uint8) * np.uint8(255), shape), np.uint8)


def _enlarged(blocks: Mask, size: tuple[int, int]) -> Mask:
    """Blocks in pixels."""
    return np.asarray(cv2.resize(blocks, size, interpolation=cv2.INTER_NEAREST), np.uint8)


def _grid(shape: tuple[int, ...]) -> tuple[int, int]:
    """How many blocks lie across and down a picture."""
    return -(-shape[1] // _BLOCK_PX), -(-shape[0] // _BLOCK_PX)


def _filled(mask: Mask) -> Flags:
    """(rows, columns) the blocks of which most is in the mask."""
    share = cv2.resize(mask, _grid(mask.shape), interpolation=cv2.INTER_AREA)
    return np.asarray(share > _MOSTLY * 255, np.bool_)


def _means(values: Floats | Picture, size: tuple[int, int]) -> Floats:
    """The mean of each block, channel by channel."""
    return np.asarray(cv2.resize(values, size, interpolation=cv2.INTER_AREA), np.float32)
