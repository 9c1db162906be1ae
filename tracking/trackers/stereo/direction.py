"""The tracker of [Kawashita2014]: subtraction stereo, distance, colour and walking direction."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.people import DepthPerception, Detections, StereoPerception
from tracking.people.detection_source import DetectionSource
from tracking.recording import Recording
from tracking.setting import setting
from tracking.trackers.stereo.paper import PaperTracker
from tracking.trackers.stereo.settings import StereoTrackerSettings
from tracking.trackers.stereo.setup import perception_and_view
from tracking.trackers.stereo.tracker import StereoTracker
from tracking.trackers.stereo.walking_direction import WalkingCues, WalkingSettings


@dataclass(frozen=True, slots=True)
class StereoDirectionSettings(WalkingSettings, StereoTrackerSettings):
    """Settings of `stereo-direction`."""

    paper: bool = setting(
        False,
        "",
        None,
        "Track exactly as published, without our additions: nothing is smoothed either",
    )


@dataclass(frozen=True, slots=True)
class MiddleUpdated(WalkingCues):
    """Hue and saturation of the region's middle, updated after each match."""

    def measure_colours(self, people: Detections) -> NDArray[np.float32]:
        """(detections, 1, bins) histograms."""
        return people.middle[:, None, :]


def build(
    recording: Recording,
    settings: StereoDirectionSettings,
    seed: int,
    boxes: DetectionSource | None = None,
) -> tuple[StereoPerception | DepthPerception, StereoTracker | PaperTracker]:
    """Perception and tracker at their start."""
    perception, view = perception_and_view(recording, settings, boxes)
    follow = PaperTracker if settings.paper else StereoTracker
    return perception, follow(view, settings, MiddleUpdated(settings), seed)
