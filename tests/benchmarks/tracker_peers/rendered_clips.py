"""Rendered recordings as our own perception sees them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from tests.benchmarks.tracker_peers.clips import Clip
from tracking.formats import read_mot
from tracking.people.observation import Observation, Overlays
from tracking.pipeline import background_samples
from tracking.recording import open_recording
from tracking.scoring import ScoringTable
from tracking.trackers import tracker_named

_NO_PICTURE = Overlays(np.zeros((1, 1), np.uint8), None)
_NO_REGIONS = np.zeros((1, 1), np.int32)


def rendered_clip(folder: Path, perception_of: str = "stereo-joint") -> Clip:
    """What that tracker's perception, at its defaults, sees of a recording with truth."""
    spec = tracker_named(perception_of)
    with open_recording(folder) as recording:
        perception, _ = spec.build(recording, spec.settings_type(), 0)
        perception.learn(background_samples(recording))
        seen = tuple(_kept(perception.observe(frame)) for frame in recording.frames())
        fps = recording.fps
    truth = ScoringTable.from_columns(read_mot(folder / "truth.txt"), dont_cares=True)
    return Clip(folder.name, folder, seen, fps, truth)


def _kept(observation: Observation) -> Observation:
    """Without what is as large as a picture."""
    people = replace(observation.people, regions=_NO_REGIONS)
    return Observation(observation.frame, observation.time_s, people, _NO_PICTURE)
