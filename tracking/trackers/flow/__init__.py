"""People followed by bundles of tracklets, gathered by mean shift [Yoneji2013]."""

from tracking.trackers.flow.finisher import finish_run
from tracking.trackers.flow.kernels import (
    KernelTable,
    kernel_sizes,
    kernel_table,
)
from tracking.trackers.flow.overlays import FLOW_OVERLAYS
from tracking.trackers.flow.settings import FlowSettings
from tracking.trackers.flow.setup import build_flow

__all__ = [
    "FLOW_OVERLAYS",
    "FlowSettings",
    "KernelTable",
    "build_flow",
    "finish_run",
    "kernel_sizes",
    "kernel_table",
]
