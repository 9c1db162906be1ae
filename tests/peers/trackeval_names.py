"""Where the figures of TrackEval stand in a score of ours."""

from __future__ import annotations

import math
from collections.abc import Callable

from tests.peers.apart import Figure, Figures
from tracking.scoring import CURVES, SUBSETS, Score
from tracking.scoring.track_map import TrackMap

CLEAR: dict[str, Callable[[Score], Figure]] = {
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

IDENTITY: dict[str, Callable[[Score], Figure]] = {
    "IDTP": lambda s: s.identity.true_positives,
    "IDFN": lambda s: s.identity.misses,
    "IDFP": lambda s: s.identity.false_positives,
    "IDF1": lambda s: s.identity.idf1,
    "IDR": lambda s: s.identity.idr,
    "IDP": lambda s: s.identity.idp,
}

COUNT: dict[str, Callable[[Score], Figure]] = {
    "Dets": lambda s: s.clear.result_rows,
    "GT_Dets": lambda s: s.clear.truth_rows,
    "IDs": lambda s: s.result_tracks,
    "GT_IDs": lambda s: s.truth_people,
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
