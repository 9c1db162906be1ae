"""Where errors happen: ways on the floor, or in the picture, and what went wrong on them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice

import numpy as np

from tracking.arrays import Floats
from tracking.pages import Shape, path_of
from tracking.scoring.errors import ErrorKind, ErrorTable
from tracking.scoring.report.findings import Finding
from tracking.scoring.report.ground_plan import GroundPlan, known
from tracking.scoring.report.marks import LOOK, TITLES, mark
from tracking.scoring.report.over_time import Clock, said
from tracking.scoring.report.stretches import Stretches
from tracking.translation import msg

MOST_MARKS = 600
"""Of each kind; the longest stretches, and the first switches, are drawn."""

_LEFT, _TOP = 62.0, 14.0
_STEP = 2.5
"""How far apart, drawn, two points of a way are at least."""


@dataclass(frozen=True, slots=True)
class ErrorMap:
    """The map.

    Attributes:
        says: what it shows, for those who hear the page.
        plan: what it is drawn on. ground: the camera and what it sees.
        shapes: ways of people, and errors.
        scale_m, scale: a bar of so many metres, as it is drawn; 0 where metres are unknown.
    """

    says: str
    plan: GroundPlan
    ground: list[Shape]
    shapes: list[Shape]
    scale_m: float
    scale: float

    left, top = _LEFT, _TOP

    @property
    def about(self) -> tuple[int, int]:
        """How many numbers stand at the axes."""
        x, y = (axis.length for axis in (self.plan.axes.x, self.plan.axes.y))
        return max(3, round(x / 90)), max(3, round(y / 90))


def error_map(finding: Finding, plan: GroundPlan, clock: Clock) -> ErrorMap:
    """Where errors of a finding happen."""
    shapes = list(_walks(finding, plan))
    for kind in (ErrorKind.FALSE_ALARM, ErrorKind.MISS):
        shapes += _ways(finding.errors.of_kind(kind), kind, plan, clock)
    for kind in (ErrorKind.FRAGMENTATION, ErrorKind.SWITCH):
        shapes += _instants(finding.errors.of_kind(kind), kind, plan, clock)
    says = msg(
        "where errors of {result} happen on {sequence}",
        result=finding.result,
        sequence=finding.subject.name,
    )
    metres = _scale_m(plan)
    return ErrorMap(says, plan, list(_ground(plan)), shapes, metres, metres * plan.unit_length)


def _ground(plan: GroundPlan) -> Iterator[Shape]:
    if len(plan.view):
        yield Shape(path_of(plan.places(plan.view, beyond=True)) + "z", "view")
        x, y = plan.places(np.zeros((1, 2)))[0].tolist()
        yield Shape(f"M{x - 7:.1f} {y:.1f}h14l-4-11h-6z", "camera", msg("the camera"))


def _walks(finding: Finding, plan: GroundPlan) -> Iterator[Shape]:
    truth = finding.subject.truth.rows(finding.subject.truth.counted)
    stretches = Stretches.of(truth.frame, truth.track, plan.of(truth))
    for who, path in zip(stretches.who.tolist(), stretches.paths(), strict=True):
        if d := _way(path, plan):
            yield Shape(d, "walk", msg("person {person}", person=who))


def _ways(found: ErrorTable, kind: ErrorKind, plan: GroundPlan, clock: Clock) -> Iterator[Shape]:
    """Stretches of misses or false alarms, the long ones first."""
    missed = kind is ErrorKind.MISS
    stretches = Stretches.of(found.frame, found.truth if missed else found.result, plan.of(found))
    order = np.argsort(stretches.start - stretches.stop, kind="stable")[:MOST_MARKS]
    paths = stretches.paths()
    for number in order.tolist():
        who = int(stretches.who[number])
        when = clock.says(int(stretches.start[number]), int(stretches.stop[number]))
        says = msg(
            "person {who}: missed, {when}" if missed else "track {who}: nobody is there, {when}",
            who=who,
            when=when,
        )
        if d := _way(paths[number], plan):
            yield Shape(d, f"way {LOOK[kind]}", says)
        elif known(paths[number]).any():
            x, y = plan.places(paths[number][known(paths[number])][:1])[0].tolist()
            yield mark(kind, x, y, says)


def _instants(
    found: ErrorTable, kind: ErrorKind, plan: GroundPlan, clock: Clock
) -> Iterator[Shape]:
    places = plan.places(plan.of(found))
    drawn = np.flatnonzero(known(places))
    for row in islice(drawn.tolist(), MOST_MARKS):
        x, y = places[row].tolist()
        yield mark(kind, x, y, said(found, row, clock))


def left_out(finding: Finding) -> dict[ErrorKind, int]:
    """How many marks of each kind are not drawn, as there are too many."""
    left = {}
    for kind in TITLES:
        found = finding.errors.of_kind(kind)
        who = found.truth if kind is not ErrorKind.FALSE_ALARM else found.result
        single = kind in (ErrorKind.SWITCH, ErrorKind.FRAGMENTATION)
        count = len(found) if single else len(Stretches.of(found.frame, who, found.position))
        left[kind] = max(0, count - MOST_MARKS)
    return {kind: count for kind, count in left.items() if count}


def _way(path: Floats, plan: GroundPlan) -> str:
    """A line through a way's places; nothing where it is no longer than a dot."""
    places = plan.places(path[known(path)])
    if not len(places):
        return ""
    kept = [0]
    for row in range(1, len(places)):
        if np.abs(places[row] - places[kept[-1]]).max() >= _STEP:
            kept.append(row)
    return path_of(places[kept]) if len(kept) > 1 else ""


def _scale_m(plan: GroundPlan) -> float:
    """A round number of metres."""
    low, high = plan.axes.x.span
    if not plan.on_floor:
        return 0.0
    return max(m for m in (0.2, 0.5, 1, 2, 5, 10, 20, 50) if m <= max((high - low) / 4, 0.2))
