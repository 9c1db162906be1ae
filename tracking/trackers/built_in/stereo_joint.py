"""The entry of `stereo-joint`."""

from __future__ import annotations

from tracking.trackers.joint import JointSettings, build_joint
from tracking.trackers.linking import Finisher, link_tracks
from tracking.trackers.shared.overlays import TrackerOverlays
from tracking.trackers.tracker_spec import TrackerSpec

STEREO_JOINT = TrackerSpec(
    name="stereo-joint",
    title="Two cameras: joint assignment of all tracks by position, appearance and direction",
    paper="",
    needs_stereo=True,
    needs_calibration=True,
    settings_type=JointSettings,
    build=build_joint,
    finisher=Finisher(relabel=link_tracks),
    overlays=TrackerOverlays(subtraction=True),
)
