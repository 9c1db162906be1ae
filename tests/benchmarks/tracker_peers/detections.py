"""Detections that every tracker gets, with the truth they are judged by."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tests.benchmarks.clips import truth_table
from tracking.people import Detections
from tracking.people.observation import Observation, Overlays
from tracking.pipeline import background_samples
from tracking.recording import open_recording
from tracking.scoring import ScoringTable
from tracking.trackers import tracker_named

NO_PICTURE = Overlays(np.zeros((1, 1), np.uint8), None)
_NO_REGIONS = np.zeros((1, 1), np.int32)


@dataclass(frozen=True, slots=True)
class SeenClip:
    """What is seen of a recording, frame by frame.

    Attributes:
        name: of the clip, told with its figures.
        recording: folder of the recording whose camera and floor trackers are built on.
        observations: one for each frame from 0 on, without pictures.
        fps: frames a second.
        truth: who is where; rows that may be missed are don't-cares.
    """

    name: str
    recording: Path
    observations: tuple[Observation, ...]
    fps: float
    truth: ScoringTable

    @property
    def seen(self) -> NDArray[np.float64]:
        """(n, 8) detections as the trackers of others get them; see `tests.peers.follow`."""
        return np.concatenate([_rows(one) for one in self.observations])

    @property
    def without_colours(self) -> SeenClip:
        """The same, everybody's clothes alike and unknown."""
        bare = tuple(replace(one, people=_grey(one.people)) for one in self.observations)
        return replace(self, observations=bare)


def rendered_clip(folder: Path, perception_of: str = "stereo-joint") -> SeenClip:
    """What that tracker's perception, at its defaults, sees of a recording with truth."""
    spec = tracker_named(perception_of)
    with open_recording(folder) as recording:
        perception, _ = spec.build(recording, spec.settings_type(), 0)
        perception.learn(*background_samples(recording))
        seen = tuple(_without_pictures(perception.observe(f)) for f in recording.frames())
        return SeenClip(folder.name, folder, seen, recording.fps, truth_table(folder))


def _without_pictures(observation: Observation) -> Observation:
    people = replace(observation.people, regions=_NO_REGIONS)
    return Observation(observation.frame, observation.time_s, people, NO_PICTURE)


def _rows(observation: Observation) -> NDArray[np.float64]:
    people = observation.people
    frame = np.full(len(people), observation.frame)
    return np.column_stack((frame, people.box, people.position[:, :2], people.merged))


def _grey(people: Detections) -> Detections:
    """Equal histograms, no colour of clothes: nothing that tells one from another."""
    even = {
        name: np.full_like(histograms, 1.0 / max(histograms.shape[-1], 1))
        for name in ("upper", "lower", "middle")
        for histograms in [getattr(people, name)]
    }
    return replace(people, **even, clothes=np.full_like(people.clothes, np.nan))
