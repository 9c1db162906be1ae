"""The trackers of rectangles at their start."""

from __future__ import annotations

from tracking.people import SingleCameraPerception
from tracking.people.detection_source import DetectionSource
from tracking.recording import Recording
from tracking.trackers.shared.occluders import occluders_from
from tracking.trackers.three_part.detectors import chosen_detector
from tracking.trackers.three_part.people import Layout
from tracking.trackers.three_part.settings import ThreePartSettings, WholeBodySettings
from tracking.trackers.three_part.tracker import Camera, PartTracker

Built = tuple[SingleCameraPerception, PartTracker]


def build_three_part(
    recording: Recording,
    settings: ThreePartSettings,
    seed: int,
    boxes: DetectionSource | None = None,
) -> Built:
    """A filter for each of three parts.

    Raises `SettingsError` for occluders that are none, `FormatError` for a detector that cannot be
    read.
    """
    return _built(recording, settings, Layout(parts=3, together=1), seed, boxes)


def build_three_part_joint(
    recording: Recording,
    settings: ThreePartSettings,
    seed: int,
    boxes: DetectionSource | None = None,
) -> Built:
    """One filter for all three parts of a person; raises as `build_three_part`."""
    return _built(recording, settings, Layout(parts=3, together=3), seed, boxes)


def build_whole_body(
    recording: Recording,
    settings: WholeBodySettings,
    seed: int,
    boxes: DetectionSource | None = None,
) -> Built:
    """A filter for the whole person; raises `SettingsError` for occluders that are none."""
    return _built(recording, settings, Layout(parts=1, together=1), seed, boxes)


def _built(
    recording: Recording,
    settings: WholeBodySettings,
    layout: Layout,
    seed: int,
    boxes: DetectionSource | None,
) -> Built:
    camera = Camera(
        recording.size, recording.fps, recording.view, occluders_from(settings.occluders)
    )
    perception = SingleCameraPerception(
        recording.fps,
        recording.view,
        settings.foreground,
        settings.people,
        boxes,
        recording.looked_at,
    )
    detector = None
    if isinstance(settings, ThreePartSettings):
        detector = chosen_detector(settings.detector)
    return perception, PartTracker(camera, settings, layout, seed, detector)
