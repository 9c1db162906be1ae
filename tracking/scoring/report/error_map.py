"""Where errors happen: ways on the floor, or in the picture, and what went wrong on them."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice

import numpy as np

from tracking.pages import Element, drawing, element, group
from tracking.scoring.errors import ErrorKind, ErrorTable
from tracking.scoring.report.findings import Finding
from tracking.scoring.report.ground_plan import GroundPlan, known
from tracking.scoring.report.marks import LOOK, TITLES, mark
from tracking.scoring.report.over_time import Clock, said
from tracking.scoring.report.stretches import Stretches
from tracking.scoring.table import Floats

MOST_MARKS = 600
"""Of each kind; the longest stretches, and the first switches, are drawn."""

_LEFT, _TOP = 62.0, 14.0
_STEP = 2.5
"""How far apart, drawn, two points of a way are at least."""


def error_map(
    finding: Finding, plan: GroundPlan, clock: Clock, background: Element | None = None
) -> Element:
    """The map.

    Args:
        background: a picture of the place, for a map in pixels.
    """
    width, height = plan.axes.x.length, plan.axes.y.length
    content = [*_ground(plan, background), *_walks(finding, plan)]
    for kind in (ErrorKind.FALSE_ALARM, ErrorKind.MISS):
        content += _ways(finding.errors.of_kind(kind), kind, plan, clock)
    for kind in (ErrorKind.FRAGMENTATION, ErrorKind.SWITCH):
        content += _instants(finding.errors.of_kind(kind), kind, plan, clock)
    inside = element(
        "svg",
        content,
        x=0.0,
        y=0.0,
        width=width,
        height=height,
        viewBox=f"0 0 {width:g} {height:g}",
    )
    about = (max(3, round(width / 90)), max(3, round(height / 90)))
    frame = plan.axes.drawn(grid=False, about=about)
    says = f"where errors of {finding.result} happen on {finding.subject.name}"
    body = group(_LEFT, _TOP, inside, *frame, *_scale(plan))
    return drawing(_LEFT + width + 20, _TOP + height + 50, body, says=says)


def _ground(plan: GroundPlan, background: Element | None) -> Iterator[Element]:
    if len(plan.view):
        yield element("path", d=_path(plan.places(plan.view, beyond=True)) + "z", class_="view")
        x, y = plan.places(np.zeros((1, 2)))[0].tolist()
        camera = element("path", d=f"M{x - 7:.1f} {y:.1f}h14l-4-11h-6z", class_="camera")
        camera.append(element("title", "the camera"))
        yield camera
    if background is not None and not plan.on_floor:
        size = {"width": str(plan.axes.x.length), "height": str(plan.axes.y.length)}
        background.attrib.update(size, opacity="0.45", preserveAspectRatio="none")
        yield background


def _walks(finding: Finding, plan: GroundPlan) -> Iterator[Element]:
    truth = finding.subject.truth.rows(finding.subject.truth.counted)
    stretches = Stretches.of(truth.frame, truth.track, plan.of(truth))
    for who, path in zip(stretches.who.tolist(), stretches.paths(), strict=True):
        if d := _way(path, plan):
            way = element("path", d=d, class_="walk")
            way.append(element("title", f"person {who}"))
            yield way


def _ways(found: ErrorTable, kind: ErrorKind, plan: GroundPlan, clock: Clock) -> Iterator[Element]:
    """Stretches of misses or false alarms, the long ones first."""
    missed = kind is ErrorKind.MISS
    stretches = Stretches.of(found.frame, found.truth if missed else found.result, plan.of(found))
    order = np.argsort(stretches.start - stretches.stop, kind="stable")[:MOST_MARKS]
    paths = stretches.paths()
    for number in order.tolist():
        who = f"{'person' if missed else 'track'} {stretches.who[number]}"
        when = clock.says(int(stretches.start[number]), int(stretches.stop[number]))
        says = f"{who}: {'missed' if missed else 'nobody is there'}, {when}"
        if d := _way(paths[number], plan):
            way = element("path", d=d, class_=f"way {LOOK[kind]}")
            way.append(element("title", says))
            yield way
        elif known(paths[number]).any():
            x, y = plan.places(paths[number][known(paths[number])][:1])[0].tolist()
            yield mark(kind, x, y, says)


def _instants(
    found: ErrorTable, kind: ErrorKind, plan: GroundPlan, clock: Clock
) -> Iterator[Element]:
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
    return _path(places[kept]) if len(kept) > 1 else ""


def _path(places: Floats) -> str:
    return "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in places.tolist())


def _scale(plan: GroundPlan) -> Iterator[Element]:
    """A bar as long as a round number of metres."""
    if not plan.on_floor:
        return
    low, high = plan.axes.x.span
    metres = max(m for m in (0.2, 0.5, 1, 2, 5, 10, 20, 50) if m <= max((high - low) / 4, 0.2))
    length, y = metres * plan.unit_length, plan.axes.y.length - 12
    x = plan.axes.x.length - 12 - length
    yield element("line", x1=x, x2=x + length, y1=y, y2=y, class_="scale")
    yield element("text", f"{metres:g} m", x=x + length / 2, y=y - 5, text_anchor="middle")
