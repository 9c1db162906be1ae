"""Errors over time: how many in each moment, and whom they concern."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from tracking.arrays import Integers
from tracking.pages import Axis, Bar, Shape
from tracking.scoring.errors import ErrorKind, ErrorTable
from tracking.scoring.report.findings import Finding
from tracking.scoring.report.marks import LOOK, TITLES, mark
from tracking.scoring.report.stretches import Stretches, joined
from tracking.translation import N_, Message, msg

MOST_PEOPLE = 40
"""Of more, those with the most errors are drawn."""

_WIDTH, _LEFT, _RIGHT = 860.0, 112.0, 18.0
_TOP, _PEOPLE_GAP = 8.0, 10.0
_LANE, _ROW, _BINS, _MOST_MARKS = 34.0, 14.0, 215, 250
_THERE = (
    N_("person {person} is there, {when}"),
    N_("person {person} is there, {when} in {frames} of these"),
)
_MISSED = (
    N_("person {person} is missed, {when}"),
    N_("person {person} is missed, {when} in {frames} of these"),
)
"""In all frames of a range, and in some."""
_SINGLE = (ErrorKind.SWITCH, ErrorKind.FRAGMENTATION)
"""Errors of one instant."""


@dataclass(frozen=True, slots=True)
class Clock:
    """Frames along the drawing, and their times."""

    axis: Axis
    fps: float | None

    def says(self, start: int, stop: int | None = None) -> Message:
        """Frames in words, with the seconds where they are known."""
        last = start if stop is None else stop - 1
        frames = (
            msg("frame {frame}", frame=start)
            if last == start
            else msg("frames {first} to {last}", first=start, last=last)
        )
        if not self.fps:
            return frames
        return msg("{frames} ({seconds:.2f} s)", frames=frames, seconds=start / self.fps)

    @property
    def frames_a_dot(self) -> float:
        """How many frames are no wider than a dot."""
        return (self.axis.span[1] - self.axis.span[0]) / self.axis.length


@dataclass(frozen=True, slots=True)
class Lane:
    """One kind of error, or one person: marks where they are few and of an instant, and bars.

    Attributes:
        title: before it. count: of errors.
    """

    title: str
    count: int
    marks: Sequence[Shape]
    bars: Sequence[Bar]


@dataclass(frozen=True, slots=True)
class OverTime:
    """Lanes of each kind of error over rows of people, on one axis of frames.

    Attributes:
        says: what it shows, for those who hear the page.
        clock: the axis. lanes: of kinds. people: of people.
        seconds: the same axis in seconds; None where they are unknown.
    """

    says: str
    clock: Clock
    lanes: Sequence[Lane]
    people: Sequence[Lane]
    seconds: Axis | None

    left, top, width, right = _LEFT, _TOP, _WIDTH, _RIGHT
    lane_height, row_height = _LANE, _ROW

    @property
    def rows_top(self) -> float:
        """Where the rows of people begin."""
        return _TOP + _LANE * len(self.lanes) + (_PEOPLE_GAP if self.people else 0.0)

    @property
    def bottom(self) -> float:
        """Where they end."""
        return self.rows_top + _ROW * len(self.people)


def errors_over_time(finding: Finding) -> OverTime:
    """When errors of a finding happen."""
    subject = finding.subject
    span = (float(subject.start), float(max(subject.stop, subject.start + 1)))
    clock, fps = Clock(Axis(span, _WIDTH), subject.footage.fps), subject.footage.fps
    return OverTime(
        says=msg(
            "errors of {result} over time on {sequence}",
            result=finding.result,
            sequence=subject.name,
        ),
        clock=clock,
        lanes=[_lane(kind, finding.errors.of_kind(kind), clock) for kind in TITLES],
        people=list(_people(finding, shown_people(finding), clock)),
        seconds=Axis((span[0] / fps, span[1] / fps), _WIDTH) if fps else None,
    )


def shown_people(finding: Finding) -> list[int]:
    """The people with rows of their own, as they come: of many, those with most errors."""
    concerned = finding.errors.truth
    ids, counts = np.unique(concerned[concerned > 0], return_counts=True)
    wrong = dict(zip(ids.tolist(), counts.tolist(), strict=True))
    worst = sorted(finding.people, key=lambda one: (-wrong.get(one.person, 0), one.person))
    kept = sorted(worst[:MOST_PEOPLE], key=lambda one: (one.start, one.person))
    return [one.person for one in kept]


def _lane(kind: ErrorKind, found: ErrorTable, clock: Clock) -> Lane:
    """One kind: marks where they are few and of an instant, else how many in each moment."""
    if kind in _SINGLE and len(found) <= _MOST_MARKS:
        marks = _instants(kind, found, clock, _LANE / 2 - 2)
        return Lane(TITLES[kind], len(found), marks, ())
    return Lane(TITLES[kind], len(found), (), list(_bars(kind, found.frame, clock)))


def _instants(kind: ErrorKind, found: ErrorTable, clock: Clock, y: float) -> list[Shape]:
    return [
        mark(kind, clock.axis.place(float(found.frame[row])), y, said(found, row, clock))
        for row in range(len(found))
    ]


def said(found: ErrorTable, row: int, clock: Clock) -> Message:
    """One switch or fragmentation in words."""
    when, person = clock.says(int(found.frame[row])), int(found.truth[row])
    earlier, track = int(found.earlier[row]), int(found.result[row])
    if earlier != track:
        return msg(
            "{when}: person {person} changes from track {earlier} to {track}",
            when=when,
            person=person,
            earlier=earlier,
            track=track,
        )
    gap = int(found.frame[row] - found.earlier_frame[row]) - 1
    return msg(
        "{when}: person {person} is found again after {gap} frames, by track {track}",
        when=when,
        person=person,
        gap=gap,
        track=track,
    )


def _bars(kind: ErrorKind, frame: Integers, clock: Clock) -> Iterator[Bar]:
    """How many errors there are in each of equal parts of the time."""
    start, stop = (int(value) for value in clock.axis.span)
    size = max(1, -(-(stop - start) // _BINS))
    counts = np.bincount((frame - start) // size) if len(frame) else np.zeros(0, int)
    top = int(counts.max(initial=1))
    room = _LANE - 10
    for part in np.flatnonzero(counts).tolist():
        begin = start + part * size
        end = min(begin + size, stop)
        x, height = clock.axis.place(begin), max(1.5, room * int(counts[part]) / top)
        width = max(clock.axis.place(end) - x, 1.0)
        says = msg(
            "{when}: {n} {errors}",
            when=clock.says(begin, end),
            n=int(counts[part]),
            errors=TITLES[kind],
        )
        yield Bar(x, _LANE - 6 - height, width, height, LOOK[kind], says)


def _people(finding: Finding, shown: list[int], clock: Clock) -> Iterator[Lane]:
    subject, found = finding.subject, finding.errors
    truth = subject.truth.rows(subject.truth.counted)
    there = Stretches.of(truth.frame + subject.start, truth.track, truth.box[:, :2])
    missed = found.of_kind(ErrorKind.MISS)
    lost = Stretches.of(missed.frame, missed.truth, missed.box[:, :2])
    few = [kind for kind in reversed(_SINGLE) if found.count(kind) <= _MOST_MARKS]
    single = found.rows(np.isin(found.kind, few))
    for person in shown:
        own = single.rows(single.truth == person)
        marks = [one for kind in few for one in _instants(kind, own.of_kind(kind), clock, _ROW / 2)]
        bars = list(_presence(person, there, lost, clock))
        yield Lane(msg("person {person}", person=person), len(own), marks, bars)


def _presence(person: int, there: Stretches, lost: Stretches, clock: Clock) -> Iterator[Bar]:
    """When somebody is there, and when nobody noticed."""
    for look, stretches, (what, often) in (("kept", there, _THERE), ("miss", lost, _MISSED)):
        for start, stop, frames in joined(stretches.ranges_of(person), clock.frames_a_dot):
            x = clock.axis.place(start)
            width = max(clock.axis.place(stop) - x, 0.8)
            all_of_them = frames == stop - start
            says = msg(
                what if all_of_them else often,
                person=person,
                when=clock.says(start, stop),
                frames=frames,
            )
            # The fewer of them, the fainter.
            faint = "" if all_of_them else f"{max(frames / (stop - start), 0.15):.2f}"
            yield Bar(x, 2, width, _ROW - 4, look, says, faint)
