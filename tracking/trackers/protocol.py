"""What every tracker gives for a frame, and what the program asks of a tracker."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Protocol

from tracking.people.observation import Observation
from tracking.recording.frame import StereoFrame
from tracking.tracks.columns import Columns


@dataclass(frozen=True, slots=True)
class StepResult:
    """One frame's result.

    Attributes:
        frame: frame number.
        tracks: `TRACK_COLUMNS` of this frame, sorted by track.
        detections: `DETECTION_COLUMNS` of this frame.
        particles: `PARTICLE_COLUMNS` of this frame, grouped by track.
        associations: frame, track, distance, colour, direction, total, margin; a row a match.
    """

    frame: int
    tracks: Columns
    detections: Columns
    particles: Columns
    associations: Columns


class Perception(Protocol):
    """Turns pictures into observations; holds the background model."""

    def observe(self, frame: StereoFrame) -> Observation:
        """What is seen in the frame. Frames come in order."""


class Tracker(Protocol):
    """Follows people over observations; holds the particles."""

    def step(self, observation: Observation) -> StepResult:
        """Take one frame further. Frames come in order."""

    @property
    def settings(self) -> Any:
        """The frozen settings in force."""
