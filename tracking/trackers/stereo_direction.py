"""The tracker of [Kawashita2014]: subtraction stereo, distance, colour and walking direction."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import direction_cost, turning_angle
from tracking.people import Detections, StereoPerception
from tracking.recording import Recording
from tracking.setting import setting
from tracking.trackers.population import Population
from tracking.trackers.stereo import StereoTracker, perception_and_view
from tracking.trackers.stereo_paper import PaperTracker
from tracking.trackers.stereo_settings import StereoTrackerSettings

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
        """Da of every pair: how much the way to each detection turns from the way walked.

        The way to a detection starts at the newer anchor, or at the older one where the detection
        is too close to the newer to give a direction.
        """
        settings = self.settings
        older, newer = people.anchors[:, 0], people.anchors[:, 1]
        standing = people.anchor_age_s > settings.direction_memory_s
        walked = np.where(standing[:, None], np.nan, newer - older)
        from_newer = measured[None] - newer[:, None]
        too_close = np.hypot(from_newer[..., 0], from_newer[..., 1]) < settings.direction_step_m
        way = np.where(too_close[..., None], measured[None] - older[:, None], from_newer)
        angle = turning_angle(walked, way)
        return direction_cost(angle, settings.direction_threshold_rad, settings.direction_weight)

    def walked(self, people: Population, elapsed_s: float) -> Population:
        """Where the person is becomes the newer anchor once it is far enough from the last."""
        newer = people.anchors[:, 1]
        gone = people.position - newer
        seen = people.missed_s == 0.0
        far = seen & (np.hypot(gone[:, 0], gone[:, 1]) >= self.settings.direction_step_m)
        moved = np.stack((newer, people.position), axis=1)
        return people.replace(
            anchors=np.where(far[:, None, None], moved, people.anchors),
            anchor_age_s=np.where(far, 0.0, people.anchor_age_s + elapsed_s),
        )


def build(
    recording: Recording, settings: StereoDirectionSettings, seed: int
) -> tuple[StereoPerception, StereoTracker | PaperTracker]:
    """Perception and tracker at their start."""
    perception, view = perception_and_view(recording, settings)
    follow = PaperTracker if settings.paper else StereoTracker
    return perception, follow(view, settings, MiddleUpdated(settings), seed)
