"""What is scored: whose tracks against which truth, how they are matched, over which frames."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from app.core.document.track_sources import Load, Version
from app.core.scenes.error_events import ErrorEvents, events_of
from app.features.scoring.truths import Truth, TruthSource
from tracking.progress import Progress
from tracking.scoring import (
    BoxMatch,
    ErrorTable,
    FloorMatch,
    Match,
    Score,
    ScoringTable,
    errors_of,
    examine,
    score,
    score_of,
)

Range = tuple[int, int]
ReadTruth = Callable[[], Truth]
_STEPS = 4


@dataclass(frozen=True, slots=True)
class MatchingRule:
    """How rows of truth and result are paired.

    Attributes:
        on_floor: by distance on the floor, else by overlap of boxes.
        overlap: least intersection over union. radius_m: greatest distance.
    """

    on_floor: bool = False
    overlap: float = 0.5
    radius_m: float = 0.5

    @property
    def match(self) -> Match:
        """The same for scoring."""
        return FloorMatch(self.radius_m) if self.on_floor else BoxMatch(self.overlap)

    @property
    def threshold(self) -> float:
        """The overlap, or the distance in metres."""
        return self.radius_m if self.on_floor else self.overlap

    def with_threshold(self, value: float) -> MatchingRule:
        """The same with another one."""
        return replace(self, radius_m=value) if self.on_floor else replace(self, overlap=value)


@dataclass(frozen=True, slots=True)
class ScoreSubject:
    """What is asked for. Two that are equal are scored alike.

    Attributes:
        source: of the truth. track_source: `SHOWN` or a run's number. version: tells these
            tracks from others.
        matching: see `MatchingRule`.
        frames: the half-open range that was tracked. visible: what of it the timeline shows.
    """

    source: TruthSource
    track_source: int
    version: Version
    matching: MatchingRule
    frames: Range
    visible: Range

    @property
    def whole(self) -> ScoreSubject:
        """The same whatever the timeline shows."""
        return replace(self, visible=self.frames)

    @property
    def asked(self) -> ScoreSubject:
        """The same whichever edits were made: scores of equal ones can be set side by side."""
        return replace(self, visible=self.frames, version=())


@dataclass(frozen=True, slots=True, eq=False)
class ScoreResult:
    """What came of a subject.

    Attributes:
        subject: it. truth: what it was compared with.
        whole, visible: the scores of all frames that were tracked, and of those shown.
        errors: of all frames, frames as in the recording. events: the same as stretches.
        edits: those that were in force, oldest first.
    """

    subject: ScoreSubject
    truth: Truth
    whole: Score
    visible: Score
    errors: ErrorTable
    events: ErrorEvents
    edits: tuple[int, ...] = ()


@dataclass(frozen=True, slots=True)
class ScoringInput:
    """What a score is made from, as it is at the moment of asking; readable on any thread.

    Attributes:
        load: gives the result's rows. read: gives the truth. edits: in force, oldest first.
    """

    load: Load
    read: ReadTruth
    edits: tuple[int, ...] = ()


def score_subject(
    subject: ScoreSubject, before: ScoreResult | None, given: ScoringInput, report: Progress
) -> ScoreResult:
    """Score a result; of what was worked out before is kept what stays.

    Args:
        before: of another subject.
        report: told how far it is; may raise CancelledError.

    Raises:
        FormatError, SessionError: the truth cannot be read, or has nothing to be matched by.
    """
    report(0, _STEPS)
    known = before is not None and before.truth.source == subject.source
    truth = before.truth if known and before is not None else given.read()
    report(1, _STEPS)
    result = ScoringTable.from_columns(given.load())
    report(2, _STEPS)
    if before is not None and before.subject.whole == subject.whole:
        whole, errors, events = before.whole, before.errors, before.events
    else:
        whole, errors = _examined(truth.table, result, subject)
        events = events_of(errors)
    report(3, _STEPS)
    visible = whole
    if subject.visible != subject.frames:
        start, stop = subject.visible
        parts = truth.table.within(start, stop), result.within(start, stop)
        visible = score(*parts, subject.matching.match, stop - start)
    return ScoreResult(subject, truth, whole, visible, errors, events, given.edits)


def _examined(
    truth: ScoringTable, result: ScoringTable, subject: ScoreSubject
) -> tuple[Score, ErrorTable]:
    """The score and the errors over all frames that were tracked."""
    start, stop = subject.frames
    parts = truth.within(start, stop), result.within(start, stop)
    examination = examine(*parts, subject.matching.match, stop - start)
    found = errors_of(examination)
    found = replace(found, frame=found.frame + start, earlier_frame=found.earlier_frame + start)
    return score_of(examination), found
