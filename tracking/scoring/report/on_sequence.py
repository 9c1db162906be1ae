"""One result on one sequence: where and when it goes wrong, for whom, and how that looks."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from tracking.pages import Axis, Element, element, jpeg_source, name, picture, table
from tracking.scoring.errors import ErrorKind
from tracking.scoring.report import tables
from tracking.scoring.report.curves import PART_HEAD, part_curves, part_rows
from tracking.scoring.report.error_map import MOST_MARKS, error_map, left_out
from tracking.scoring.report.findings import Finding, ScoreReport
from tracking.scoring.report.ground_plan import ground_plan
from tracking.scoring.report.marks import TITLES, key
from tracking.scoring.report.missing_values import lacking_said
from tracking.scoring.report.over_time import MOST_PEOPLE, Clock, errors_over_time
from tracking.scoring.report.sources import sources_said
from tracking.scoring.report.switch_pictures import SwitchPictures


@dataclass(frozen=True, slots=True)
class Shown:
    """Pictures of a finding.

    Attributes:
        switches: cut out of the recording. place: a frame of it, as JPEG, for a map in pixels.
        why_none: why there are no pictures of switches.
    """

    switches: tuple[SwitchPictures, ...] = ()
    place: bytes | None = None
    why_none: str = "the recording was not found"


def on_sequence(finding: Finding, report: ScoreReport, shown: Shown) -> Iterator[Element]:
    """The sections about it."""
    if len(report.findings) > 1:
        yield from sources_of(finding)
        yield from lacking(finding)
    yield from _over_time(finding)
    yield from _where(finding, shown)
    yield from _switches(finding, shown)
    if finding.ranges:
        yield element("h3", "By ranges of frames")
        says = "Each range is measured as if there were no other frames."
        yield element("p", says, class_="note")
        yield tables.ranges(finding, report)
    yield from tables.distances(finding)
    if finding.people:
        yield from _people(finding)
    yield from tables.passages(finding)
    yield from _parts(finding)


def sources_of(finding: Finding) -> Iterator[Element]:
    """Where result and truth are from, a line each."""
    for title, place, more in sources_said(finding):
        yield element("p", f"{title}: ", name(place), more, class_="note")


def lacking(finding: Finding) -> Iterator[Element]:
    """Why measures have no value, where rows are wanting."""
    for says in lacking_said(finding):
        yield element("p", says)


def _over_time(finding: Finding) -> Iterator[Element]:
    yield element("h3", "Errors over time")
    if not len(finding.errors):
        yield element("p", "There are none.")
    bar = element("rect", x=1, y=3, width=14, height=10, class_="kept")
    yield key((bar, "a person who is found"))
    yield element("div", errors_over_time(finding), class_="drawn")
    left = len(finding.people) - MOST_PEOPLE
    if left > 0:
        says = f"The {MOST_PEOPLE} people with the most errors; {left} more are not drawn."
        yield element("p", says, class_="note")


def _where(finding: Finding, shown: Shown) -> Iterator[Element]:
    subject = finding.subject
    plan = ground_plan(subject)
    if plan is None:
        return
    background = None
    if shown.place is not None:
        background = element("image", href=jpeg_source(shown.place))
    clock = Clock(Axis((0.0, 1.0), 1.0), subject.footage.fps)
    yield element("h3", "Where errors happen")
    walk = element("path", d="M1 11l5-6 4 5 5-6", class_="walk")
    yield key((walk, "ways of people in the truth"))
    drawn = error_map(finding, plan, clock, background)
    yield element("div", drawn, class_="drawn narrow")
    if count := plan.beyond(finding.errors):
        says = f"{count:,} errors lie farther out than the map goes; their marks are on its edge."
        yield element("p", says, class_="note")
    for kind, count in left_out(finding).items():
        what = f"stretches of {TITLES[kind]}" if _lasts(kind) else TITLES[kind]
        says = f"{count:,} {what} beyond {MOST_MARKS} are not drawn."
        yield element("p", says, class_="note")


def _lasts(kind: ErrorKind) -> bool:
    return kind in (ErrorKind.MISS, ErrorKind.FALSE_ALARM)


def _switches(finding: Finding, shown: Shown) -> Iterator[Element]:
    count = finding.errors.count(ErrorKind.SWITCH)
    if not count:
        return
    yield element("h3", "Switches")
    if not shown.switches:
        yield element("p", f"No pictures: {shown.why_none}.", class_="note")
        return
    left = count - len(shown.switches)
    says = (
        "Left the last frame before, right the first after: the white box is the person's in the "
        "truth, the coloured one the track's."
    )
    more = f" {left} more switches have no picture here." if left else ""
    yield element("p", says + more, class_="note")
    fps = finding.subject.footage.fps
    figures = [_figure(one, Clock(Axis((0.0, 1.0), 1.0), fps)) for one in shown.switches]
    yield element("div", figures, class_="pictures")


def _figure(one: SwitchPictures, clock: Clock) -> Element:
    before = picture(one.before, f"frame {one.earlier_frame}: track {one.earlier}")
    after = picture(one.after, f"frame {one.frame}: track {one.track}")
    return element(
        "figure",
        element("div", before, after, class_="pair"),
        element(
            "figcaption",
            f"Person {one.person}: track {one.earlier} until frame {one.earlier_frame}, "
            f"track {one.track} from {clock.says(one.frame)}",
        ),
    )


def _people(finding: Finding) -> Iterator[Element]:
    yield element("h3", "People of the truth")
    yield tables.people(finding)


def _parts(finding: Finding) -> Iterator[Element]:
    if finding.parts is None:
        return
    yield element("h3", "Body parts")
    curves = element("div", part_curves(finding.parts), class_="drawn narrow")
    yield element("div", curves, table(PART_HEAD, part_rows(finding.parts)), class_="row")
