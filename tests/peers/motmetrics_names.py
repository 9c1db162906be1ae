"""Where the figures of py-motmetrics stand in a score of ours."""

from __future__ import annotations

from collections.abc import Callable

from tests.peers.apart import Figures
from tracking.scoring import Score

NAMES: dict[str, Callable[[Score], float]] = {
    "num_objects": lambda s: s.clear.truth_rows,
    "num_predictions": lambda s: s.clear.result_rows,
    "num_unique_objects": lambda s: s.truth_people,
    "num_matches": lambda s: s.as_json()["matches"],
    "num_switches": lambda s: s.clear.id_switches,
    "num_detections": lambda s: s.clear.matches,
    "num_false_positives": lambda s: s.clear.false_positives,
    "num_misses": lambda s: s.clear.misses,
    "num_fragmentations": lambda s: s.clear.fragmentations,
    "mostly_tracked": lambda s: s.clear.mostly_tracked,
    "partially_tracked": lambda s: s.clear.partly_tracked,
    "mostly_lost": lambda s: s.clear.mostly_lost,
    "mota": lambda s: s.clear.mota,
    "motp": lambda s: s.clear.motp,
    "precision": lambda s: s.clear.precision,
    "recall": lambda s: s.clear.recall,
    "idf1": lambda s: s.identity.idf1,
    "idp": lambda s: s.identity.idp,
    "idr": lambda s: s.identity.idr,
    "idtp": lambda s: s.identity.true_positives,
    "idfp": lambda s: s.identity.false_positives,
    "idfn": lambda s: s.identity.misses,
}


def motmetrics_figures(score: Score) -> Figures:
    """All of a score, measured by its conventions, by its names."""
    return {name: figure(score) for name, figure in NAMES.items()}
