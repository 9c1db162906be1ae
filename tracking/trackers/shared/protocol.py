"""What every tracker gives for a frame, and what the program asks of a tracker."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any, Protocol

import numpy as np

from tracking.people.observation import Observation
from tracking.people.stereo_watch import StereoWatch
from tracking.recording.frame import StereoFrame
from tracking.trackers.shared.resumption import Resume
from tracking.tracks.columns import (
    EMBEDDING_COLUMNS,
    NETWORK_BOX_COLUMNS,
    PART_COLUMNS,
    PART_PARTICLE_COLUMNS,
    SIGNAL_COLUMNS,
    TRACKLET_COLUMNS,
    Columns,
    empty,
)
from tracking.translation import Message

ASSOCIATION_COLUMNS: Mapping[str, np.dtype[Any]] = MappingProxyType(
    {
        "frame": np.dtype(np.int32),
        "track": np.dtype(np.int32),
        "distance": np.dtype(np.float32),  # Dd, m
        "colour": np.dtype(np.float32),  # Dc
        "direction": np.dtype(np.float32),  # Da; NaN where it was left out
        "total": np.dtype(np.float32),  # D
        "margin": np.dtype(np.float32),  # D of the best other choice less this one's; NaN: none
    }
)


@dataclass(frozen=True, slots=True)
class StepResult:
    """One frame's result.

    Attributes:
        frame: frame number.
        tracks: `TRACK_COLUMNS` of this frame, sorted by track.
        detections: `DETECTION_COLUMNS` of this frame.
        particles: `PARTICLE_COLUMNS` of this frame, grouped by track.
        associations: `ASSOCIATION_COLUMNS`; a row for each match.
        signals: `SIGNAL_COLUMNS`, a row for each row of `tracks`; empty where the tracker notices
            nothing beside them.
        parts: `PART_COLUMNS` of this frame, sorted by track then part; empty where the tracker
            follows people whole.
        part_particles: `PART_PARTICLE_COLUMNS` of this frame, grouped by track then part.
        tracklets: `TRACKLET_COLUMNS` of this frame, grouped by track.
        network_boxes, embeddings: `NETWORK_BOX_COLUMNS`, `EMBEDDING_COLUMNS` of this frame; the
            pipeline adds them, no tracker.
    """

    frame: int
    tracks: Columns
    detections: Columns
    particles: Columns
    associations: Columns
    signals: Columns = field(default_factory=lambda: empty(SIGNAL_COLUMNS))
    parts: Columns = field(default_factory=lambda: empty(PART_COLUMNS))
    part_particles: Columns = field(default_factory=lambda: empty(PART_PARTICLE_COLUMNS))
    tracklets: Columns = field(default_factory=lambda: empty(TRACKLET_COLUMNS))
    network_boxes: Columns = field(default_factory=lambda: empty(NETWORK_BOX_COLUMNS))
    embeddings: Columns = field(default_factory=lambda: empty(EMBEDDING_COLUMNS))


class Perception(Protocol):
    """Turns pictures into observations; holds the background model."""

    @property
    def stereo_watch(self) -> StereoWatch | None:
        """How the cameras' frames are to be paired; None: it looks with one camera."""

    @property
    def notes(self) -> tuple[Message, ...]:
        """Notes for the user about the footage, a line each."""

    def learn(self, frames: Sequence[StereoFrame], later: Sequence[StereoFrame] = ()) -> None:
        """Take the background from frames spread over the recording, before the first step."""

    def observe(self, frame: StereoFrame) -> Observation:
        """What is seen in the frame. Frames come in order."""


class Tracker(Protocol):
    """Follows people over observations; holds the particles.

    One that tells where the time of its steps goes has `stage_s`, too: seconds spent so far by
    stage.
    """

    def resume(self, resume: Resume, observations: Iterable[Observation]) -> None:
        """Before the first step: go on with people as corrected.

        Args:
            observations: of the frames `resume.colour_frames`, in order; their colours are learnt
            there.
        """

    def step(self, observation: Observation) -> StepResult:
        """Take one frame further. Frames come in order."""

    @property
    def settings(self) -> Any:
        """The frozen settings in force."""

    @property
    def notes(self) -> tuple[Message, ...]:
        """Notes for the user about the tracking, a line each."""
