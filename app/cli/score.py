"""`score`: a result against truth."""

from __future__ import annotations

from pathlib import Path

import typer

from app.cli.output import print_json
from app.cli.tracks import Tracks, part_truth_beside, tracks_at, truth_at
from tracking.scoring import BoxMatch, FloorMatch, Match, Score, ScoringTable, score
from tracking.scoring.parts import Rates, judge, rates_of, read_part_truth, tracked_parts


def run_score(
    result: Path, truth: Path, match: str, radius_m: float, report: Path | None, *, as_json: bool
) -> None:
    """Print the measures."""
    if report is not None:
        raise typer.BadParameter("reports are not built yet; leave it out", param_hint="--report")
    how = FloorMatch(radius_m) if match == "floor" else BoxMatch()
    ours, true = tracks_at(result), truth_at(truth)
    found, parts = score_of(ours, true, how), part_rates(ours, truth)
    if as_json:
        print_json(found.as_json() | ({} if parts is None else {"parts": parts.as_json()}))
    else:
        print(found.as_text() if parts is None else f"{found.as_text()}\n\n{parts.as_text()}")


def part_rates(result: Tracks, truth: Path) -> Rates | None:
    """How rightly body parts are followed; None where nobody did, or the truth tells of none.

    Raises:
        FormatError: the truth of parts cannot be read, or is of other footage.
    """
    folder = part_truth_beside(truth)
    if folder is None or result.parts is None:
        return None
    footage = result.parts
    true = read_part_truth(folder, result.frames, footage.size_px)
    return rates_of(judge(true, tracked_parts(footage.columns), footage.fps))


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
