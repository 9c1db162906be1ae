"""The perception of short trackers: one camera or two, by their usual stages."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tracking.errors import CalibrationError
from tracking.people import SingleCameraPerception, StereoPerception
from tracking.people.detection_source import DetectionSource
from tracking.recording import Recording
from tracking.trackers.shared.protocol import Perception, Tracker

PlainBuild = Callable[[Recording, Any, int, DetectionSource | None], tuple[Perception, Tracker]]


def one_camera(tracker: Callable[[Any], Tracker]) -> PlainBuild:
    """What builds a tracker of settings with the stages `foreground` and `people`.

    Boxes of another program are used where the settings have the stage `detections`, too.
    """

    def build(
        recording: Recording, settings: Any, _seed: int, boxes: DetectionSource | None = None, /
    ) -> tuple[Perception, Tracker]:
        stages = (settings.foreground, settings.people)
        seen = (recording.fps, recording.view, *stages, boxes, recording.looked_at)
        return SingleCameraPerception(*seen), tracker(settings)

    return build


def two_cameras(tracker: Callable[[Any], Tracker]) -> PlainBuild:
    """The same of settings with the stages `foreground`, `stereo` and `people`."""

    def build(
        recording: Recording, settings: Any, _seed: int, boxes: DetectionSource | None = None, /
    ) -> tuple[Perception, Tracker]:
        if recording.rectification is None or recording.ground is None:
            raise CalibrationError(
                "recording {name}: needs two calibrated cameras and the floor", name=recording.name
            )
        geometry = (recording.rectification, recording.ground, recording.fps)
        stages = (settings.foreground, settings.stereo, settings.people)
        perception = StereoPerception(*geometry, *stages, boxes, recording.looked_at)
        return perception, tracker(settings)

    return build
