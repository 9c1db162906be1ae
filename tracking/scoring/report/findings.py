"""What was measured: every result on every sequence, and each result over all of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise

from tracking.scoring.combined_scores import combined
from tracking.scoring.conventions import Conventions
from tracking.scoring.errors import ErrorTable, errors_of
from tracking.scoring.examination import examine
from tracking.scoring.parts import Rates
from tracking.scoring.per_distance import DistanceScore
from tracking.scoring.per_person import PersonScore, per_person_of
from tracking.scoring.report.distances import distances_of
from tracking.scoring.report.subject import Subject
from tracking.scoring.score import Score, score, score_of
from tracking.scoring.similarity import BoxMatch, Match

EQUAL_RANGES = 5
"""Into so many a recording is divided where no ranges are asked for."""
_LEAST_FRAMES = 50

Range = tuple[int, int]


@dataclass(frozen=True, slots=True)
class Yardstick:
    """How results are measured.

    Attributes:
        match: how rows are paired. conventions: whose definitions hold.
        ranges: of frames that are also measured each by itself, half-open; empty: equal parts.
        distances_m: from the camera, edges of ranges that are also told; empty: even ones.
    """

    match: Match = field(default_factory=BoxMatch)
    conventions: Conventions = Conventions.TRACKEVAL
    ranges: tuple[Range, ...] = ()
    distances_m: tuple[float, ...] = ()

    def score(self, subject: Subject, result: str, frames: Range | None = None) -> Score:
        """The score of a result; of some frames as if there were no others.

        Raises:
            FormatError: a side has nothing to be matched by.
        """
        start, stop = frames or (subject.start, subject.stop)
        truth, rows = subject.truth, subject.results[result]
        if frames is not None:
            truth, rows = (
                t.within(start - subject.start, stop - subject.start) for t in (truth, rows)
            )
        return score(truth, rows, self.match, stop - start, self.conventions)


@dataclass(frozen=True, slots=True, eq=False)
class Finding:
    """One result on one sequence.

    Attributes:
        subject: the sequence. result: name of the result.
        score: over all frames. errors, people: frames counted as in the recording.
        ranges: scores of ranges of frames, each by itself.
        parts: how rightly body parts are followed; None where nobody did.
        distances: by ranges of distance from the camera; none where places are unknown.
    """

    subject: Subject
    result: str
    score: Score
    errors: ErrorTable
    people: tuple[PersonScore, ...]
    ranges: Mapping[Range, Score]
    parts: Rates | None = None
    distances: tuple[DistanceScore, ...] = ()


@dataclass(frozen=True, slots=True, eq=False)
class ScoreReport:
    """All findings.

    Attributes:
        results: their names. yardstick: how they were measured.
        findings: by sequence, then result.
        overall: each result's score over all sequences.
    """

    results: tuple[str, ...]
    yardstick: Yardstick
    findings: tuple[Finding, ...]
    overall: Mapping[str, Score]

    @property
    def sequences(self) -> tuple[str, ...]:
        """Their names, in order."""
        return tuple(dict.fromkeys(one.subject.name for one in self.findings))

    def of(self, result: str) -> tuple[Finding, ...]:
        """What was found of one result."""
        return tuple(one for one in self.findings if one.result == result)

    def on(self, sequence: str) -> tuple[Finding, ...]:
        """What was found on one sequence."""
        return tuple(one for one in self.findings if one.subject.name == sequence)


def report_of(findings: Sequence[Finding], yardstick: Yardstick) -> ScoreReport:
    """Put findings together; a result's overall score is combined over its sequences."""
    results = tuple(dict.fromkeys(one.result for one in findings))
    overall = {
        name: combined([one.score for one in findings if one.result == name]) for name in results
    }
    return ScoreReport(results, yardstick, tuple(findings), overall)


def finding_of(subject: Subject, name: str, yardstick: Yardstick) -> Finding:
    """Measure one result of a sequence, with all that is told of it.

    Raises:
        FormatError: a side has nothing to be matched by.
        SettingsError: distances that were named do not grow from 0 on.
    """
    length = subject.stop - subject.start
    result = subject.results[name]
    examined = examine(subject.truth, result, yardstick.match, length, yardstick.conventions)
    found = errors_of(examined)
    return Finding(
        subject=subject,
        result=name,
        score=score_of(examined),
        errors=replace(
            found,
            frame=found.frame + subject.start,
            earlier_frame=found.earlier_frame + subject.start,
        ),
        people=tuple(
            replace(one, start=one.start + subject.start, end=one.end + subject.start)
            for one in per_person_of(examined)
        ),
        ranges={each: yardstick.score(subject, name, each) for each in _ranges(subject, yardstick)},
        distances=distances_of(examined, yardstick.distances_m),
    )


def _ranges(subject: Subject, yardstick: Yardstick) -> tuple[Range, ...]:
    """The ranges that were asked for, as far as they lie in the sequence; else equal parts."""
    start, stop = subject.start, subject.stop
    if yardstick.ranges:
        cut = [(max(a, start), min(b, stop)) for a, b in yardstick.ranges]
        return tuple((a, b) for a, b in cut if a < b)
    parts = min(EQUAL_RANGES, (stop - start) // _LEAST_FRAMES)
    if parts < 2:
        return ()
    cuts = [start + (stop - start) * k // parts for k in range(parts + 1)]
    return tuple(pairwise(cuts))
