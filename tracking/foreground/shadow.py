"""Shadows: foreground that darkens the background but keeps its texture and hue."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.foreground.background import Subtraction
from tracking.foreground.settings import ForegroundSettings

Picture = NDArray[np.uint8]
Scores = NDArray[np.float32]

PERHAPS = 1
"""What `ShadowRemover.shadows` says of foreground that is shadow if it lies on the floor."""
_SMALL = np.ones((3, 3), np.uint8)
_WIDE = np.ones((5, 5), np.uint8)
_TEXTURE_FULL = 0.12
"""Change of the logarithm of the ratio of light, per pixel, that no shadow shows."""
_HUE_FULL = 0.06
"""Distance in the plane of hue and saturation, as shares of light, that no shadow shows."""
_DARK_OFFSET = 6
"""Grey levels added before a ratio is taken, so that noise in the dark does not count."""
_LOGARITHM = np.log(np.arange(256, dtype=np.float32) + _DARK_OFFSET)


class ShadowRemover:
    """Scores foreground by how little it looks like the background with less light.

    [Kawashita2014] eq. 1: theta = alpha Psi + beta Lambda + (1 - alpha - beta) eta where the
    picture is darker than the background, infinite elsewhere; below a threshold it is shadow.

    Psi: how much the ratio of light to the background changes from pixel to pixel nearby; in a
    shadow it is the same all over. Lambda: distance in the plane of hue and saturation. A bare
    difference of hue, as in the source, is noise where colours are pale, as floors are; weighed by
    saturation it fades out by itself. Both are bounded by 1. In grey footage Lambda carries
    nothing and its weight goes to Psi. What is darker than a shadow can be (`shadow_darkest`)
    scores infinite too. Scores are taken at half resolution, for speed.
    """

    def __init__(self, settings: ForegroundSettings | None = None) -> None:
        self._settings = settings or ForegroundSettings()

    def score(self, picture: Picture, background: Picture) -> Scores:
        """(height, width) theta, infinite where no shadow is possible.

        Args:
            picture, background: (height, width, 3) at half resolution.
        """
        settings = self._settings
        alpha, beta = settings.shadow_texture, settings.shadow_hue
        light, usual, ratio = log_ratio(picture, background)
        theta = np.full(light.shape, (1 - alpha - beta) * settings.shadow_constant, np.float32)
        if is_grey(picture):
            theta += np.float32(alpha + beta) * texture_change(ratio)
        else:
            theta += np.float32(alpha) * texture_change(ratio)
            theta += np.float32(beta) * hue_distance(picture, background)
        theta[(light >= usual) | (ratio < np.log(settings.shadow_darkest))] = np.inf
        return theta

    def shadows(self, seen: Subtraction) -> NDArray[np.uint8]:
        """(height, width) uint8, 255 where the foreground is shadow, `PERHAPS` where it may be.

        What may be shadow is to be taken for it where range says that it lies on the floor.
        """
        shadow = np.zeros_like(seen.mask)
        x, y, width, height = cv2.boundingRect(seen.mask)
        if width < 2 or height < 2:
            return shadow
        # Between even corners halving is exact, and much faster.
        box = np.s_[
            y // 2 * 2 : y + height + (y + height) % 2, x // 2 * 2 : x + width + (x + width) % 2
        ]
        mask = seen.mask[box]
        theta = self.score(halved(seen.picture[box]), halved(seen.background[box]))
        certain = theta < self._settings.shadow_threshold
        dark = np.where(
            theta < self._settings.floor_shadow_threshold, np.uint8(PERHAPS), np.uint8(0)
        )
        dark[certain] = 255
        full = cv2.resize(dark, mask.shape[::-1], interpolation=cv2.INTER_NEAREST)
        shadow[box] = cv2.bitwise_and(full, mask)
        return shadow


def log_ratio(picture: Picture, background: Picture) -> tuple[Picture, Picture, Scores]:
    """Brightness of both and the logarithm of their ratio, (height, width) each.

    Args:
        picture, background: (height, width, 3).
    """
    light = np.asarray(cv2.cvtColor(picture, cv2.COLOR_BGR2GRAY), np.uint8)
    usual = np.asarray(cv2.cvtColor(background, cv2.COLOR_BGR2GRAY), np.uint8)
    return light, usual, _logarithm(light) - _logarithm(usual)


def halved(picture: Picture) -> Picture:
    """At half the size, each pixel the mean of four."""
    size = (picture.shape[1] // 2, picture.shape[0] // 2)
    return np.asarray(cv2.resize(picture, size, interpolation=cv2.INTER_AREA), np.uint8)


def _logarithm(light: cv2.typing.MatLike) -> Scores:
    return np.asarray(cv2.LUT(light, _LOGARITHM), np.float32)


def is_grey(picture: Picture) -> bool:
    """Whether the footage has no colours, by a sample."""
    return bool(np.array_equal(picture[::4, ::4, 0], picture[::4, ::4, 2]))


def texture_change(log_ratio: NDArray[np.float32]) -> Scores:
    """Psi, 0 to 1; the least of the neighbourhood, so that a shadow's own edge does not count."""
    change = np.zeros_like(log_ratio)
    change[:, 1:] = np.abs(np.diff(log_ratio, axis=1))
    change[1:] += np.abs(np.diff(log_ratio, axis=0))
    least = cv2.erode(cv2.blur(change, _SMALL.shape), _WIDE)
    return np.asarray(np.minimum(least / np.float32(_TEXTURE_FULL), 1), np.float32)


def hue_distance(picture: Picture, background: Picture) -> Scores:
    """Lambda, 0 to 1."""
    (blue, red), (usual_blue, usual_red) = _chroma(picture), _chroma(background)
    apart = cv2.magnitude(cv2.subtract(blue, usual_blue), cv2.subtract(red, usual_red))
    smooth = cv2.blur(apart, _SMALL.shape)
    return np.asarray(np.minimum(smooth / np.float32(_HUE_FULL), 1), np.float32)


def _chroma(picture: Picture) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Blue's and red's share of the light."""
    blue, green, red = cv2.split(picture.astype(np.float32) + np.float32(_DARK_OFFSET))
    light = cv2.add(cv2.add(blue, green), red)
    return (
        np.asarray(cv2.divide(blue, light), np.float32),
        np.asarray(cv2.divide(red, light), np.float32),
    )
