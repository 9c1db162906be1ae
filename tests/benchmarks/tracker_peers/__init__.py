"""Our stereo trackers beside those of others, on the same detections."""

from tests.benchmarks.tracker_peers.comparison import (
    REPORTED_SEEDS,
    compared,
    compared_on,
    measure,
)
from tests.benchmarks.tracker_peers.rendered_clips import rendered_clip
from tests.benchmarks.tracker_peers.report import as_json, markdown
from tests.benchmarks.tracker_peers.rows import Figures, PeerRow

__all__ = [
    "REPORTED_SEEDS",
    "Figures",
    "PeerRow",
    "as_json",
    "compared",
    "compared_on",
    "markdown",
    "measure",
    "rendered_clip",
]
