"""A score's numbers by their names, for JSON and for reading."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from tracking.scoring.hota import ALPHAS, CURVES
from tracking.scoring.track_map import OVERLAPS, SUBSETS

if TYPE_CHECKING:
    from tracking.scoring.score import Score

FIGURES: dict[str, Callable[[Score], float]] = {
    "frames": lambda s: s.frames,
    "truth_people": lambda s: s.truth_people,
    "MOTA": lambda s: s.clear.mota,
    "MOTP": lambda s: s.clear.motp,
    "IDF1": lambda s: s.identity.idf1,
    "IDP": lambda s: s.identity.idp,
    "IDR": lambda s: s.identity.idr,
    "HOTA": lambda s: s.hota.hota,
    "DetA": lambda s: s.hota.deta,
    "AssA": lambda s: s.hota.assa,
    "LocA": lambda s: s.hota.loca,
    "id_switches": lambda s: s.clear.id_switches,
    "fragmentations": lambda s: s.clear.fragmentations,
    "false_positives": lambda s: s.clear.false_positives,
    "misses": lambda s: s.clear.misses,
    "mostly_tracked": lambda s: s.clear.mostly_tracked,
    "mostly_lost": lambda s: s.clear.mostly_lost,
    "people_detected": lambda s: s.people.detected,
    "people_kept": lambda s: s.people.kept,
    "tracking_accuracy": lambda s: s.tracking_accuracy,
    "partly_tracked": lambda s: s.clear.partly_tracked,
    "matches": lambda s: s.clear.reported_matches,
    "truth_rows": lambda s: s.clear.truth_rows,
    "result_rows": lambda s: s.clear.result_rows,
    "result_tracks": lambda s: s.result_tracks,
    "MODA": lambda s: s.clear.moda,
    "MOTAL": lambda s: s.clear.motal,
    "sMOTA": lambda s: s.clear.smota,
    "precision": lambda s: s.clear.precision,
    "recall": lambda s: s.clear.recall,
    "F1": lambda s: s.clear.f1,
    "false_positives_per_frame": lambda s: s.clear.false_positives_per_frame,
    "IDTP": lambda s: s.identity.true_positives,
    "IDFN": lambda s: s.identity.misses,
    "IDFP": lambda s: s.identity.false_positives,
    "DetRe": lambda s: float(s.hota.detre_curve.mean()),
    "DetPr": lambda s: float(s.hota.detpr_curve.mean()),
    "AssRe": lambda s: float(s.hota.assre_curve.mean()),
    "AssPr": lambda s: float(s.hota.asspr_curve.mean()),
    "OWTA": lambda s: float(s.hota.owta_curve.mean()),
    "HOTA(0)": lambda s: s.hota.hota_0,
    "LocA(0)": lambda s: s.hota.loca_0,
    "HOTALocA(0)": lambda s: s.hota.hota_loca_0,
}
"""How each single number is had from a score; counts are int, shares 0 to 1."""


def figures_of(score: Score) -> dict[str, Any]:
    """All numbers by name, for `json.dumps(..., allow_nan=False)`; None where undefined.

    Curves are lists: `curves` over the similarities `curves["alpha"]`.
    """
    found: dict[str, Any] = {name: _defined(figure(score)) for name, figure in FIGURES.items()}
    return found | {
        "position_error_m": _position_error(score),
        "curves": _curves(score),
        "track_map": _track_map(score),
        "passages": {
            line.line: {"happened": line.happened, "found": line.found, "hit": line.hit}
            | {"recall": _defined(line.recall), "precision": _defined(line.precision)}
            for line in score.passages
        },
    }


def lines_of(score: Score) -> str:
    """A number a line, by name, without colours; curves are left out."""
    named = [(name, _shown(figure(score))) for name, figure in FIGURES.items()]
    named += [
        (f"position error, {name} (m)", _shown(value))
        for name, value in _position_error(score).items()
    ]
    if score.track_map is not None:
        named += [("AP (tracks)", _shown(score.track_map.ap))]
        named += [("AR (tracks)", _shown(score.track_map.ar))]
    for line in score.passages:
        named += [(f"passages {line.line}", f"{line.found} of {line.happened}")]
    width = max(len(name) for name, _ in named)
    return "\n".join(f"{name:<{width}}  {value:>9}" for name, value in named)


def _position_error(score: Score) -> dict[str, float | None]:
    error = score.position_error
    return {
        "mean": _defined(error.mean),
        "std": _defined(error.std),
        "median": _defined(error.median),
        "p95": _defined(error.p95),
    }


def _curves(score: Score) -> dict[str, list[float]]:
    curves = {name: score.hota.curve(name).tolist() for name in CURVES}
    return {"alpha": np.round(ALPHAS, 2).tolist()} | curves


def _track_map(score: Score) -> dict[str, Any] | None:
    found = score.track_map
    if found is None:
        return None
    figures: dict[str, Any] = {"overlap": np.round(OVERLAPS, 2).tolist()}
    for subset in SUBSETS:
        figures[f"AP_{subset}"] = _defined(float(found.average_precision(subset).mean()))
        figures[f"AR_{subset}"] = _defined(float(found.average_recall(subset).mean()))
    figures["AP_by_overlap"] = [_defined(one) for one in found.average_precision().tolist()]
    return figures


def _defined(value: float | None) -> float | None:
    return None if value is None or not math.isfinite(value) else value


def _shown(value: float | None) -> str:
    if value is None or not math.isfinite(value):
        return "-"
    return str(value) if isinstance(value, int) else f"{value:.4f}"
