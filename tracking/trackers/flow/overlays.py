"""What a view can draw of the flow tracker's work: tracklets, and the kernel round a person."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import View
from tracking.trackers.flow.kernels import kernel_rectangles
from tracking.trackers.flow.settings import FlowSettings
from tracking.trackers.shared.overlays import TrackerOverlays

Floats = NDArray[np.float64]


def _kernels(view: View, settings: FlowSettings, xy: Floats) -> Floats:
    """(n, 4, 2) px: the rectangles in which mean shift gathers tracklets round people's middles."""
    clusters = settings.clusters
    middle = np.column_stack((xy, np.full(len(xy), clusters.centre_m)))
    return kernel_rectangles(view, view.pixel_from_world(middle), clusters)


FLOW_OVERLAYS = TrackerOverlays(tracklets=True, kernel=_kernels)
