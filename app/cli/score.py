"""`score`: a result against truth."""

from __future__ import annotations

from pathlib import Path

import typer

from app.cli.output import print_json
from app.cli.tracks import Tracks, tracks_at, truth_at
from tracking.scoring import BoxMatch, FloorMatch, Match, Score, ScoringTable, score


def run_score(
    result: Path, truth: Path, match: str, radius_m: float, report: Path | None, *, as_json: bool
) -> None:
    """Print the measures."""
    if report is not None:
        raise typer.BadParameter("reports are not built yet; leave it out", param_hint="--report")
    how = FloorMatch(radius_m) if match == "floor" else BoxMatch()
    found = score_of(tracks_at(result), truth_at(truth), how)
    if as_json:
        print_json(found.as_json())
    else:
        print(found.as_text())


def score_of(result: Tracks, truth: Tracks, match: Match | None = None) -> Score:
    """The measures of one against the other.

    `conf` 0 in MOT text marks a don't-care; in a session nothing does.
    """
    return score(
        ScoringTable.from_columns(truth.columns, dont_cares=truth.is_text),
        ScoringTable.from_columns(result.columns),
        match,
        max(result.frames, truth.frames),
    )
