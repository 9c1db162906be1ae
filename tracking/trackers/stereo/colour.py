"""The tracker of [Kawashita2012]: subtraction stereo, distance and the colour of two halves."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from tracking.people import DepthPerception, Detections, StereoPerception
from tracking.people.detection_source import DetectionSource
from tracking.recording import Recording
from tracking.setting import setting
from tracking.trackers.stereo.paper import PaperTracker
from tracking.trackers.stereo.population import Population
from tracking.trackers.stereo.settings import StereoTrackerSettings
from tracking.trackers.stereo.setup import perception_and_view
from tracking.trackers.stereo.tracker import StereoTracker

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class StereoColourSettings(StereoTrackerSettings):
    """Settings of `stereo-colour`."""

    paper: bool = setting(
        False,
        "",
        None,
        "Track exactly as published, without our additions: colours count as in the paper, and "
        "nothing is smoothed",
    )
    particles: int = setting(
        700,
        "",
        (10, 20000),
        "Particles per person; higher: tracking in crowds is more reliable but takes more time",
        group="Particles and motion",
    )
    cost_limit: float = setting(
        2.5,
        "",
        (0.1, 10.0),
        "Highest cost at which a detection is associated with a track; higher: fewer gaps, more "
        "id switches",
        group="Association",
        expert=True,
    )
    model_frames: int = setting(
        5,
        "",
        (1, 1000),
        "The colour model is the mean over this many first frames of a track; higher: steadier "
        "colours, but available later",
        group="Association",
        expert=True,
    )


@dataclass(frozen=True, slots=True)
class HalvesOfFirstFrames:
    """Hue of the upper and the lower body, each the mean over a person's first frames."""

    settings: StereoColourSettings

    def measure_colours(self, people: Detections) -> NDArray[np.float32]:
        """(detections, 2, bins) histograms."""
        return np.stack((people.upper, people.lower), axis=1)

    def update_colours(
        self, model: NDArray[np.float32], seen: NDArray[np.float32], matches: NDArray[np.int32]
    ) -> NDArray[np.float32]:
        """The models after one more match; they stand still once the first frames are over.

        Args:
            model, seen: (people, 2, bins). matches: (people,) before this one.
        """
        share = np.where(matches < self.settings.model_frames, 1.0 / (matches + 1), 0.0)
        return model + share.astype(np.float32)[:, None, None] * (seen - model)

    def is_complete(self, matches: NDArray[np.int32]) -> NDArray[np.bool_]:
        """(people,) whose first frames are over: before, the paper compares no colours."""
        return np.asarray(matches >= self.settings.model_frames)

    def direction(self, people: Population, measured: Floats) -> Floats:
        """The walking direction is no cue of this paper's: NaN for all pairs."""
        return np.full((len(people), len(measured)), np.nan)

    def update_anchors(self, people: Population, elapsed_s: float) -> Population:  # noqa: ARG002
        """Nothing is kept of where people walked."""
        return people


def build(
    recording: Recording,
    settings: StereoColourSettings,
    seed: int,
    boxes: DetectionSource | None = None,
) -> tuple[StereoPerception | DepthPerception, StereoTracker | PaperTracker]:
    """Perception and tracker at their start."""
    follow = PaperTracker if settings.paper else StereoTracker
    if settings.paper:
        settings = replace(settings, people=replace(settings.people, hue_by_saturation=False))
    perception, view = perception_and_view(recording, settings, boxes)
    return perception, follow(view, settings, HalvesOfFirstFrames(settings), seed)
