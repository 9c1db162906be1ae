"""Our stereo trackers beside those of others, on the same detections."""

from tests.benchmarks.tracker_peers.comparing import REPORTED_SEEDS, compared, compared_on
from tests.benchmarks.tracker_peers.rows import Figures, PeerRow

__all__ = ["REPORTED_SEEDS", "Figures", "PeerRow", "compared", "compared_on"]
