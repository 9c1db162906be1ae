"""The published trackers, a module each, behind one protocol."""

from tracking.people.observation import Observation, Overlays
from tracking.settings import SettingField, settings_fields, settings_from, settings_values
from tracking.trackers.catalogue import (
    TRACKERS,
    TrackerSpec,
    best_tracker,
    changed_settings,
    detector_of,
    parse_settings,
    present_settings,
    require,
    tracker_named,
)
from tracking.trackers.shared.occluders import occluders_as_setting
from tracking.trackers.shared.protocol import ASSOCIATION_COLUMNS, Perception, StepResult, Tracker
from tracking.trackers.shared.resumption import Resume
from tracking.trackers.shared.run_smoother import smooth_run

__all__ = [
    "ASSOCIATION_COLUMNS",
    "TRACKERS",
    "Observation",
    "Overlays",
    "Perception",
    "Resume",
    "SettingField",
    "StepResult",
    "Tracker",
    "TrackerSpec",
    "best_tracker",
    "changed_settings",
    "detector_of",
    "occluders_as_setting",
    "parse_settings",
    "present_settings",
    "require",
    "settings_fields",
    "settings_from",
    "settings_values",
    "smooth_run",
    "tracker_named",
]
