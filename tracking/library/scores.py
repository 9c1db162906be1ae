"""Measuring tracks against ground truth."""

from __future__ import annotations

from typing import Literal

import tracking.scoring
from tracking.errors import SettingsError
from tracking.library.tables import Table, Tracks, table_of
from tracking.recording import Recording
from tracking.scoring import BoxMatch, FloorMatch, Score, ScoringTable


def score(
    result: Tracks,
    truth: Tracks | Recording,
    *,
    match: Literal["box", "floor"] = "box",
    radius_m: float = 0.5,
) -> Score:
    """Measure tracks against ground truth, as the command `score` does.

    Args:
        result: a session, a run, a table of tracks, or the path of a session or a file of tracks.
        truth: the same; or a recording, or its folder, with truth.txt beside it.
        match: rows match by boxes (intersection over union of 0.5) or by places on the floor.
        radius_m: how far apart places match, m.

    Returns:
        The score: `as_json()` has every figure by its name ("MOTA", "IDF1", "HOTA", ...),
        `as_text()` a line each.

    Raises:
        FormatError, SessionError: a file cannot be read, or has nothing to be matched by.
        SettingsError: there is no such way to match.
    """
    if match not in ("box", "floor"):
        raise SettingsError("match {match!r} is unknown: choose box or floor", match=match)
    found, true = table_of(result), table_of(truth)
    ways = FloorMatch(radius_m) if match == "floor" else BoxMatch()
    frames = max(_frames(found), _frames(true))
    counted = ScoringTable.from_columns(true.columns, dont_cares=true.dont_cares)
    return tracking.scoring.score(counted, ScoringTable.from_columns(found.columns), ways, frames)


def _frames(table: Table) -> int:
    return max(table.frames, int(table.columns["frame"].max(initial=-1)) + 1)
