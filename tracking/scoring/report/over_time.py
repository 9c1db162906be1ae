"""Errors over time: how many in each moment, and whom they concern."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from tracking.pages import Axis, Element, drawing, element, group
from tracking.scoring.errors import ErrorKind, ErrorTable
from tracking.scoring.report.findings import Finding
from tracking.scoring.report.marks import LOOK, TITLES, mark
from tracking.scoring.report.stretches import Stretches, joined
from tracking.scoring.table import Integers

MOST_PEOPLE = 40
"""Of more, those with the most errors are drawn."""

_WIDTH, _LEFT, _RIGHT = 860.0, 112.0, 18.0
_LANE, _ROW, _BINS, _MOST_MARKS = 34.0, 14.0, 215, 250
_SINGLE = (ErrorKind.SWITCH, ErrorKind.FRAGMENTATION)
"""Errors of one instant."""


@dataclass(frozen=True, slots=True)
class Clock:
    """Frames along the drawing, and their times."""

    axis: Axis
    fps: float | None

    def says(self, start: int, stop: int | None = None) -> str:
        """Frames in words, with the seconds where they are known."""
        last = start if stop is None else stop - 1
        frames = f"frame {start}" if last == start else f"frames {start} to {last}"
        return f"{frames} ({start / self.fps:.2f} s)" if self.fps else frames

    @property
    def frames_a_dot(self) -> float:
        """How many frames are no wider than a dot."""
        return (self.axis.span[1] - self.axis.span[0]) / self.axis.length


def errors_over_time(finding: Finding) -> Element:
    """Lanes of each kind of error over rows of people, on one axis of frames."""
    subject = finding.subject
    span = (float(subject.start), float(max(subject.stop, subject.start + 1)))
    clock = Clock(Axis(span, _WIDTH), subject.footage.fps)
    parts, y = [], 8.0
    for kind in TITLES:
        parts.append(group(_LEFT, y, *_lane(kind, finding.errors.of_kind(kind), clock)))
        y += _LANE
    shown = shown_people(finding)
    if shown:
        parts.append(group(_LEFT, y + 10, *_people(finding, shown, clock)))
        y += 10 + _ROW * len(shown)
    parts.append(group(_LEFT, y + 6, *_time_axis(clock)))
    height = y + (66 if clock.fps else 48)
    says = f"errors of {finding.result} over time on {subject.name}"
    return drawing(_LEFT + _WIDTH + _RIGHT, height, *parts, says=says)


def shown_people(finding: Finding) -> list[int]:
    """The people with rows of their own, as they come: of many, those with most errors."""
    concerned = finding.errors.truth
    ids, counts = np.unique(concerned[concerned > 0], return_counts=True)
    wrong = dict(zip(ids.tolist(), counts.tolist(), strict=True))
    worst = sorted(finding.people, key=lambda one: (-wrong.get(one.person, 0), one.person))
    kept = sorted(worst[:MOST_PEOPLE], key=lambda one: (one.start, one.person))
    return [one.person for one in kept]


def _lane(kind: ErrorKind, found: ErrorTable, clock: Clock) -> Iterator[Element]:
    """One kind: marks where they are few and of an instant, else how many in each moment."""
    yield element("line", x1=0, x2=_WIDTH, y1=_LANE - 6, y2=_LANE - 6, class_="lane")
    yield element("text", TITLES[kind], x=-10, y=_LANE - 14, text_anchor="end")
    count = element("text", f"{len(found):,}", x=-10, y=_LANE - 2, text_anchor="end")
    count.set("class", "small faint")
    yield count
    if kind in _SINGLE and len(found) <= _MOST_MARKS:
        yield from _instants(kind, found, clock, _LANE / 2 - 2)
    else:
        yield from _bars(kind, found.frame, clock)


def _instants(kind: ErrorKind, found: ErrorTable, clock: Clock, y: float) -> Iterator[Element]:
    for row in range(len(found)):
        x = clock.axis.place(float(found.frame[row]))
        yield mark(kind, x, y, said(found, row, clock))


def said(found: ErrorTable, row: int, clock: Clock) -> str:
    """One switch or fragmentation in words."""
    when, person = clock.says(int(found.frame[row])), int(found.truth[row])
    earlier, track = int(found.earlier[row]), int(found.result[row])
    if earlier != track:
        return f"{when}: person {person} changes from track {earlier} to {track}"
    gap = int(found.frame[row] - found.earlier_frame[row]) - 1
    return f"{when}: person {person} is found again after {gap} frames, by track {track}"


def _bars(kind: ErrorKind, frame: Integers, clock: Clock) -> Iterator[Element]:
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
        bar = element(
            "rect", x=x, y=_LANE - 6 - height, width=width, height=height, class_=LOOK[kind]
        )
        bar.append(element("title", f"{clock.says(begin, end)}: {counts[part]} {TITLES[kind]}"))
        yield bar


def _people(finding: Finding, shown: list[int], clock: Clock) -> Iterator[Element]:
    subject, found = finding.subject, finding.errors
    truth = subject.truth.rows(subject.truth.counted)
    there = Stretches.of(truth.frame + subject.start, truth.track, truth.box[:, :2])
    missed = found.of_kind(ErrorKind.MISS)
    lost = Stretches.of(missed.frame, missed.truth, missed.box[:, :2])
    few = [kind for kind in reversed(_SINGLE) if found.count(kind) <= _MOST_MARKS]
    single = found.rows(np.isin(found.kind, few))
    for number, person in enumerate(shown):
        row = [*_presence(person, there, lost, clock)]
        own = single.rows(single.truth == person)
        for kind in few:
            row += _instants(kind, own.of_kind(kind), clock, _ROW / 2)
        label = element("text", f"person {person}", x=-10, y=_ROW - 3, text_anchor="end")
        label.set("class", "small")
        yield group(0, number * _ROW, label, *row)


def _presence(person: int, there: Stretches, lost: Stretches, clock: Clock) -> Iterator[Element]:
    """When somebody is there, and when nobody noticed."""
    bars = (("kept", there, "is there"), ("miss", lost, "is missed"))
    for look, stretches, what in bars:
        for start, stop, frames in joined(stretches.ranges_of(person), clock.frames_a_dot):
            x = clock.axis.place(start)
            width = max(clock.axis.place(stop) - x, 0.8)
            bar = element("rect", x=x, y=2, width=width, height=_ROW - 4, class_=look)
            if frames < stop - start:  # the fewer of them, the fainter
                bar.set("fill-opacity", f"{max(frames / (stop - start), 0.15):.2f}")
            often = "" if frames == stop - start else f" in {frames} of these"
            bar.append(
                element("title", f"person {person} {what}, {clock.says(start, stop)}{often}")
            )
            yield bar


def _time_axis(clock: Clock) -> Iterator[Element]:
    yield element("line", x1=0, x2=_WIDTH, y1=0, y2=0, class_="tick")
    yield from _ticks(clock.axis, 0, "frame")
    if clock.fps:
        low, high = clock.axis.span
        seconds = Axis((low / clock.fps, high / clock.fps), _WIDTH)
        yield from _ticks(seconds, 20, "seconds")


def _ticks(axis: Axis, y: float, title: str) -> Iterator[Element]:
    yield element("text", title, x=-26, y=y + 17, text_anchor="end", class_="small faint")
    for value in axis.ticks(8):
        x = axis.place(value)
        if not y:
            yield element("line", x1=x, x2=x, y1=0, y2=5, class_="tick")
        yield element("text", f"{value:g}", x=x, y=y + 17, text_anchor="middle", class_="small")
