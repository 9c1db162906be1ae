"""What is told of one tracker on one recording."""

from __future__ import annotations

from typing import Any

import numpy as np

from tests.benchmarks.clips import truth_table
from tests.benchmarks.flow.counts import hits_of
from tests.benchmarks.footage.overhead import OVERHEAD, PASSAGES, passages_found
from tests.benchmarks.footage.recordings import BY_EYE, Footage, counting_line
from tests.benchmarks.runner import KeptRun
from tracking.errors import FormatError
from tracking.formats import read_mot
from tracking.scoring import BoxMatch, EitherMatch, FloorMatch, ScoringTable, examine, score_of
from tracking.tracks import Columns

Figures = dict[str, Any]

RADIUS_M = 0.5
"""Rows farther apart on the floor are not one person."""
OVERLAP = 0.5
_BY_EYE_OVERLAP = 0.4
"""Boxes drawn by eye are rough."""
_NEAR_M, _NOBODY_SHARE, _LEAST_S = 1.0, 0.2, 0.5
"""A track of half a second is of nobody if a fifth of it is within a metre of anybody."""
_SCORES = ("MOTA", "IDF1", "HOTA", "id_switches", "people_kept", "people_detected")
_RATES = ("misses", "false_positives")


def figures_of(footage: Footage, kept: KeptRun) -> Figures:
    """All figures of a run; None where the footage or the tracker says nothing of them."""
    tracks, times = kept.tracks, kept.times
    spent_s = float(times["seeing_s"][0] + times["following_s"][0])
    found: Figures = {
        "tracks": len(np.unique(tracks["track"])),
        "ms": 1000.0 * spent_s / float(times["frames"][0]),
    }
    if footage.labelled:
        found |= _against_truth(footage, kept)
    elif footage.name in BY_EYE:
        found["walkers"] = _walkers(footage, tracks)
    elif footage.name == OVERHEAD:
        found["walkers"] = {"of": len(PASSAGES), "found": passages_found(tracks)}
    return found


def box_figures(footage: Footage, tracks: Columns) -> Figures:
    """Those of tracks that are boxes only, over the whole recording."""
    with footage.open() as recording:
        fps = recording.fps
    truth, result = truth_table(footage.folder), ScoringTable.from_columns(tracks)
    return {
        "tracks": len(np.unique(result.track)),
        "people": len(np.unique(truth.track[truth.counted])),
        "boxes": _scored(truth, result, BoxMatch(OVERLAP)),
        "nobody": _of_nobody(truth, result, round(_LEAST_S * fps)),
    }


def _against_truth(footage: Footage, kept: KeptRun) -> Figures:
    frames = int(kept.times["frames"][0])
    truth = truth_table(footage.folder)
    truth = truth.rows(truth.frame < frames)
    result = ScoringTable.from_columns(kept.tracks)
    with footage.open() as recording:
        fps = recording.fps
    boxes = _scored(truth, result, BoxMatch(OVERLAP))
    found: Figures = {
        "people": len(np.unique(truth.track[truth.counted])),
        "boxes": boxes,
        "floor": None,
        "nobody": _of_nobody(truth, result, round(_LEAST_S * fps)),
    }
    if truth.placed and (result.placed or not len(result)):
        found["floor"] = _scored(truth, result, FloorMatch(RADIUS_M))
        columns = read_mot(footage.folder / "truth.txt")
        columns = {name: column[columns["frame"] < frames] for name, column in columns.items()}
        line = counting_line(footage, zip(columns["x"], columns["y"], strict=True))
        hits = hits_of(kept.tracks, columns, fps, [line])
        found["passages"] = {"happened": hits.happened, "found": hits.found, "hit": hits.hit}
    return found


def _scored(truth: ScoringTable, result: ScoringTable, match: BoxMatch | FloorMatch) -> Figures:
    score = score_of(examine(truth, result, match)).as_json()
    rows = max(score["truth_rows"], 1)
    return {
        **{name: score[name] for name in _SCORES},
        **{name: score[name] / rows for name in _RATES},
        "error_m": score["position_error_m"]["mean"],
    }


def _of_nobody(truth: ScoringTable, result: ScoringTable, least: int) -> int:
    """How many tracks are where nobody is."""
    try:
        examined = examine(truth, result, EitherMatch(_NEAR_M))
    except FormatError:  # an empty side has nothing to be matched by
        return 0
    rows = examined.comparison.result.track
    matched = rows[examined.matched.rows.result]
    return sum(
        bool(number >= least and (matched == track).sum() < _NOBODY_SHARE * number)
        for track, number in zip(*np.unique(rows, return_counts=True), strict=True)
    )


def _walkers(footage: Footage, tracks: Columns) -> Figures:
    """How many of the people drawn by eye have a track of their own."""
    drawn = [
        (frame, number, left, top, right - left, bottom - top)
        for frame, boxes in BY_EYE[footage.name].items()
        for number, (left, top, right, bottom) in enumerate(boxes)
    ]
    names = ("frame", "track", "left", "top", "width", "height")
    columns = {n: np.array(c) for n, c in zip(names, zip(*drawn, strict=True), strict=True)}
    known = np.isin(tracks["frame"], columns["frame"])
    result = ScoringTable.from_columns({name: column[known] for name, column in tracks.items()})
    if not len(result):
        return {"of": len(drawn), "found": 0}
    matched = examine(ScoringTable.from_columns(columns), result, BoxMatch(_BY_EYE_OVERLAP)).matched
    return {"of": len(drawn), "found": len(matched)}
