"""The tracker of [Kawashita2014]: subtraction stereo, distance, colour and walking direction."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.people import Detections, StereoPerception
from tracking.recording import Recording
from tracking.setting import setting
from tracking.trackers.population import Population
from tracking.trackers.stereo import StereoTracker, perception_and_view
from tracking.trackers.stereo_paper import PaperTracker
from tracking.trackers.stereo_settings import StereoTrackerSettings
from tracking.trackers.stereo_walking import turning_cost, walked_on

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class StereoDirectionSettings(StereoTrackerSettings):
    """Settings of `stereo-direction`."""

    paper: bool = setting(
        False, "", None, "follow people exactly as the paper does, without what was added to it"
    )
    direction_weight: float = setting(
        0.2, "", (0.0, 10.0), "cost of a turn by the threshold or more (k)"
    )
    direction_threshold_rad: float = setting(
        1.22, "rad", (0.01, 3.1416), "turn from which on the cost no longer grows"
    )
    direction_step_m: float = setting(
        0.4, "m", (0.05, 5.0), "how far apart the positions are that a direction is taken between"
    )
    direction_memory_s: float = setting(
        1.5, "s", (0.1, 60.0), "a person who takes longer for that distance is standing"
    )
    colour_memory: float = setting(
        0.97, "", (0.0, 1.0), "share of the old colour model kept at each match"
    )


@dataclass(frozen=True, slots=True)
class MiddleUpdated:
    """Hue and saturation of the region's middle, updated after each match."""

    settings: StereoDirectionSettings

    def seen(self, people: Detections) -> NDArray[np.float32]:
        """(detections, 1, bins) histograms."""
        return people.middle[:, None, :]

    def updated(
        self, model: NDArray[np.float32], seen: NDArray[np.float32], matches: NDArray[np.int32]
    ) -> NDArray[np.float32]:
        """The models after one more match: a running mean, at first of everything seen.

        Args:
            model, seen: (people, 1, bins). matches: (people,) before this one.
        """
        share = np.maximum(1.0 / (matches + 1), 1.0 - self.settings.colour_memory)
        return model + share.astype(np.float32)[:, None, None] * (seen - model)

    def direction(self, people: Population, measured: Floats) -> Floats:
        """Da of every pair: how much the way to each detection turns from the way walked."""
        return turning_cost(people, measured, self.settings)

    def walked(self, people: Population, elapsed_s: float) -> Population:
        """The people with the positions brought up to date that directions are taken between."""
        return walked_on(people, elapsed_s, self.settings.direction_step_m)


def build(
    recording: Recording, settings: StereoDirectionSettings, seed: int
) -> tuple[StereoPerception, StereoTracker | PaperTracker]:
    """Perception and tracker at their start."""
    perception, view = perception_and_view(recording, settings)
    follow = PaperTracker if settings.paper else StereoTracker
    return perception, follow(view, settings, MiddleUpdated(settings), seed)
