"""Scales of colours that the colour-blind read, from dark to bright."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from app.core.scenes import Colour


@dataclass(frozen=True, slots=True, eq=False)
class ColourScale:
    """Attributes: table: (256, 3) uint8 red, green, blue."""

    table: NDArray[np.uint8]

    def colour(self, share: float) -> Colour:
        """At a share of the scale, 0 to 1."""
        red, green, blue = self.table[round(255 * share)].tolist()
        return red, green, blue


def _scale(name: int) -> ColourScale:
    levels = np.arange(256, dtype=np.uint8)[:, None]
    return ColourScale(np.asarray(cv2.applyColorMap(levels, name), np.uint8)[:, 0, ::-1])


VIRIDIS = _scale(cv2.COLORMAP_VIRIDIS)
INFERNO = _scale(cv2.COLORMAP_INFERNO)
