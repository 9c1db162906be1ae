"""The conformance kit: what every plug-in must do, as functions that a package's tests call.

Each check raises `BrokenRule`, an AssertionError, which says what is wrong and what to do. Nothing
here needs pytest.
"""

from tracking.plugins import PluginKind
from tracking.testing.detector_kit import check_box_format, check_detector
from tracking.testing.format_kit import check_format
from tracking.testing.recording_kit import check_recording
from tracking.testing.rules import BrokenRule, check_installed
from tracking.testing.tracker_kit import check_tracker

__all__ = [
    "BrokenRule",
    "PluginKind",
    "check_box_format",
    "check_detector",
    "check_format",
    "check_installed",
    "check_recording",
    "check_tracker",
]
