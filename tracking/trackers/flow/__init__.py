"""People followed by bundles of tracklets, gathered by mean shift [Yoneji2013]."""

from tracking.trackers.flow.building import build_flow
from tracking.trackers.flow.kernels import (
    KernelTable,
    kernel_rectangles,
    kernel_sizes,
    kernel_table,
)
from tracking.trackers.flow.settings import FlowSettings

__all__ = [
    "FlowSettings",
    "KernelTable",
    "build_flow",
    "kernel_rectangles",
    "kernel_sizes",
    "kernel_table",
]
