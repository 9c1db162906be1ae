"""`score`: a result against truth."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import typer

from app.cli.output import print_json, say
from app.cli.ranges import typed_range
from app.cli.tracks import Tracks, part_truth_beside, tracks_at, truth_at
from tracking.errors import SettingsError
from tracking.scoring import BoxMatch, FloorMatch, Match, Score, ScoringTable, score
from tracking.scoring.parts import Rates, judge, rates_of, read_part_truth, tracked_parts


@dataclass(frozen=True, slots=True)
class How:
    """How a result is measured, as typed.

    Attributes:
        match: "box" or "floor". radius_m: for the floor. frames: A:B; None: all.
    """

    match: str = "box"
    radius_m: float = 0.5
    frames: str | None = None


def run_score(result: Path, truth: Path, how: How, report: Path | None, *, as_json: bool) -> None:
    """Print the measures."""
    if report is not None:
        raise typer.BadParameter("reports are not built yet; leave it out", param_hint="--report")
    match = FloorMatch(how.radius_m) if how.match == "floor" else BoxMatch()
    ours, true = tracks_at(result), truth_at(truth)
    frames = _scored_range(how.frames, ours, true)
    if frames is None:
        _tell_untracked(ours)
    found, parts = score_of(ours, true, match, frames), part_rates(ours, truth, frames)
    if as_json:
        print_json(found.as_json() | ({} if parts is None else {"parts": parts.as_json()}))
    else:
        print(found.as_text() if parts is None else f"{found.as_text()}\n\n{parts.as_text()}")


def part_rates(result: Tracks, truth: Path, frames: tuple[int, int] | None = None) -> Rates | None:
    """How rightly body parts are followed; None where nobody did, or the truth tells of none.

    Args:
        frames: half-open range that is judged; None: all. Who is in view when it begins starts
            there.

    Raises:
        FormatError: the truth of parts cannot be read, or is of other footage.
    """
    folder = part_truth_beside(truth)
    if folder is None or result.parts is None:
        return None
    footage = result.parts
    true = read_part_truth(folder, result.frames, footage.size_px)
    tracked = tracked_parts(footage.columns)
    if frames is not None:
        true, tracked = true.within(*frames), tracked.within(*frames)
    return rates_of(judge(true, tracked, footage.fps))


def score_of(
    result: Tracks,
    truth: Tracks,
    match: Match | None = None,
    frames: tuple[int, int] | None = None,
) -> Score:
    """The measures of one against the other.

    `conf` 0 in MOT text marks a don't-care; in a session nothing does.

    Args:
        frames: half-open range that is measured, as if there were no others; None: all.
    """
    true = ScoringTable.from_columns(truth.columns, dont_cares=truth.is_text)
    ours = ScoringTable.from_columns(result.columns)
    if frames is None:
        return score(true, ours, match, _frame_count(result, truth))
    start, stop = frames
    return score(true.within(start, stop), ours.within(start, stop), match, stop - start)


def _scored_range(text: str | None, result: Tracks, truth: Tracks) -> tuple[int, int] | None:
    """The range of frames that was typed.

    Raises:
        SettingsError: it is none, or there are no such frames.
    """
    count = _frame_count(result, truth)
    frames = typed_range(text, count)
    if frames is not None and not 0 <= frames[0] < frames[1] <= count:
        raise SettingsError(
            f"frames {frames[0]}:{frames[1]} are in neither result nor truth: "
            f"choose a range within 0:{count}"
        )
    return frames


def _frame_count(result: Tracks, truth: Tracks) -> int:
    """How many frames there are: of the recording, or as far as rows go."""
    rows = [int(each.columns["frame"].max(initial=-1)) + 1 for each in (result, truth)]
    return max(result.frames, truth.frames, *rows)


def _tell_untracked(result: Tracks) -> None:
    """Note that frames count which the tracker never went over."""
    if result.tracked is None or result.tracked == (0, result.frames):
        return
    start, stop = result.tracked
    say(
        f"note: frames {start}:{stop} of {result.frames} were tracked and all are scored; "
        f"to score what was tracked add --frames {start}:{stop}"
    )
