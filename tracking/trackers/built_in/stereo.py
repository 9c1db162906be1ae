"""The entries of `stereo-direction` and `stereo-colour`."""

from __future__ import annotations

from tracking.trackers.linking import Finisher, Published
from tracking.trackers.shared.overlays import TrackerOverlays
from tracking.trackers.stereo import colour as stereo_colour
from tracking.trackers.stereo import direction as stereo_direction
from tracking.trackers.tracker_spec import TrackerSpec

_TWO_CAMERAS = TrackerOverlays(subtraction=True)
_LIVE_IF_PAPER = Finisher(published=Published((("paper", True),), smoothed=False))

STEREO_DIRECTION = TrackerSpec(
    name="stereo-direction",
    title="Two cameras: particle filter with distance, colour and walking direction",
    paper="Kawashita2014",
    needs_stereo=True,
    needs_calibration=True,
    settings_type=stereo_direction.StereoDirectionSettings,
    build=stereo_direction.build,
    finisher=_LIVE_IF_PAPER,
    overlays=_TWO_CAMERAS,
)

STEREO_COLOUR = TrackerSpec(
    name="stereo-colour",
    title="Two cameras: particle filter with distance and colour",
    paper="Kawashita2012",
    needs_stereo=True,
    needs_calibration=True,
    settings_type=stereo_colour.StereoColourSettings,
    build=stereo_colour.build,
    finisher=_LIVE_IF_PAPER,
    overlays=_TWO_CAMERAS,
)
