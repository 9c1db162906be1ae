"""People followed by bundles of tracklets, gathered by mean shift [Yoneji2013]."""

from tracking.trackers.flow.kernels import (
    KernelTable,
    kernel_sizes,
    kernel_table,
)
from tracking.trackers.flow.overlays import FLOW_OVERLAYS
from tracking.trackers.flow.predicted_rows import extend_trajectories
from tracking.trackers.flow.relabel_run import link_walkers
from tracking.trackers.flow.settings import FlowSettings
from tracking.trackers.flow.setup import build_flow

__all__ = [
    "FLOW_OVERLAYS",
    "FlowSettings",
    "KernelTable",
    "build_flow",
    "extend_trajectories",
    "kernel_sizes",
    "kernel_table",
    "link_walkers",
]
