"""Truth and results read and made ready to be measured."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from app.cli.output import say
from app.cli.ranges import parse_range
from app.cli.score_sources import disagreement, size_of_recording_at, source_of
from app.cli.tracks import Tracks, is_in_percent, part_truth_beside, tracks_at, truth_at
from tracking.errors import SettingsError
from tracking.formats import Filmed, Stated
from tracking.scoring import Match, Score, ScoringTable, score
from tracking.scoring.parts import Rates, judge, rates_of, read_part_truth, tracked_parts
from tracking.scoring.report import Footage, Subject
from tracking.translation import msg

_HARDLY_ANY = 0.02
"""Of rows that could match, less than this share is what happens to match another recording's."""


@dataclass(frozen=True, slots=True, eq=False)
class LoadedSequence:
    """A sequence in memory.

    Attributes:
        subject: what is measured. truth, results: the same as read.
        frames: the range that was typed; None: all.
    """

    subject: Subject
    truth: Tracks
    results: Mapping[str, Tracks]
    frames: tuple[int, int] | None


def load_sequence(
    name: str,
    truth: Path,
    results: Mapping[str, Path],
    frames: str | None,
    stated: Stated | None = None,
) -> LoadedSequence:
    """Read one sequence.

    Args:
        frames: A:B as typed; None: all.
        stated: what the user says of texts of places that do not say it.

    Raises:
        FormatError, SessionError: a file cannot be read.
        SettingsError: there are no such frames.
    """
    true, found = _read(truth, results, Filmed(stated=stated or Stated()))
    everything = (true, *found.values())
    chosen = parse_scored_range(frames, *everything)
    start, stop = chosen or (0, frame_count(*everything))
    fps = next((each.fps for each in everything if each.fps is not None), None)
    size_px = next((each.size_px for each in everything if each.size_px is not None), None)
    subject = Subject(
        name,
        _cut(true_table(true), start, stop),
        {result: _cut(table_of(tracks), start, stop) for result, tracks in found.items()},
        start,
        stop,
        Footage(fps, size_px),
        source_of(true),
        {result: source_of(tracks) for result, tracks in found.items()},
    )
    return LoadedSequence(subject, true, found, chosen)


def _read(
    truth: Path, results: Mapping[str, Path], filmed: Filmed
) -> tuple[Tracks, dict[str, Tracks]]:
    """Truth and results; boxes in percent last, as the others tell how large pictures are."""
    sides = (None, *results)  # the truth first
    paths = {side: truth if side is None else results[side] for side in sides}
    in_percent = {side for side, path in paths.items() if is_in_percent(path)}
    read: dict[str | None, Tracks] = {}
    for side in sorted(sides, key=in_percent.__contains__):
        if side in in_percent and filmed.size_px is None:
            known = (each.size_px for each in read.values() if each.size_px is not None)
            size_px = next(known, None) or size_of_recording_at(paths.values())
            filmed = replace(filmed, size_px=size_px)
        read[side] = (truth_at if side is None else tracks_at)(paths[side], filmed)
    return read[None], {result: read[result] for result in results}


def score_of(result: Tracks, truth: Tracks, match: Match | None = None) -> Score:
    """The measures of one against the other."""
    return score(true_table(truth), table_of(result), match, frame_count(result, truth))


def true_table(truth: Tracks) -> ScoringTable:
    """The rows of a truth; confidence 0 marks don't-cares where the format says so."""
    return ScoringTable.from_columns(truth.columns, dont_cares=truth.dont_cares)


def table_of(result: Tracks) -> ScoringTable:
    """The rows of a result."""
    return ScoringTable.from_columns(result.columns)


def parse_scored_range(text: str | None, *tracks: Tracks) -> tuple[int, int] | None:
    """The range of frames that was typed; None: all.

    Raises:
        SettingsError: it is none, or there are no such frames.
    """
    count = frame_count(*tracks)
    frames = parse_range(text, count)
    if text is not None and frames is not None and not 0 <= frames[0] < frames[1] <= count:
        raise SettingsError(
            "--frames {text}: from frame {frame} on there is nothing in result or ground "
            "truth; choose a range within 0:{count}",
            text=text.strip(),
            frame=max(frames[0], count),
            count=count,
        )
    return frames


def frame_count(*tracks: Tracks) -> int:
    """How many frames there are: of the recording, or as far as rows go."""
    rows = [int(each.columns["frame"].max(initial=-1)) + 1 for each in tracks]
    return max(*rows, *(each.frames for each in tracks))


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


def tell_oddities(one: LoadedSequence) -> None:
    """Note what may make the numbers other than expected, a line each."""
    for tracks in (one.truth, *one.results.values()):
        for note in tracks.notes:
            say(msg("note: {path}: {note}", path=tracks.path, note=note))
    if not one.subject.truth.counted.any():
        say(
            msg(
                "note: {path} has nobody in these frames: everybody tracked counts as a "
                "false alarm, and shares of the ground truth are 0",
                path=one.truth.path,
            )
        )
    for name, tracks in one.results.items():
        if not len(one.subject.results[name]):
            say(
                msg(
                    "note: {path} has nobody in these frames; everybody counts as missed",
                    path=tracks.path,
                )
            )
        if one.subject.true_source is not None:
            why = disagreement(one.subject.true_source, one.subject.result_sources[name])
            if why is not None:
                say(msg("note: {why}", why=why))
        if one.frames is None:
            _tell_untracked(tracks, one.truth)


def tell_unlike(one: LoadedSequence, result: str, score: Score) -> None:
    """Note that hardly anything matches, as where a truth is of another recording.

    What both say of themselves is told by `tell_oddities`, and then not again.
    """
    clear = score.clear
    rows = min(clear.matches + clear.misses, clear.matches + clear.false_positives)
    if not rows or clear.matches >= _HARDLY_ANY * rows:
        return
    ours, true = one.subject.result_sources[result], one.subject.true_source
    if true is None or disagreement(true, ours) is None:
        say(
            msg(
                "note: {path}: {matches} of {rows} rows match the ground truth: is it of "
                "the same recording, and are its frames counted from the same one?",
                path=one.results[result].path,
                matches=clear.matches,
                rows=rows,
            )
        )


def _tell_untracked(result: Tracks, truth: Tracks) -> None:
    """Note that frames count which the tracker never went over, or the recording has not."""
    if result.tracked is None or result.tracked == (0, result.frames):
        _tell_outlasting(result, truth)
        return
    start, stop = result.tracked
    say(
        msg(
            "note: frames {start}:{stop} of {frames} were tracked and all are scored; to "
            "score what was tracked add --frames {start}:{stop}",
            start=start,
            stop=stop,
            frames=result.frames,
        )
    )


def _tell_outlasting(result: Tracks, truth: Tracks) -> None:
    """Note that people count as missed in frames that the result's recording does not have."""
    end = frame_count(truth)
    if not 0 < result.frames < end:
        return
    say(
        msg(
            "note: {path} goes on to frame {end}, the recording of {result_path} has "
            "{frames}, and all are scored; to score the recording's add --frames 0:{frames}",
            path=truth.path,
            end=end,
            result_path=result.path,
            frames=result.frames,
        )
    )


def _cut(table: ScoringTable, start: int, stop: int) -> ScoringTable:
    """The rows of a range, their frames counted from its start."""
    whole = start == 0 and (not len(table) or int(table.frame[-1]) < stop)
    return table if whole else table.within(start, stop)
