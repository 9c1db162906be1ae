"""The colour of a scene's shadows, learnt from those that are certain."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.foreground.background import Subtraction
from tracking.foreground.light_and_chroma import DARK_OFFSET

Floats = NDArray[np.float32]

_FEWEST_PIXELS = 150
_MEMORY = 0.9
_APART = 0.06
"""Share of the light by which a colour may miss those between full light and full shade."""
_DEPTHS = (0.12, 1.2)
"""How much of the shade may lie on a pixel: less is noise, more no shadow."""
_SEVERAL = 4


class ShadeColour:
    """What a scene's shade leaves of each channel's light.

    Texture and hue tell a shadow by its inside; at its edges and where it is narrow, as beside
    feet, both fail. But light is one for the whole scene: shade takes the same share of each
    channel everywhere, and half-shade some of it.
    """

    def __init__(self) -> None:
        self._left: Floats | None = None

    def follow(self, seen: Subtraction, certain: NDArray[np.uint8]) -> None:
        """Learn from a frame.

        Args:
            seen: the frame.
            certain: (height, width) 255 where there is shadow without doubt.
        """
        v, u = np.nonzero(certain[::_SEVERAL, ::_SEVERAL] == 255)
        if len(v) * _SEVERAL**2 < _FEWEST_PIXELS:
            return
        now = np.median(_ratio(seen, v * _SEVERAL, u * _SEVERAL), axis=0).astype(np.float32)
        self._left = now if self._left is None else _MEMORY * self._left + (1 - _MEMORY) * now

    def alike(
        self, seen: Subtraction, v: NDArray[np.intp], u: NDArray[np.intp]
    ) -> NDArray[np.bool_]:
        """(n,) which pixels have the colour of their background in shade or half-shade."""
        if self._left is None:
            return np.zeros(len(v), np.bool_)
        taken = 1 - self._left
        lost = 1 - _ratio(seen, v, u)
        depth = lost @ taken / float(taken @ taken)
        apart = np.abs(lost - depth[:, None] * taken).max(axis=1)
        return np.asarray((apart < _APART) & (depth > _DEPTHS[0]) & (depth < _DEPTHS[1]), np.bool_)


def _ratio(seen: Subtraction, v: NDArray[np.intp], u: NDArray[np.intp]) -> Floats:
    """(n, 3) light of the picture over that of the background."""
    now, usual = (image[v, u].astype(np.float32) for image in (seen.picture, seen.background))
    return (now + DARK_OFFSET) / (usual + DARK_OFFSET)
