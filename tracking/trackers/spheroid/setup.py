"""The spheroid tracker at its start."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.errors import CalibrationError
from tracking.geometry import FlatView
from tracking.people.detection_source import DetectionSource
from tracking.recording import Recording
from tracking.trackers.shared.occluders import Polygons, occluder_mask, occluders_from
from tracking.trackers.spheroid.perception import SpheroidPerception
from tracking.trackers.spheroid.settings import SpheroidSettings
from tracking.trackers.spheroid.tracker import SpheroidTracker


def build_spheroid(
    recording: Recording,
    settings: SpheroidSettings,
    seed: int,
    boxes: DetectionSource | None = None,
) -> tuple[SpheroidPerception, SpheroidTracker]:
    """Perception and tracker at their start; of a stereo recording the left camera is looked at.

    Raises:
        CalibrationError: the recording has not what metres on the floor need.
    """
    view = recording.view
    if view is None:
        raise CalibrationError(
            "recording {name}: spheroids stand on a floor that is known; add [calibration] and "
            "[ground] to recording.toml, or choose a tracker that works in pixels",
            name=recording.name,
        )
    perception = SpheroidPerception(
        recording.fps, view, settings.foreground, settings.ramp, boxes, recording.looked_at
    )
    shown = perception.flat.covered & ~_hidden(occluders_from(settings.occluders), perception.flat)
    if recording.looked_at is not None:  # what stands there is not known, as behind what is drawn
        shown &= perception.flat.flatten(recording.looked_at) > 0
    return perception, SpheroidTracker(perception, settings, shown, seed)


def _hidden(occluders: Polygons, flat: FlatView) -> NDArray[np.bool_]:
    """(height, width) flat pixels behind what is drawn."""
    drawn = [flat.flat_from_recorded(outline) for outline in occluders]
    known = [corners for corners in drawn if np.isfinite(corners).all()]
    return occluder_mask(known, flat.size[::-1]) > 0
