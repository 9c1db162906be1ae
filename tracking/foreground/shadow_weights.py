"""How surely foreground is a body and not a shadow: learnt from where people stand."""

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
    is_grey,
    log_ratio,
    texture_change,
)

_LEVELS = 8
_DARKEST, _BRIGHTEST = -1.4, 0.0
"""Logarithms of the light's ratio between which there may be a shadow."""
_BODY = _LEVELS**3
"""The kind of pixels that are brighter than any shadow, or darker."""
_LEAST_PX = 4
_PRIOR_PX = 300.0
"""How many pixels the first guess of a kind is worth."""
_SCORES = (0.15, 0.4)
"""Scores of likeness to a shadow between which the first guess rises from shadow to body."""
_RISE = (0.25, 0.65)
"""Shares of pixels on bodies between which a kind rises from shadow to body."""
_MEMORY_PX = 20_000.0
"""Of each kind so many pixels are remembered, those long ago less and less."""


class ShadowWeights:
    """Weighs foreground down that looks like the scene's shadows.

    The score of [Kawashita2014] eq. 1 with fixed weights and a fixed threshold takes grey clothes
    on a grey floor for shadows, and shadows on bricks for people. Here pixels are sorted into kinds
    by the same features (how much the ratio of light changes nearby, how far the hue is off, and
    the ratio itself), and how often each kind lies on the people followed, and how often beside
    them, is counted. Until enough was seen a first guess holds, that of the score.
    """

    def __init__(self) -> None:
        self._first = _first_guess()
        self._on = self._first * _PRIOR_PX
        self._off = (1.0 - self._first) * _PRIOR_PX
        self._kinds: NDArray[np.uint16] = np.zeros((0, 0), np.uint16)
        self._table = self._weights()
        self._usual = BackgroundChroma()

    def weigh(self, seen: Subtraction) -> Picture:
        """(height, width) uint8: 255 what is a body for sure, 0 what is a shadow for sure.

        What is no foreground has 255, too.
        """
        self._kinds = np.full((seen.mask.shape[0] // 2, seen.mask.shape[1] // 2), _BODY, np.uint16)
        weight = np.full(seen.mask.shape, 255, np.uint8)
        box = even_box(seen.mask, _LEAST_PX)
        if box is None:
            return weight
        kinds = _kinds(halve(seen.picture[box]), self._usual.within(seen.background, box))
        self._kinds[half_box(box)] = kinds
        size = (box[1].stop - box[1].start, box[0].stop - box[0].start)
        weight[box] = cv2.resize(self._table[kinds], size, interpolation=cv2.INTER_LINEAR)
        return weight

    def learn(self, mask: Picture, on: Picture, off: Picture) -> None:
        """Count what was seen in the frame weighed last.

        Args:
            mask: (height, width) its foreground, 255. on: where bodies are, non-zero. off: the same
                beside them, where their shadows fall.
        """
        height, width = self._kinds.shape
        half = np.s_[: 2 * height : 2, : 2 * width : 2]
        there = mask[half] > 0
        self._on += self._counted(there & (on[half] > 0))
        self._off += self._counted(there & (off[half] > 0))
        total = self._on + self._off
        fade = np.minimum(1.0, _MEMORY_PX / total)
        self._on *= fade
        self._off *= fade
        self._table = self._weights()

    def _counted(self, where: NDArray[np.bool_]) -> NDArray[np.float64]:
        return np.bincount(self._kinds[where], minlength=_BODY + 1)[:_BODY].astype(np.float64)

    def _weights(self) -> Picture:
        share = self._on / (self._on + self._off)
        level = np.clip((share - _RISE[0]) / (_RISE[1] - _RISE[0]), 0.0, 1.0)
        return np.append(np.rint(255 * level), 255).astype(np.uint8)


def _kinds(picture: Picture, usual: LightAndChroma) -> NDArray[np.uint16]:
    """(height, width) the kind of each pixel, by light and chroma beside its background."""
    now = LightAndChroma.of(picture)
    ratio = log_ratio(now, usual)
    change = texture_change(ratio)
    hue = change if is_grey(picture) else chroma_distance(now, usual)
    dark = (ratio - np.float32(_DARKEST)) * np.float32(1 / (_BRIGHTEST - _DARKEST))
    kind = _level(change)
    kind *= _LEVELS
    kind += _level(hue)
    kind *= _LEVELS
    kind += _level(dark)
    kind[(now.light >= usual.light) | (dark < 0)] = _BODY
    return kind


def _level(share: NDArray[np.float32]) -> NDArray[np.uint16]:
    """(height, width) finer where features are small: shadows are told there."""
    fine = np.sqrt(np.maximum(share, 0.0)) * np.float32(_LEVELS)
    return np.minimum(fine, np.float32(_LEVELS - 1)).astype(np.uint16)


def _first_guess() -> NDArray[np.float64]:
    """(kinds,) how likely each kind is a body, before anything was seen."""
    middle = ((np.arange(_LEVELS) + 0.5) / _LEVELS) ** 2
    score = 0.5 * middle[:, None, None] + 0.5 * middle[None, :, None]
    level = np.clip((score - _SCORES[0]) / (_SCORES[1] - _SCORES[0]), 0.02, 0.98)
    return np.asarray(np.broadcast_to(level, (_LEVELS,) * 3).ravel().copy())
