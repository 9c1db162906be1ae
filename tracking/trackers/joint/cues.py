"""What is seen and learnt of each person's looks and way."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.people import Detections
from tracking.trackers.joint.looks import colours_of
from tracking.trackers.joint.settings import JointSettings
from tracking.trackers.population import Population
from tracking.trackers.stereo_walking import turning_cost, walked_on

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class JointCues:
    """The colours of both papers and the walking direction of [Kawashita2014]."""

    settings: JointSettings

    def seen(self, people: Detections) -> NDArray[np.float32]:
        """(detections, 3, bins) histograms."""
        return colours_of(people)

    def updated(
        self, model: NDArray[np.float32], seen: NDArray[np.float32], matches: NDArray[np.int32]
    ) -> NDArray[np.float32]:
        """The models after one more match: a running mean, at first of everything seen."""
        return model + self._share(matches)[:, None, None] * (seen - model)

    def looked(self, mine: Population, seen: NDArray[np.float32]) -> NDArray[np.float32]:
        """`Population.looks` after one more match, alike; what is not known now stays."""
        old = np.where(np.isfinite(mine.looks), mine.looks, seen)
        return np.where(
            np.isfinite(seen), old + self._share(mine.matches)[:, None] * (seen - old), old
        )

    def _share(self, matches: NDArray[np.int32]) -> NDArray[np.float32]:
        share = np.maximum(1.0 / (matches + 1), 1.0 - self.settings.colour_memory)
        return share.astype(np.float32)

    def direction(self, people: Population, measured: Floats) -> Floats:
        """What the turn to each detection costs, in nats; NaN where a direction is missing."""
        return turning_cost(people, measured, self.settings)

    def walked(self, people: Population, elapsed_s: float) -> Population:
        """The people with the positions brought up to date that directions are taken between."""
        return walked_on(people, elapsed_s, self.settings.direction_step_m)
