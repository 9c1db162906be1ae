"""A detector that looks at pictures, as plug-ins offer them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

from tracking.arrays import Picture
from tracking.people.detection_source import FrameDetections


class Detector(Protocol):
    """Finds people in pictures."""

    def find(self, picture: Picture) -> FrameDetections:
        """The people in a picture, whole bodies, a box each.

        Args:
            picture: (height, width, 3) uint8 BGR as recorded, or (height, width) grey.
        """

    def close(self) -> None:
        """Let go of what it holds."""


@dataclass(frozen=True, slots=True)
class DetectorSpec:
    """A detector as the catalogue lists it.

    Attributes:
        name: as `--model` and the setting `detections.model` take it. title: for people.
        open: makes it; what takes long or much memory is done here and not on import.
        min_score: boxes from it on are used, unless `detections.min_score` says otherwise.
        licence: of its weights, as runs keep it; "": none is stated.
    """

    name: str
    title: str
    open: Callable[[], Detector]
    min_score: float = 0.3
    licence: str = ""
