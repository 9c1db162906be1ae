"""Tables of a score report."""

from __future__ import annotations

from tracking.scoring.per_person import PersonScore
from tracking.scoring.report.findings import Finding, ScoreReport
from tracking.scoring.report.measures import Measure, measures_by, written
from tracking.translation import msg, some_of

COMBINED = "COMBINED"
"""The row over all sequences, as TrackEval calls it."""


def measures_of(report: ScoreReport) -> tuple[Measure, ...]:
    """The measures that some result has a value of."""
    scores = [*report.overall.values(), *(one.score for one in report.findings)]
    return measures_by(report.yardstick.conventions, scores)


def main_measures(report: ScoreReport) -> list[Measure]:
    """Those for tables that show a few only."""
    return [measure for measure in measures_of(report) if measure.main]


def sequence_rows(report: ScoreReport, result: str) -> list[tuple[str, ...]]:
    """The main measures by sequence, and last combined."""
    scores = [(one.subject.name, one.score) for one in report.of(result)]
    return [
        (title, *(each.shown(score) for each in main_measures(report)))
        for title, score in (*scores, (COMBINED, report.overall[result]))
    ]


def range_rows(finding: Finding, report: ScoreReport) -> list[tuple[str, ...]]:
    """The main measures by ranges of frames, each measured as if there were no others."""
    return [
        (_span(start, stop - 1), *(each.shown(score) for each in main_measures(report)))
        for (start, stop), score in finding.ranges.items()
    ]


_PERSON = (
    msg("person"), msg("frames"), msg("there in"), msg("matched"), msg("switches"),
    msg("fragmentations"), msg("kept"),
)  # fmt: skip
_TRACKS = 8


def people_rows(finding: Finding) -> tuple[tuple[str, ...], list[tuple[str, ...]]]:
    """How each person was followed: head and rows; no position error where no places are known."""
    on_floor = bool(len(finding.score.position_error.distances_m))
    head = (*_PERSON, *([msg("position error (m)")] if on_floor else []), msg("tracks"))
    return head, [_person(one, on_floor=on_floor) for one in finding.people]


def _person(one: PersonScore, *, on_floor: bool) -> tuple[str, ...]:
    followed = one.followed
    kept = msg("yes") if followed.kept else msg("no")
    if not followed.detected:
        kept = msg("not detected")
    return (
        str(one.person),
        _span(one.start, one.end - 1),
        f"{one.frames:,}",
        f"{one.share_matched:.1%}",
        str(followed.id_switches),
        str(followed.fragmentations),
        kept,
        *([written(one.position_error.mean, "metres")] if on_floor else []),
        _tracks(one.tracks),
    )


def _tracks(ids: tuple[int, ...]) -> str:
    return some_of(ids, _TRACKS) or "–"


def _span(first: int, last: int) -> str:
    return msg("{first} to {last}", first=first, last=last)


PASSAGE_HEAD = (
    msg("line"), msg("happened"), msg("counted"), msg("hit"), msg("of those that happened"),
    msg("of those counted"),
)  # fmt: skip


def passage_rows(finding: Finding) -> list[tuple[str | int, ...]]:
    """Counted passages, where there are lines."""
    return [
        (one.line, one.happened, one.found, one.hit,
         written(one.recall, "share"), written(one.precision, "share"))
        for one in finding.score.passages or ()
    ]  # fmt: skip
