"""The entry of `spheroid`."""

from __future__ import annotations

from tracking.trackers.linking import Finisher, Published, link_tracks
from tracking.trackers.spheroid import SPHEROID_OVERLAYS, SpheroidSettings, build_spheroid
from tracking.trackers.tracker_spec import TrackerSpec

SPHEROID = TrackerSpec(
    name="spheroid",
    title="One calibrated camera: particle filter on the floor, weighted by silhouettes",
    paper="Waechter2013",
    needs_stereo=False,
    needs_calibration=True,
    settings_type=SpheroidSettings,
    build=build_spheroid,
    finisher=Finisher(relabel=link_tracks, published=Published((("paper", True),))),
    overlays=SPHEROID_OVERLAYS,
)
