"""Light and chroma of pictures at half resolution, which tell shadows from bodies."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Picture

Scores = NDArray[np.float32]
Box = tuple[slice, slice]

_NEAR = (3, 3)
"""Pixels over which noise is averaged."""
_WIDE = np.ones((5, 5), np.uint8)
"""Pixels across which a shadow's own edge changes, once averaged."""
_TEXTURE_FULL = 0.12
"""Change of the logarithm of the ratio of light, per pixel, that no shadow shows."""
_HUE_FULL = 0.06
"""Distance in the plane of hue and saturation, as shares of light, that no shadow shows."""
DARK_OFFSET = 6
"""Grey levels added before a ratio is taken, so that noise in the dark does not count."""
_LOGARITHM = np.log(np.arange(256, dtype=np.float32) + DARK_OFFSET)


@dataclass(frozen=True, slots=True)
class LightAndChroma:
    """Light and colour of a picture; all (height, width).

    Attributes:
        light: uint8 brightness. logarithm: of it, the darkest levels lifted.
        blue, red: their shares of the light.
    """

    light: Picture
    logarithm: Scores
    blue: Scores
    red: Scores

    @classmethod
    def of(cls, picture: Picture) -> LightAndChroma:
        """Those of a picture (height, width, 3)."""
        light = np.asarray(cv2.cvtColor(picture, cv2.COLOR_BGR2GRAY), np.uint8)
        logarithm = np.asarray(cv2.LUT(light, _LOGARITHM), np.float32)
        return cls(light, logarithm, *_shares_of_light(picture))

    def within(self, box: Box) -> LightAndChroma:
        """That of a part of the picture."""
        return LightAndChroma(self.light[box], self.logarithm[box], self.blue[box], self.red[box])


class BackgroundChroma:
    """Light and chroma of a background at half resolution, computed once a background."""

    def __init__(self) -> None:
        self._background: Picture | None = None
        self._look: LightAndChroma | None = None

    def within(self, background: Picture, box: Box) -> LightAndChroma:
        """Those of a box of even corners; `background` is not changed in place."""
        if self._look is None or self._background is not background:
            self._background = background
            rows, columns = (side // 2 * 2 for side in background.shape[:2])
            self._look = LightAndChroma.of(halve(background[:rows, :columns]))
        return self._look.within(half_box(box))


def even_box(mask: Picture, least_px: int = 2) -> Box | None:
    """Round the foreground, between even corners, where halving is exact and much faster.

    Args:
        mask: (height, width) uint8. least_px: no box is narrower or lower; None then.
    """
    x, y, width, height = cv2.boundingRect(mask)
    low = x // 2 * 2, y // 2 * 2
    high = min(x + width + 1, mask.shape[1]) // 2 * 2, min(y + height + 1, mask.shape[0]) // 2 * 2
    if high[0] - low[0] < least_px or high[1] - low[1] < least_px:
        return None
    return slice(low[1], high[1]), slice(low[0], high[0])


def half_box(box: Box) -> Box:
    """A box of even corners, at half resolution."""
    rows, columns = (slice(side.start // 2, side.stop // 2) for side in box)
    return rows, columns


def halve(picture: Picture) -> Picture:
    """At half the size, each pixel the mean of four."""
    size = (picture.shape[1] // 2, picture.shape[0] // 2)
    return np.asarray(cv2.resize(picture, size, interpolation=cv2.INTER_AREA), np.uint8)


def in_size(picture: Picture, size: tuple[int, int]) -> Picture:
    """The picture at another size, each pixel that of the nearest place.

    Twice the size is what is asked for most, and several times as fast by copying.
    """
    rows, columns = picture.shape
    if size != (2 * columns, 2 * rows):
        return np.asarray(cv2.resize(picture, size, interpolation=cv2.INTER_NEAREST), np.uint8)
    wide = np.asarray(cv2.merge((picture, picture)), np.uint8).reshape(rows, 2 * columns)
    return np.repeat(wide, 2, axis=0)


def is_grey(picture: Picture) -> bool:
    """Whether the footage has no colours, by a sample."""
    return bool(np.array_equal(picture[::4, ::4, 0], picture[::4, ::4, 2]))


def log_ratio(now: LightAndChroma, usual: LightAndChroma) -> Scores:
    """(height, width) logarithm of the ratio of light."""
    return np.asarray(cv2.subtract(now.logarithm, usual.logarithm), np.float32)


def texture_change(ratio: Scores) -> Scores:
    """Psi of [Kawashita2014] eq. 1, 0 to 1: how much the log ratio changes from pixel to pixel.

    The least of the neighbourhood, so that a shadow's own edge does not count.
    """
    change = np.empty_like(ratio)
    change[:, 0] = 0
    # OpenCV gives nothing where a single row or column is looked at.
    if ratio.shape[1] > 1:
        cv2.absdiff(ratio[:, 1:], ratio[:, :-1], change[:, 1:])
    if ratio.shape[0] > 1:
        change[1:] += cv2.absdiff(ratio[1:], ratio[:-1])
    return _share_of(cv2.erode(cv2.blur(change, _NEAR), _WIDE), _TEXTURE_FULL)


def chroma_distance(now: LightAndChroma, usual: LightAndChroma) -> Scores:
    """Lambda of [Kawashita2014] eq. 1, 0 to 1: distance in the plane of hue and saturation."""
    apart = cv2.magnitude(cv2.subtract(now.blue, usual.blue), cv2.subtract(now.red, usual.red))
    return _share_of(cv2.blur(apart, _NEAR), _HUE_FULL)


def _share_of(values: cv2.typing.MatLike, full: float) -> Scores:
    """Values, which are written over, as shares of a full one, at most 1."""
    shares = np.asarray(values, np.float32)
    np.minimum(shares, np.float32(full), out=shares)
    shares *= np.float32(1.0 / full)
    return shares


def _shares_of_light(picture: Picture) -> tuple[Scores, Scores]:
    """Blue's and red's."""
    blue, green, red = (
        np.asarray(channel, np.float32) + np.float32(DARK_OFFSET) for channel in cv2.split(picture)
    )
    light = cv2.add(cv2.add(blue, green), red)
    return (
        np.asarray(cv2.divide(blue, light), np.float32),
        np.asarray(cv2.divide(red, light), np.float32),
    )
