"""Detections of another program, as perception asks for them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from tracking.arrays import Floats

MOST_BOXES = 200
"""In a frame: labels of 8 bits tell them apart."""


@dataclass(frozen=True, slots=True, eq=False)
class FrameDetections:
    """The detections of one camera in one frame.

    Attributes:
        box: (n, 4) left, top, width, height in 0-based px of the picture as recorded.
        score: (n,) how sure it is, in its own unit; larger is surer.
    """

    box: Floats
    score: Floats

    def __len__(self) -> int:
        """The number of boxes."""
        return len(self.box)


class DetectionSource(Protocol):
    """Detections of a recording, one for each person, with scores high enough to be used."""

    @property
    def detections_only(self) -> bool:
        """Whether no people are looked for in the foreground beside them."""

    def of(self, frame: int) -> FrameDetections:
        """The boxes of a frame, at most `MOST_BOXES`; none where the frame has none."""

    def of_right(self, frame: int) -> FrameDetections | None:
        """Those of the right camera's frame; None where nothing is known of that camera."""
