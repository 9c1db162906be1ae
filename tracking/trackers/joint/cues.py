"""Measurement and update of each person's appearance and walking direction.

The appearance model is updated by an exponentially weighted mean.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.people import Detections
from tracking.trackers.joint.appearance import stack_colours
from tracking.trackers.joint.settings import JointSettings
from tracking.trackers.stereo.population import Population
from tracking.trackers.stereo.walking_direction import WalkingCues


@dataclass(frozen=True, slots=True)
class JointCues(WalkingCues):
    """The colours of both papers and the walking direction of [Kawashita2014], which is in nats."""

    settings: JointSettings

    def measure_colours(self, people: Detections) -> NDArray[np.float32]:
        """(detections, 3, bins) histograms."""
        return stack_colours(people)

    def update_appearance(self, mine: Population, seen: NDArray[np.float32]) -> NDArray[np.float32]:
        """`Population.appearance` after one more match, alike; what is not known now stays."""
        old = np.where(np.isfinite(mine.appearance), mine.appearance, seen)
        share = self.newest_share(mine.matches)[:, None]
        return np.where(np.isfinite(seen), old + share * (seen - old), old)
