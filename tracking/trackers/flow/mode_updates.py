"""Mean shift frame after frame: the modes of one are where the next begins."""

from __future__ import annotations

from tracking.trackers.flow.kernels import KernelTable
from tracking.trackers.flow.mean_shift import Clusters, Vectors, cluster_cold, cluster_warm
from tracking.trackers.flow.settings import ClusterSettings


class ModeUpdater:
    """Gathers the tracklets of frames that follow each other [Yoneji2013] section 4.

    Args:
        settings: of clusters. table: of the kernels.
    """

    def __init__(self, settings: ClusterSettings, table: KernelTable) -> None:
        self._settings = settings
        self._table = table
        self._modes: Vectors | None = None

    def cluster(self, tracklets: Vectors) -> Clusters:
        """The clusters of a frame's tracklets (n, t, 2)."""
        settings, table = self._settings, self._table
        bounds = settings.min_points, settings.merge_distance
        if self._modes is None or not settings.warm_start:
            found = cluster_cold(tracklets, table, *bounds, occlusion=settings.occlusion)
        else:
            found = cluster_warm(
                self._modes, tracklets, table, *bounds, occlusion=settings.occlusion
            )
        self._modes = found.mode
        return found
