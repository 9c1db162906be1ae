"""Boxes of another program's detector, as the pictures draw them."""

from __future__ import annotations

from dataclasses import dataclass

from app.core.scenes import Colour, LegendEntry

DETECTION: Colour = (245, 245, 245)
"""No track has it: tracks have colours."""


@dataclass(frozen=True, slots=True)
class PicturedDetections:
    """The boxes of one camera in one frame that the tracker was given.

    Attributes:
        boxes: left, top, width, height of each in pixels of that camera as recorded.
        legend: what their colour means.
    """

    boxes: tuple[tuple[float, float, float, float], ...] = ()
    legend: tuple[LegendEntry, ...] = ()


NO_DETECTIONS = PicturedDetections()
