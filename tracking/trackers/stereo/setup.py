"""What every stereo tracker needs of a recording."""

from __future__ import annotations

from tracking.errors import CalibrationError
from tracking.geometry import View
from tracking.people import DepthPerception, StereoPerception
from tracking.people.detection_source import DetectionSource
from tracking.recording import Recording
from tracking.trackers.stereo.settings import StereoFilterSettings


def perception_and_view(
    recording: Recording, settings: StereoFilterSettings, boxes: DetectionSource | None = None
) -> tuple[StereoPerception | DepthPerception, View]:
    """Stereo perception, or by depth, at its start, and the camera that people are seen by.

    Raises `CalibrationError`: the recording has not what metres on the floor need.
    """
    rectification, ground, view = recording.rectification, recording.ground, recording.view
    if rectification is None or ground is None or view is None:
        raise CalibrationError(
            "recording {name}: stereo trackers need two calibrated cameras and the floor; add "
            "[calibration] and [ground] to recording.toml",
            name=recording.name,
        )
    kind = DepthPerception if recording.has_depth else StereoPerception
    perception = kind(
        rectification,
        ground,
        recording.fps,
        foreground=settings.foreground,
        stereo=settings.stereo,
        people=settings.people,
        boxes=boxes,
        looked_at=recording.looked_at,
    )
    return perception, view
