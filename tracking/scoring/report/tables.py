"""Tables of a score report."""

from __future__ import annotations

from collections.abc import Iterator

from tracking.pages import Content, Element, element, name, table
from tracking.scoring.per_person import PersonScore
from tracking.scoring.report.distances import NO_PLACES, distance_rows
from tracking.scoring.report.findings import Finding, ScoreReport
from tracking.scoring.report.measures import Measure, by_group, measures_by, written

COMBINED = "COMBINED"
"""The row over all sequences, as TrackEval calls it."""


def measures_of(report: ScoreReport) -> tuple[Measure, ...]:
    """The measures that some result has a value of."""
    scores = [*report.overall.values(), *(one.score for one in report.findings)]
    return measures_by(report.yardstick.conventions, scores)


def main_measures(report: ScoreReport) -> list[Measure]:
    """Those for tables that show a few only."""
    return [measure for measure in measures_of(report) if measure.main]


def measures(report: ScoreReport) -> Element:
    """Every measure with a column each result, and what it means."""
    head: list[Content] = [
        "",
        *(name(result) for result in report.results),
        element("th", "", class_="word"),
    ]
    body = [
        row
        for group, members in by_group(measures_of(report)).items()
        for row in (_group(group, len(head)), *(_row(one, report) for one in members))
    ]
    made = element("table", element("thead", element("tr", [_head(c) for c in head])))
    made.append(element("tbody", body))
    return element("div", made, class_="scrolled")


def _head(content: Content) -> Element:
    if isinstance(content, Element) and content.tag == "th":
        return content
    return element("th", content)


def _group(title: str, columns: int) -> Element:
    return element("tr", element("th", title, colspan=columns, scope="colgroup"), class_="group")


def _row(measure: Measure, report: ScoreReport) -> Element:
    scores = [report.overall[result] for result in report.results]
    best = measure.best(scores)
    cells = [element("td", measure.name, class_="word")]
    for number, score in enumerate(scores):
        shown: list[Content] = [element("span", measure.shown(score))]
        if number and measure.better is not None:
            apart = measure.difference(score, scores[0])
            shown += [" ", element("small", apart, class_="note")]
        cells.append(element("td", shown, class_="best" if number in best else None))
    cells.append(element("td", measure.says, class_="says"))
    return element("tr", cells)


def sequences(report: ScoreReport, result: str) -> Element:
    """The main measures by sequence, and combined."""
    shown = main_measures(report)
    rows: list[tuple[Content, ...]] = [
        (name(one.subject.name), *(each.shown(one.score) for each in shown))
        for one in report.of(result)
    ]
    made = table(("recording", *(each.name for each in shown)), rows, caption=result)
    last = [element("td", COMBINED, class_="word")]
    last += [element("td", each.shown(report.overall[result])) for each in shown]
    made[0][-1].append(element("tr", last, class_="all"))
    return made


def ranges(finding: Finding, report: ScoreReport) -> Element:
    """The main measures by ranges of frames, each measured as if there were no others."""
    shown = main_measures(report)
    rows = [
        (f"{start} to {stop - 1}", *(each.shown(score) for each in shown))
        for (start, stop), score in finding.ranges.items()
    ]
    return table(("frames", *(each.name for each in shown)), rows)


def distances(finding: Finding) -> Iterator[Element]:
    """Near the camera and far from it."""
    if not finding.distances:
        yield element("p", NO_PLACES, class_="note")
        return
    yield element("h3", "By distance from the camera")
    says = "Along the floor. A person's row counts where the person stands, a false alarm where"
    yield element("p", f"{says} the track is.", class_="note")
    yield table(*distance_rows(finding.distances))


_PERSON = (
    "person", "frames", "there in", "matched", "switches", "fragmentations", "kept",
)  # fmt: skip
_TRACKS = 8


def people(finding: Finding) -> Element:
    """How each person was followed."""
    head, rows = people_rows(finding)
    made = table(head, rows)
    for row in made[0].iter("tr"):
        row[-1].set("class", "word")
    return made


def people_rows(finding: Finding) -> tuple[tuple[str, ...], list[tuple[str, ...]]]:
    """The head and the rows of that table; no floor error where no positions are known."""
    on_floor = bool(len(finding.score.position_error.distances_m))
    head = (*_PERSON, *(["floor error (m)"] if on_floor else []), "tracks")
    return head, [_person(one, on_floor=on_floor) for one in finding.people]


def _person(one: PersonScore, *, on_floor: bool) -> tuple[str, ...]:
    followed = one.followed
    kept = "yes" if followed.kept else "no" if followed.detected else "not detected"
    return (
        str(one.person),
        f"{one.start} to {one.end - 1}",
        f"{one.frames:,}",
        f"{one.share_matched:.1%}",
        str(followed.id_switches),
        str(followed.fragmentations),
        kept,
        *([written(one.position_error.mean, "metres")] if on_floor else []),
        _tracks(one.tracks),
    )


def _tracks(ids: tuple[int, ...]) -> str:
    more = f" and {len(ids) - _TRACKS} more" if len(ids) > _TRACKS else ""
    return ", ".join(map(str, ids[:_TRACKS])) + more or "–"


def passages(finding: Finding) -> Iterator[Element]:
    """Counted passages, where there are lines."""
    if lines := finding.score.passages:
        head = ("line", "happened", "counted", "hit", "of those that happened", "of those counted")
        rows = [
            (name(one.line), one.happened, one.found, one.hit,
             written(one.recall, "share"), written(one.precision, "share"))
            for one in lines
        ]  # fmt: skip
        yield element("h3", "Counted passages")
        yield table(head, rows)
