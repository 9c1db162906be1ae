"""Shadows: foreground that darkens the background but keeps its texture and hue."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Picture
from tracking.foreground.background import Subtraction
from tracking.foreground.light_and_chroma import (
    BackgroundChroma,
    LightAndChroma,
    chroma_distance,
    even_box,
    half_box,
    halve,
    in_size,
    is_grey,
    log_ratio,
    texture_change,
)
from tracking.foreground.settings import ForegroundSettings

Scores = NDArray[np.float32]

PERHAPS = 1
"""What `ShadowRemover.shadows` says of foreground that is shadow if it lies on the floor."""
_PERHAPS, _CERTAIN = np.uint8(PERHAPS), np.uint8(255)


class ShadowRemover:
    """Scores foreground by how little it looks like the background with less light.

    [Kawashita2014] eq. 1: theta = alpha Psi + beta Lambda + (1 - alpha - beta) eta where the
    picture is darker than the background, infinite elsewhere; below a threshold it is shadow.

    Psi: how much the ratio of light to the background changes from pixel to pixel nearby; in a
    shadow it is the same all over. Lambda: distance in the plane of hue and saturation. A bare
    difference of hue, as in the source, is noise where colours are pale, as floors are; weighed by
    saturation it fades out by itself. Both are bounded by 1. In grey footage Lambda carries
    nothing and its weight goes to Psi. What is darker than a shadow can be scores infinite, too
    (`shadow_min_brightness`). Scores are taken at half resolution, for speed.
    """

    def __init__(self, settings: ForegroundSettings | None = None) -> None:
        self._settings = settings or ForegroundSettings()
        self._usual = BackgroundChroma()

    def score(self, picture: Picture, background: Picture) -> Scores:
        """(height, width) theta, infinite where no shadow is possible.

        Args:
            picture, background: (height, width, 3) at half resolution.
        """
        theta, possible = self._scored(
            LightAndChroma.of(picture), LightAndChroma.of(background), is_grey(picture)
        )
        theta[~possible] = np.inf
        return theta

    def shadows(self, seen: Subtraction) -> NDArray[np.uint8]:
        """(height, width) uint8, 255 where the foreground is shadow, `PERHAPS` where it may be.

        What may be shadow is to be taken for it where range says that it lies on the floor.
        """
        size = (seen.mask.shape[1], seen.mask.shape[0])
        return in_size(self.dark(seen), size) & seen.mask

    def dark(self, seen: Subtraction) -> NDArray[np.uint8]:
        """What `shadows` would say of every second pixel, [::2, ::2], if all were foreground.

        Nothing is said far from the foreground.
        """
        height, width = seen.mask.shape
        found = np.zeros((-(-height // 2), -(-width // 2)), np.uint8)
        box = even_box(seen.mask)
        if box is None:
            return found
        settings, picture = self._settings, halve(seen.picture[box])
        usual = self._usual.within(seen.background, box)
        theta, possible = self._scored(LightAndChroma.of(picture), usual, is_grey(picture))
        certain = possible & (theta < settings.shadow_threshold)
        dark = (possible & (theta < settings.floor_shadow_threshold)).view(np.uint8) * _PERHAPS
        dark |= certain.view(np.uint8) * _CERTAIN
        found[half_box(box)] = dark
        return found

    def _scored(
        self, now: LightAndChroma, usual: LightAndChroma, grey: bool
    ) -> tuple[Scores, NDArray[np.bool_]]:
        """Theta, and where a shadow is possible at all; (height, width) both."""
        settings = self._settings
        alpha, beta = settings.shadow_texture, settings.shadow_hue
        constant = (1 - alpha - beta) * settings.shadow_constant
        ratio = log_ratio(now, usual)
        psi = texture_change(ratio)
        hue = psi if grey else chroma_distance(now, usual)
        theta = np.asarray(cv2.addWeighted(psi, alpha, hue, beta, constant), np.float32)
        darkest = np.float32(np.log(settings.shadow_min_brightness))
        return theta, (now.light < usual.light) & (ratio >= darkest)
