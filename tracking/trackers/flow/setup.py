"""The flow tracker at its start."""

from __future__ import annotations

from tracking.errors import CalibrationError
from tracking.people.detection_source import DetectionSource
from tracking.recording import Recording
from tracking.trackers.flow.perception import FlowPerception
from tracking.trackers.flow.settings import FlowSettings
from tracking.trackers.flow.tracker import FlowTracker


def build_flow(
    recording: Recording,
    settings: FlowSettings,
    seed: int,  # noqa: ARG001 - of every tracker; nothing here is random
    boxes: DetectionSource | None = None,
) -> tuple[FlowPerception, FlowTracker]:
    """Perception and tracker; raises `CalibrationError` where the floor is not known."""
    if recording.view is None:
        raise CalibrationError(
            "recording {name}: flow needs the camera's calibration and height over the floor; "
            "choose a tracker that works in pixels",
            name=recording.name,
        )
    perception = FlowPerception(recording.fps, settings.foreground, boxes, recording.looked_at)
    return perception, FlowTracker(perception, recording.view, recording.fps, settings)
