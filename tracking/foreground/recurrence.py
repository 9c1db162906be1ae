"""What a place shows again and again over a recording, and so is no person who stands there."""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Flags, Picture
from tracking.foreground.background_modes import thinned
from tracking.foreground.difference import largest_difference
from tracking.foreground.gain import channel_ratios, scaled
from tracking.foreground.stillness import stillness

_SAME_WITHIN = 20
"""Grey levels by which a pixel is the same, as in the background's modes."""
_STILL = 0.7
"""Stillness from which on a look counts: who lingers is hardly ever so still."""
_FEWEST = 3
"""Pictures below which nothing is told of other times."""


class Recurrence:
    """Looks at a scene spread over a recording, to tell what stays there from who lingers.

    A chair that was moved stands there for most of the time that is left, and nothing moves beside
    it. Somebody who stands there does so for a while, and hardly ever as still.

    Args:
        pictures: at least one (height, width, 3), spread over the recording; at most 25 are used.
        later: of each the picture a moment later; empty: it is not known what moves.
        times_s: of each.
    """

    def __init__(
        self,
        pictures: Sequence[Picture],
        later: Sequence[Picture],
        times_s: Sequence[float],
    ) -> None:
        self._times_s = thinned(times_s)
        self._pictures, self._later = (
            [_smoothed(picture) for picture in thinned(some)] for some in (pictures, later)
        )
        still = [
            (stillness(picture, after) > _STILL).view(np.uint8)
            for picture, after in zip(self._pictures, self._later, strict=False)
        ]
        self._still = still or [np.ones(p.shape[:2], np.uint8) for p in self._pictures]

    def after(self, time_s: float) -> tuple[list[Picture], list[Picture]]:
        """The pictures from a time on and those a moment after each; too few to tell: none."""
        rows = [k for k, each_s in enumerate(self._times_s) if each_s >= time_s]
        if len(rows) < _FEWEST:
            return [], []
        return [self._pictures[k] for k in rows], [self._later[k] for k in rows if self._later]

    @property
    def tells(self) -> bool:
        """Whether there are enough looks to tell anything."""
        return len(self._pictures) >= _FEWEST

    def stays(
        self, picture: Picture, background: Picture, box: tuple[slice, slice], since_s: float
    ) -> Flags:
        """(rows, columns) of a box, where the time to come shows the picture, not the background.

        Args:
            picture: (height, width, 3). background: what it differs from, in its light.
            since_s: when the picture began to show what it does.
        """
        looks, others = self._looks(picture, background, box, since_s)
        return np.asarray(looks > others, np.bool_)

    def passes(
        self, picture: Picture, background: Picture, box: tuple[slice, slice], since_s: float
    ) -> Flags:
        """(rows, columns) of a box, where the time to come shows the background again.

        Args:
            picture, background, box, since_s: see `stays`.
        """
        looks, others = self._looks(picture, background, box, since_s)
        return np.asarray(others > looks, np.bool_)

    def _looks(
        self, picture: Picture, background: Picture, box: tuple[slice, slice], since_s: float
    ) -> tuple[Picture, Picture]:
        """(rows, columns) how often still looks to come show the picture, and the background."""
        looks, others = (np.zeros(picture[box].shape[:2], np.uint8) for _ in range(2))
        for other, still, time_s in zip(self._pictures, self._still, self._times_s, strict=True):
            if time_s < since_s:
                continue
            shown = scaled(other[box], channel_ratios(picture, other))
            alike = largest_difference(shown, picture[box]) < _SAME_WITHIN
            usual = (largest_difference(shown, background[box]) < _SAME_WITHIN) & ~alike
            looks += still[box] & alike
            others += still[box] & usual
        return looks, others


def _smoothed(picture: Picture) -> NDArray[np.uint8]:
    return np.asarray(cv2.blur(picture, (3, 3)), np.uint8)
