"""From files to a recording: cameras found, and recording.toml written."""

from tracking.setup.cameras import CameraFindings, find_cameras
from tracking.setup.pair_names import NamedPair, pair_by_name
from tracking.setup.plan import SetupPlan, plan_of, write_setup

__all__ = [
    "CameraFindings",
    "NamedPair",
    "SetupPlan",
    "find_cameras",
    "pair_by_name",
    "plan_of",
    "write_setup",
]
