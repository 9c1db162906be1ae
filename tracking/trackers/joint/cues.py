"""What tells people apart for the joint tracker: the cues of both papers."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.people import Detections
from tracking.trackers.joint.colours import colours_of
from tracking.trackers.stereo_direction import MiddleUpdated


@dataclass(frozen=True, slots=True)
class AllCues(MiddleUpdated):
    """The direction of [Kawashita2014] with the colours of both papers."""

    def seen(self, people: Detections) -> NDArray[np.float32]:
        """(detections, 3, bins) histograms."""
        return colours_of(people)
