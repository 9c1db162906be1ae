"""The entry of `flow`."""

from __future__ import annotations

from tracking.trackers.flow import (
    FLOW_OVERLAYS,
    FlowSettings,
    build_flow,
    extend_trajectories,
    link_walkers,
)
from tracking.trackers.linking import Finisher, Published
from tracking.trackers.tracker_spec import TrackerSpec

_FLOW_PATH_MEMORY_S = 0.25
"""Places seen by one camera err for longer than those of two do: more of them make a path."""

FLOW = TrackerSpec(
    name="flow",
    title="One calibrated camera: tracklets clustered into people, for counting",
    paper="Yoneji2013",
    needs_stereo=False,
    needs_calibration=True,
    settings_type=FlowSettings,
    build=build_flow,
    finisher=Finisher(
        relabel=link_walkers,
        path_memory_s=_FLOW_PATH_MEMORY_S,
        extend=extend_trajectories,
        published=Published((("persistent_points", False),)),
    ),
    overlays=FLOW_OVERLAYS,
)
