"""People followed by bundles of tracklets, gathered by mean shift [Yoneji2013]."""

from tracking.trackers.flow.kernels import KernelTable, kernel_sizes, kernel_table

__all__ = ["KernelTable", "kernel_sizes", "kernel_table"]
