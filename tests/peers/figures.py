"""The figures of TrackEval and py-motmetrics: where they stand in a score of ours, how far apart.

Curves are lists; None in what peers say is undefined.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from tracking.scoring import CURVES, SUBSETS, Score
from tracking.scoring.track_map import TrackMap

Figure = float | list[float]
Figures = dict[str, Figure]
"""By the peer's names."""
Names = dict[str, Callable[[Score], Figure]]

COUNTS = frozenset(
    [f"CLEAR.{name}" for name in ("CLR_TP", "CLR_FN", "CLR_FP", "IDSW", "MT", "PT", "ML", "Frag")]
    + ["CLEAR.CLR_Frames", "Identity.IDTP", "Identity.IDFN", "Identity.IDFP"]
    + ["HOTA.HOTA_TP", "HOTA.HOTA_FN", "HOTA.HOTA_FP"]
    + ["Count.Dets", "Count.GT_Dets", "Count.IDs", "Count.GT_IDs"]
    + ["num_objects", "num_predictions", "num_unique_objects", "num_matches", "num_switches"]
    + ["num_detections", "num_false_positives", "num_misses", "num_fragmentations"]
    + ["mostly_tracked", "partially_tracked", "mostly_lost", "idtp", "idfp", "idfn"]
)
"""Whole numbers: they must be the same; everything else within 1e-9."""


def differences(ours: Figures, theirs: Figures) -> dict[str, float]:
    """How far each figure of theirs is from ours; what we do not have is as far as can be."""
    return {name: _apart(ours.get(name, math.inf), value) for name, value in theirs.items()}


def _apart(ours: Figure, theirs: Figure | None) -> float:
    if isinstance(ours, list) and isinstance(theirs, list):
        if len(ours) != len(theirs):
            return math.inf
        return max((_apart(a, b) for a, b in zip(ours, theirs, strict=True)), default=0.0)
    if isinstance(ours, list) or isinstance(theirs, list):
        return math.inf
    if theirs is None or not math.isfinite(ours):
        return 0.0 if theirs is None and not math.isfinite(ours) else math.inf
    return abs(ours - theirs)


CLEAR: Names = {
    "CLR_TP": lambda s: s.clear.matches,
    "CLR_FN": lambda s: s.clear.misses,
    "CLR_FP": lambda s: s.clear.false_positives,
    "IDSW": lambda s: s.clear.id_switches,
    "MT": lambda s: s.clear.mostly_tracked,
    "PT": lambda s: s.clear.partly_tracked,
    "ML": lambda s: s.clear.mostly_lost,
    "Frag": lambda s: s.clear.fragmentations,
    "CLR_Frames": lambda s: s.clear.frames,
    "MOTA": lambda s: s.clear.mota,
    "MOTP": lambda s: s.clear.motp,
    "MODA": lambda s: s.clear.moda,
    "CLR_Re": lambda s: s.clear.recall,
    "CLR_Pr": lambda s: s.clear.precision,
    "MTR": lambda s: s.clear.mostly_tracked_share,
    "PTR": lambda s: s.clear.partly_tracked_share,
    "MLR": lambda s: s.clear.mostly_lost_share,
    "sMOTA": lambda s: s.clear.smota,
    "CLR_F1": lambda s: s.clear.f1,
    "FP_per_frame": lambda s: s.clear.false_positives_per_frame,
    "MOTAL": lambda s: s.clear.motal,
    "MOTP_sum": lambda s: s.clear.similarity,
}
IDENTITY: Names = {
    "IDTP": lambda s: s.identity.true_positives,
    "IDFN": lambda s: s.identity.misses,
    "IDFP": lambda s: s.identity.false_positives,
    "IDF1": lambda s: s.identity.idf1,
    "IDR": lambda s: s.identity.idr,
    "IDP": lambda s: s.identity.idp,
}
COUNT: Names = {
    "Dets": lambda s: s.clear.result_rows,
    "GT_Dets": lambda s: s.clear.truth_rows,
    "IDs": lambda s: s.result_tracks,
    "GT_IDs": lambda s: s.truth_people,
}
MOTMETRICS: Names = {
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


def trackeval_figures(score: Score) -> Figures:
    """All of a score by TrackEval's names, `CLEAR.MOTA` and so on; curves are lists."""
    found: Figures = {}
    for metric, names in (("CLEAR", CLEAR), ("Identity", IDENTITY), ("Count", COUNT)):
        found |= {f"{metric}.{name}": figure(score) for name, figure in names.items()}
    hota = score.hota
    found |= {f"HOTA.{name}": hota.curve(name).tolist() for name in CURVES}
    found["HOTA.HOTA_TP"] = hota.matches.tolist()
    found["HOTA.HOTA_FN"] = hota.misses.tolist()
    found["HOTA.HOTA_FP"] = hota.false_positives.tolist()
    found["HOTA.HOTA(0)"] = hota.hota_0
    found["HOTA.LocA(0)"] = hota.loca_0
    found["HOTA.HOTALocA(0)"] = hota.hota_loca_0
    return found | ({} if score.track_map is None else _of_tracks(score.track_map))


def _of_tracks(found: TrackMap) -> Figures:
    figures: Figures = {}
    for subset in SUBSETS:
        for name, curve in (
            ("AP", found.average_precision(subset)),
            ("AR", found.average_recall(subset)),
        ):
            # TrackEval says -1 where there is nobody to look for.
            told = [-1.0 if math.isnan(one) else one for one in curve.tolist()]
            figures[f"TrackMAP.{name}_{subset}"] = told
    return figures


def motmetrics_figures(score: Score) -> Figures:
    """All of a score, measured by its conventions, by its names."""
    return {name: figure(score) for name, figure in MOTMETRICS.items()}
