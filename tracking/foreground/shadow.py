"""Shadows: foreground that darkens the background but keeps its texture and hue."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.foreground.background import Subtraction
from tracking.foreground.settings import ForegroundSettings

_WINDOW = (7, 7)
_TEXTURE_FULL = 0.12
_HUE_FULL_DEG = 40.0
_GREY_SATURATION = 25.0


class ShadowRemover:
    """Scores foreground by how little it looks like the background with less light.

    [Kawashita2014] eq. 1: theta = alpha Psi + beta Lambda + (1 - alpha - beta) eta where the
    picture is darker than the background, infinite elsewhere; below a threshold it is shadow.

    Psi is the mean difference, over a window, between the picture and the background dimmed by
    the window's own ratio of light, as a share of that light. Lambda is the difference of hue as
    a share of 40 degrees, faded out where either is grey; in grey footage it carries nothing.
    Differences from the source: both terms are bounded by 1 so that the weights compare, and
    what is darker than a shadow can be (`shadow_darkest`) scores infinite too. Scores are
    taken at half resolution, for speed.
    """

    def __init__(self, settings: ForegroundSettings | None = None) -> None:
        self._settings = settings or ForegroundSettings()

    def score(self, seen: Subtraction) -> NDArray[np.float32]:
        """(height // 2, width // 2) theta, infinite where no shadow is possible."""
        picture, background = _half(seen.picture), _half(seen.background)
        light = cv2.cvtColor(picture, cv2.COLOR_BGR2GRAY).astype(np.float32)
        usual = cv2.cvtColor(background, cv2.COLOR_BGR2GRAY).astype(np.float32) + 1
        ratio = cv2.blur(light, _WINDOW) / cv2.blur(usual, _WINDOW)
        settings = self._settings
        alpha, beta = settings.shadow_texture, settings.shadow_hue
        theta = alpha * _texture(light, usual, ratio) + beta * _hue(picture, background)
        theta += (1 - alpha - beta) * settings.shadow_constant
        theta[(light >= usual) | (ratio < settings.shadow_darkest)] = np.inf
        return np.asarray(theta, np.float32)

    def shadows(self, seen: Subtraction) -> NDArray[np.uint8]:
        """(height, width) uint8, 255 where the foreground is shadow."""
        height, width = seen.mask.shape
        dark = (self.score(seen) < self._settings.shadow_threshold).astype(np.uint8) * 255
        full = cv2.resize(dark, (width, height), interpolation=cv2.INTER_NEAREST)
        return np.asarray(cv2.bitwise_and(full, seen.mask), np.uint8)


def _half(picture: NDArray[np.uint8]) -> NDArray[np.uint8]:
    size = (picture.shape[1] // 2, picture.shape[0] // 2)
    return np.asarray(cv2.resize(picture, size, interpolation=cv2.INTER_AREA), np.uint8)


def _texture(
    light: NDArray[np.float32], usual: NDArray[np.float32], ratio: NDArray[np.float32]
) -> NDArray[np.float32]:
    """Psi, 0 to 1."""
    rest = cv2.blur(cv2.absdiff(light, ratio * usual), _WINDOW)
    return np.asarray(np.minimum(rest / (_TEXTURE_FULL * (light + 8)), 1), np.float32)


def _hue(picture: NDArray[np.uint8], background: NDArray[np.uint8]) -> NDArray[np.float32]:
    """Lambda, 0 to 1."""
    now = cv2.cvtColor(picture, cv2.COLOR_BGR2HSV)
    usual = cv2.cvtColor(background, cv2.COLOR_BGR2HSV)
    apart = cv2.absdiff(now[..., 0], usual[..., 0]).astype(np.float32) * 2
    apart = np.minimum(apart, 360 - apart)
    colourful = np.minimum(now[..., 1], usual[..., 1]).astype(np.float32) / _GREY_SATURATION
    return np.asarray(np.minimum(apart / _HUE_FULL_DEG, 1) * np.minimum(colourful, 1), np.float32)
