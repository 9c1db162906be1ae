"""Light that changes on a part of the scene only, told from people by what it leaves as it was."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Flags, Mask, Picture
from tracking.foreground.difference import largest_difference
from tracking.foreground.light_blocks import Blocks, filled, grid, means, quotient, white

Floats = NDArray[np.float32]
Box = tuple[slice, slice]

MUCH_CHANGED = 0.2
"""Where more of the picture differs than this, light is suspected before people are."""
_COARSE = 4
"""Patches are looked for in every so-manieth pixel."""
_SHARE = 0.3
"""Of the blocks that differ and have detail, so many must be the same thing in other light."""
_A_FEW, _MOST = 0.05, 0.5
"""Shares of what is near that must be brighter, or darker, to believe it of what people hide."""
_PATCH_BLOCKS = 4
"""Patches of fewer blocks are left alone."""
_NEARLY_ALL, _AT_ONCE = 0.6, 0.1
"""A change of light is believed at once if so much of what differs shows the same thing, or such a
share of the picture that hangs together: shadows of a crowd are as much in all, but each is small.
"""


_HOLES = np.ones((9, 9), np.uint8)
"""Holes so wide in what differs are as lit as what is round them: they only differ less."""
_EVEN_PX = (31, 9)
"""Light is even over so many pixels; the nearer it is measured the better, if it can be."""
_FEWEST_LIT = 4.0
"""Grey levels that the mean of so many pixels reaches where enough of them are measured."""
_EXPLAINED = 16
"""Grey levels that another light may leave unexplained of a pixel."""
NEAR = (7, 7)
"""Blocks that cannot be told have the light of those so near."""


def change_of_light(picture: Picture, background: Picture, mask: Mask) -> Floats | None:
    """How much brighter each pixel's place became, 1 where nothing is known; None: no change.

    Where only the light changed, a block of the picture shows the same detail as the background,
    brighter or darker as a whole. People cover the detail with their own; behind them the light
    is that of the places near by. Shadows of people show the background's detail, too, but light
    changes over a large part of the picture that hangs together.

    Args:
        picture, background: (height, width, 3). mask: (height, width), 255 where they differ.

    Returns:
        (height, width, 3) float32, channel by channel: lamps and the sun have colours.
    """
    blocks = Blocks.of(picture, background, mask)
    told = blocks.differs & blocks.detail
    lit = told & blocks.alike
    if not lit.any() or lit.sum() < _SHARE * told.sum() or not _large(lit, blocks.differs):
        return None
    hidden = blocks.differs & ~lit & _may_be_lit(lit, blocks)
    return ratio_of_light(picture, background, mask, lit, hidden)


def patches_of_light(
    picture: Picture, background: Picture, still_s: Floats, least_s: tuple[float, float]
) -> tuple[Box, Floats] | None:
    """The change of light on patches that keep still, however small; None: there are none.

    A patch shows the background's own detail all over; nothing is said of blocks that show another,
    as where people stand in it.

    Args:
        picture, background: (height, width, 3).
        still_s: (height, width) for how long the picture has differed from the background and
            kept still, seconds.
        least_s: shorter does not count where it became brighter, and where darker.

    Returns:
        box: rows and columns round the patches.
        ratio: (rows, columns, 3) float32, 1 where the light is as it was.
    """
    few = np.s_[::_COARSE, ::_COARSE]
    box = _box_of_patches(
        _steady(picture[few], background[few], still_s[few], least_s), still_s.shape
    )
    if box is None:
        return None
    inside = picture[box], background[box], still_s[box]
    steady = white(_steady(*inside, least_s))
    blocks = Blocks.of(picture[box], background[box], steady)
    lit = _together(blocks.differs & blocks.detail & blocks.alike, _PATCH_BLOCKS)
    if not lit.any():
        return None
    flat = blocks.differs & ~blocks.busy & _may_be_lit(lit, blocks)
    return box, ratio_of_light(picture[box], background[box], steady, lit, flat)


def _steady(
    picture: Picture, background: Picture, still_s: Floats, least_s: tuple[float, float]
) -> Flags:
    """(height, width) where the picture kept still long enough."""
    brighter, darker = (still_s > np.float32(least) for least in least_s)
    return np.asarray(darker | (brighter & (picture[..., 1] > background[..., 1])), np.bool_)


def _box_of_patches(steady: Flags, shape: tuple[int, ...]) -> Box | None:
    """The pixels of the patches that are large enough, with a block more on each side.

    Args:
        steady: (rows, columns) of every few pixels. shape: of the picture.
    """
    solid = filled(white(steady), grid(shape))
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


def _large(lit: Flags, differs: Flags) -> bool:
    """Whether nearly all that differs is lit, or much of the picture that hangs together."""
    nearly_all = lit.sum() >= _NEARLY_ALL * differs.sum()
    return bool(nearly_all or _together(lit, _AT_ONCE * lit.size).any())


def _together(lit: Flags, least: float) -> Flags:
    """The blocks of which so many hang together: clothes never look so like the floor."""
    _, patch, stats, _ = cv2.connectedComponentsWithStats(lit.view(np.uint8), connectivity=4)
    large = stats[:, cv2.CC_STAT_AREA] >= least
    return np.asarray(lit & large[patch], np.bool_)


def _may_be_lit(lit: Flags, blocks: Blocks) -> Flags:
    """The blocks that likely have the light of lit ones near by, and not that of the others.

    At the edge of a patch it is not known. A background that is too dark there makes people where
    nobody is, one that is too bright only shadows: more light is believed sooner, less light where
    most of what is near has it.
    """
    brighter, darker = (
        cv2.boxFilter(which.astype(np.float32), -1, NEAR)
        for which in (lit & blocks.brighter, lit & ~blocks.brighter)
    )
    more = (brighter > darker) & (brighter > _A_FEW)
    return np.asarray(more | (darker > _MOST), np.bool_)


def ratio_of_light(
    picture: Picture, background: Picture, mask: Mask, lit: Flags, guessed: Flags
) -> Floats:
    """(height, width, 3) the change of light: measured on lit blocks, taken over on guessed ones.

    What differs near lit blocks, too little to fill its own or beside people, has their light
    if that explains how it looks.
    """
    size = mask.shape[1], mask.shape[0]
    changed = np.asarray(cv2.morphologyEx(mask, cv2.MORPH_CLOSE, _HOLES), np.uint8)
    lit_px = changed & _enlarge(white(lit), size)
    ratio = _spread(picture, background, lit_px, (lit.shape[1], lit.shape[0]))
    there = np.asarray(cv2.multiply(background, ratio, dtype=cv2.CV_8U), np.uint8)
    explained = white(largest_difference(picture, there) < _EXPLAINED)
    near = cv2.dilate(white(lit), np.ones(NEAR, np.uint8))
    taken = changed & explained & _enlarge(np.asarray(near, np.uint8), size)
    taken |= lit_px | _enlarge(white(guessed), size)
    ratio[taken == 0] = 1.0
    return ratio


def _spread(picture: Picture, background: Picture, lit_px: Mask, size: tuple[int, int]) -> Floats:
    """(height, width, 3) the change of light everywhere, as it is on the lit pixels near by.

    Args:
        lit_px: (height, width) 255 there. size: blocks across and down.
    """
    lights = [cv2.copyTo(image, lit_px).astype(np.float32) for image in (picture, background)]
    now, usual = (cv2.boxFilter(means(image, size), -1, NEAR, normalize=False) for image in lights)
    ratio = np.asarray(cv2.resize(quotient(now, usual), lit_px.shape[::-1]), np.float32)
    for side in _EVEN_PX:
        now, usual = (cv2.boxFilter(image, -1, (side, side), normalize=False) for image in lights)
        ratio = np.where(usual > _FEWEST_LIT * side * side, quotient(now, usual), ratio)
    return ratio


def _enlarge(blocks: Mask, size: tuple[int, int]) -> Mask:
    """Blocks in pixels."""
    return np.asarray(cv2.resize(blocks, size, interpolation=cv2.INTER_NEAREST), np.uint8)
