"""Figures by distance from the camera: which ranges, and how they read."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from tracking.scoring.examination import Examination
from tracking.scoring.per_distance import DistanceScore, per_distance_of
from tracking.scoring.report.measures import finite, written
from tracking.translation import msg

NO_PLACES = msg("By distance: the ground truth has no positions on the floor.")

_CAMERA_M = (0.0, 0.0)
"""The world's axes start on the floor below the camera."""
_MOST_RANGES = 6
_STEPS_M = (1.0, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0, 100.0)
_NEARLY_ALL = 95
"""Per cent of the people's rows, from the nearest on, that the ranges are made for."""
_HEAD = (
    msg("distance (m)"), msg("rows"), "MOTA", "IDF1", msg("recall"), msg("precision"),
    msg("misses"), msg("false alarms"), msg("switches"), msg("fragmentations"),
    msg("position error (m)"),
)  # fmt: skip


def distances_of(examined: Examination, edges_m: Sequence[float]) -> tuple[DistanceScore, ...]:
    """The score of each range of distances; none where the truth has no places.

    Args:
        edges_m: growing from 0; none: even ranges by where people are.

    Raises:
        SettingsError: the edges do not grow from 0 on.
    """
    away_m = np.hypot(*(examined.comparison.truth.position - _CAMERA_M).T)
    away_m = away_m[np.isfinite(away_m)]
    if not len(away_m):
        return ()
    reach_m = float(np.percentile(away_m, _NEARLY_ALL))
    return per_distance_of(examined, _CAMERA_M, edges_m or even_edges(reach_m))


def even_edges(reach_m: float) -> tuple[float, ...]:
    """From 0 on, by a round step, up to where most people are."""
    step_m = next((step for step in _STEPS_M if step * _MOST_RANGES >= reach_m), _STEPS_M[-1])
    count = min(_MOST_RANGES, max(1, math.ceil(reach_m / step_m)))
    return tuple(step_m * number for number in range(count))


def distance_rows(
    distances: Sequence[DistanceScore],
) -> tuple[tuple[str, ...], list[tuple[str, ...]]]:
    """The head and the rows of a table."""
    return _HEAD, [_row(one) for one in distances]


def _row(one: DistanceScore) -> tuple[str, ...]:
    shares = (one.mota, one.idf1, one.recall, one.precision)
    counts = (one.misses, one.false_positives, one.id_switches, one.fragmentations)
    return (
        _span(one),
        f"{one.truth_rows:,}",
        *(written(share, "share") for share in shares),
        *(f"{count:,}" for count in counts),
        written(one.position_error.mean, "metres"),
    )


def _span(one: DistanceScore) -> str:
    if math.isnan(one.from_m):
        return msg("place unknown")
    if math.isinf(one.to_m):
        return msg("{metres:g} and more", metres=one.from_m)
    return msg("{low:g} to {high:g}", low=one.from_m, high=one.to_m)


def distances_data(distances: Sequence[DistanceScore]) -> list[dict[str, Any]]:
    """The same for JSON; `to_m` is None for "and more", both are where places are unknown."""
    return [_data(one) for one in distances]


def _data(one: DistanceScore) -> dict[str, Any]:
    error = one.position_error
    return {
        "from_m": finite(one.from_m),
        "to_m": finite(one.to_m),
        "truth_rows": one.truth_rows,
        "result_rows": one.result_rows,
        "matches": one.reported_matches,
        "misses": one.misses,
        "false_positives": one.false_positives,
        "id_switches": one.id_switches,
        "fragmentations": one.fragmentations,
        "identity_matches": one.identity_matches,
        "MOTA": finite(one.mota),
        "IDF1": finite(one.idf1),
        "recall": finite(one.recall),
        "precision": finite(one.precision),
        "position_error_m": {"mean": finite(error.mean), "p95": finite(error.p95)},
    }
