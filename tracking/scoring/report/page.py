"""The page of a score report: tables, curves, errors over time and on the map, switches."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import tracking
from tracking.pages import Content, Element, element, name, page
from tracking.scoring.conventions import Conventions
from tracking.scoring.report import tables
from tracking.scoring.report.curves import hota_curves
from tracking.scoring.report.findings import Finding, ScoreReport
from tracking.scoring.report.marks import STYLE
from tracking.scoring.report.on_sequence import Shown, lacking, on_sequence, sources_of
from tracking.scoring.similarity import FloorMatch

KIND = "trackwright score report"


def page_of(report: ScoreReport, shown: Mapping[Finding, Shown]) -> str:
    """The page as HTML.

    Args:
        shown: pictures of findings; a finding may have none.
    """
    several = len(report.sequences) > 1
    body: list[Content] = [_introduction(report), _contents(report, several=several)]
    if len(report.results) == 1:
        body.append(_cards(report))
    body.append(_overall(report, several=several))
    if several:
        body.append(_by_sequence(report))
    for number, sequence in enumerate(report.sequences):
        findings = report.on(sequence)
        body.append(element("h2", name(sequence), id=f"sequence-{number}", class_="sheet"))
        for finding in findings:
            if len(report.results) > 1:
                body.append(element("h3", name(finding.result)))
            body.append(on_sequence(finding, report, shown.get(finding, Shown())))
    return page(title_of(report), *body, kind=KIND, style=STYLE)


def title_of(report: ScoreReport) -> str:
    """What the report is on, in a line."""
    results, sequences = report.results, report.sequences
    what = results[0] if len(results) == 1 else f"{len(results)} results"
    where = sequences[0] if len(sequences) == 1 else f"{len(sequences)} recordings"
    return f"{what} on {where}" if what != where else f"Score of {what}"


def how(report: ScoreReport) -> str:
    """How it was measured, in a sentence."""
    match = report.yardstick.match
    paired = (
        f"no farther apart on the floor than {match.radius_m:g} m"
        if isinstance(match, FloorMatch)
        else f"where their boxes overlap by {match.threshold:g} or more (IoU)"
    )
    text = f"A row of the truth and one of the result may be one person {paired}."
    if report.yardstick.conventions is Conventions.MOTMETRICS:
        text += " CLEAR and identity are counted as py-motmetrics counts them, HOTA as TrackEval."
    else:
        text += " Everything is counted as TrackEval counts it."
    return f"{text} Frames count from 0. Made by trackwright {tracking.__version__}."


def _introduction(report: ScoreReport) -> Iterator[Element]:
    names: list[Content] = []
    for number, result in enumerate(report.results):
        names += [", " if number else None, name(result)]
    # Of several findings each tells its own sources.
    sources = list(sources_of(report.findings[0])) if len(report.findings) == 1 else []
    title = "Results: " if len(report.results) > 1 else "Result: "
    told: list[Content] = [] if sources else [title, names, ". "]
    yield from sources
    yield element("p", told, how(report), class_="note")
    if len(report.findings) == 1:
        yield from lacking(report.findings[0])


def _contents(report: ScoreReport, *, several: bool) -> Element | None:
    links = [element("a", "Measures", href="#measures")]
    if several:
        links.append(element("a", "By recording", href="#recordings"))
    links += [
        element("a", name(sequence), href=f"#sequence-{number}")
        for number, sequence in enumerate(report.sequences)
    ]
    return element("nav", links)


def _cards(report: ScoreReport) -> Element:
    """The numbers that most people ask for."""
    score = report.overall[report.results[0]]
    error = score.position_error.mean
    cards = [
        ("HOTA", f"{score.hota.hota:.3f}"),
        ("MOTA", f"{score.clear.mota:.3f}"),
        ("IDF1", f"{score.identity.idf1:.3f}"),
        ("switches", f"{score.clear.id_switches:,}"),
        ("people kept", f"{score.people.kept} of {score.people.detected}"),
    ]
    if error == error:
        cards.append(("floor error", f"{error:.2f} m"))
    made = [element("div", element("b", value), element("span", what), class_="card")
            for what, value in cards]  # fmt: skip
    return element("div", made, class_="cards")


def _overall(report: ScoreReport, *, several: bool) -> Iterator[Element]:
    title = "Measures over all recordings" if several else "Measures"
    yield element("h2", title, id="measures")
    yield element("div", hota_curves(report), class_="drawn" + _narrow(report))
    if len(report.results) > 1:
        says = "A star marks the best; signed numbers are differences from the first result."
        yield element("p", says, class_="note")
    yield tables.measures(report)


def _narrow(report: ScoreReport) -> str:
    return " narrow" if len(report.results) == 1 else ""


def _by_sequence(report: ScoreReport) -> Iterator[Element]:
    yield element("h2", "By recording", id="recordings", class_="sheet")
    for result in report.results:
        yield tables.sequences(report, result)
