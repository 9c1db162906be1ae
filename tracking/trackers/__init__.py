"""The published trackers, a module each, behind one protocol."""

from tracking.people.observation import Observation, Overlays
from tracking.settings import SettingField, settings_fields, settings_from, settings_values
from tracking.trackers.catalogue import (
    TRACKERS,
    best_tracker,
    body_part_tracker,
    changed_settings,
    detector_of,
    parse_settings,
    present_settings,
    require,
    tracker_named,
    tracker_with,
)
from tracking.trackers.shared.id_tracker import IdTracker, Known
from tracking.trackers.shared.occluders import occluders_as_setting
from tracking.trackers.shared.overlays import Bodies, RampSource, TrackerOverlays
from tracking.trackers.shared.plain_builds import one_camera, two_cameras
from tracking.trackers.shared.protocol import ASSOCIATION_COLUMNS, Perception, StepResult, Tracker
from tracking.trackers.shared.resumption import Resume
from tracking.trackers.shared.run_smoother import smooth_run
from tracking.trackers.three_part import BUILT_IN_DETECTORS
from tracking.trackers.tracker_spec import TrackerSpec

__all__ = [
    "ASSOCIATION_COLUMNS",
    "BUILT_IN_DETECTORS",
    "TRACKERS",
    "Bodies",
    "IdTracker",
    "Known",
    "Observation",
    "Overlays",
    "Perception",
    "RampSource",
    "Resume",
    "SettingField",
    "StepResult",
    "Tracker",
    "TrackerOverlays",
    "TrackerSpec",
    "best_tracker",
    "body_part_tracker",
    "changed_settings",
    "detector_of",
    "occluders_as_setting",
    "one_camera",
    "parse_settings",
    "present_settings",
    "require",
    "settings_fields",
    "settings_from",
    "settings_values",
    "smooth_run",
    "tracker_named",
    "tracker_with",
    "two_cameras",
]
