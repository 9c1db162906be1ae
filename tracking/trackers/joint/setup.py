"""The joint stereo tracker over a recording."""

from __future__ import annotations

from tracking.people import DepthPerception, StereoPerception
from tracking.people.detection_source import DetectionSource
from tracking.recording import Recording
from tracking.trackers.joint.settings import JointSettings
from tracking.trackers.joint.tracker import JointTracker
from tracking.trackers.stereo.setup import perception_and_view


def build_joint(
    recording: Recording, settings: JointSettings, seed: int, boxes: DetectionSource | None = None
) -> tuple[StereoPerception | DepthPerception, JointTracker]:
    """Perception and tracker at their start."""
    perception, view = perception_and_view(recording, settings, boxes)
    return perception, JointTracker(view, settings, seed)
