"""All measures of a result against truth, in one value."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from tracking.scoring.clear import Clear
from tracking.scoring.clear_counts import clear
from tracking.scoring.conventions import Conventions
from tracking.scoring.examination import Examination, examine
from tracking.scoring.hota import ALPHAS, CURVES, Hota
from tracking.scoring.hota_counts import hota
from tracking.scoring.identity import Identity, identity
from tracking.scoring.papers import People, PositionError, people
from tracking.scoring.passages import PassageScore
from tracking.scoring.similarity import Match
from tracking.scoring.table import ScoringTable
from tracking.scoring.track_map import OVERLAPS, SUBSETS, TrackMap
from tracking.scoring.track_map_matches import track_map
from tracking.text_columns import columns_of, to_left, to_right
from tracking.translation import msg, tr


@dataclass(frozen=True, slots=True, eq=False)
class Score:
    """How good a result is. Shares are 0 to 1.

    Attributes:
        frames: length of the recording, as far as it is known.
        truth_people: people in the truth. result_tracks: tracks in the result.
        track_map: None where the result has no confidences or rows were not matched by boxes.
        passages: of counting lines, where there are any; see `PassageScore`.
    """

    frames: int
    truth_people: int
    result_tracks: int
    clear: Clear
    identity: Identity
    hota: Hota
    people: People
    position_error: PositionError
    track_map: TrackMap | None = None
    passages: tuple[PassageScore, ...] = ()

    @property
    def tracking_accuracy(self) -> float:
        """People kept / people detected, the papers' measure; NaN when nobody is detected."""
        return self.people.kept / self.people.detected if self.people.detected else math.nan

    def as_json(self) -> dict[str, Any]:
        """The numbers by the names `score --json` has; None where a number is undefined.

        For `json.dumps(..., allow_nan=False)`. Curves are lists: `curves` over the similarities
        `curves["alpha"]`.
        """
        found: dict[str, Any] = {name: _defined(figure(self)) for name, figure in FIGURES.items()}
        return found | {
            "position_error_m": _position_error(self),
            "curves": _curves(self),
            "track_map": _track_map(self),
            "passages": {
                line.line: {"happened": line.happened, "found": line.found, "hit": line.hit}
                | {"recall": _defined(line.recall), "precision": _defined(line.precision)}
                for line in self.passages
            },
        }

    def as_text(self) -> str:
        """A number a line, by its name in `as_json` or in the user's words; no curves."""
        named = [(name, _shown(figure(self))) for name, figure in FIGURES.items()]
        named += [
            (tr("position error, {which} (m)", which=_WHICH[name]), _shown(value))
            for name, value in _position_error(self).items()
        ]
        if self.track_map is not None:
            named += [(tr("AP (tracks)"), _shown(self.track_map.ap))]
            named += [(tr("AR (tracks)"), _shown(self.track_map.ar))]
        for line in self.passages:
            named += [
                (
                    tr("passages {line}", line=line.line),
                    tr("{found} of {happened}", found=line.found, happened=line.happened),
                )
            ]
        width = max(columns_of(name) for name, _ in named)
        return "\n".join(f"{to_left(name, width)}  {to_right(value, 9)}" for name, value in named)


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


def score(
    truth: ScoringTable,
    result: ScoringTable,
    match: Match | None = None,
    frames: int = 0,
    conventions: Conventions = Conventions.TRACKEVAL,
) -> Score:
    """Measure a result against truth.

    `MOTA`, `IDF1`, `HOTA` and what belongs to them are counted as TrackEval counts a sequence of
    MOTChallenge, also where a side is empty (0; `LocA` 1).

    Args:
        truth: its rows with `counted` False are don't-cares: a result row that matches one is
            dropped, and they are no misses. (As py-motmetrics has it they only are no misses.)
        result: all rows count.
        match: boxes at an overlap of one half when left out.
        frames: length of the recording, if it is known to be longer than the tracks.
        conventions: whose definitions of CLEAR.

    Raises:
        FormatError: a side has nothing to be matched by.
    """
    return score_of(examine(truth, result, match, frames, conventions))


def score_of(examination: Examination) -> Score:
    """The measures of what was compared."""
    comparison, matched = examination.comparison, examination.matched
    return Score(
        frames=examination.frames,
        truth_people=comparison.people,
        result_tracks=comparison.identities,
        clear=replace(
            clear(comparison, matched, examination.frames, examination.conventions),
            unit=examination.unit,
        ),
        identity=identity(comparison, examination.admitted),
        hota=hota(comparison),
        people=people(comparison, matched),
        position_error=PositionError.of(examination.distances_m),
        track_map=track_map(examination),
    )


_WHICH = {"mean": msg("mean"), "std": msg("std"), "median": msg("median"), "p95": "p95"}


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
