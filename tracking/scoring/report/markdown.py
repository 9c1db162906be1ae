"""A score report as Markdown: the tables of the page, for notes and pull requests."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from tracking.scoring.errors import ErrorKind
from tracking.scoring.report import tables
from tracking.scoring.report.curves import PART_HEAD, part_rows
from tracking.scoring.report.distances import NO_PLACES, distance_rows
from tracking.scoring.report.findings import Finding, ScoreReport
from tracking.scoring.report.measures import by_group
from tracking.scoring.report.missing_values import lacking_said
from tracking.scoring.report.page import how, title_of
from tracking.scoring.report.sources import sources_said
from tracking.translation import msg, shown, tr

MOST_SWITCHES = 200
"""Listed of one result on one sequence."""

_MARKUP = re.compile(r"([\\`*_{}\[\]<>#|~!&])")
_CONTROL = re.compile(
    "[\x00-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ud800-\udfff]"
)
"""Control characters, line ends, marks that turn the direction of writing, broken letters."""


def markdown_of(report: ScoreReport) -> str:
    """The report as Markdown."""
    parts = [f"# {plain(title_of(report))}", plain(how(report)), *_overall(report)]
    if len(report.sequences) > 1:
        parts += ["## " + tr("By recording"), *(_sequences(report, one) for one in report.results)]
    for finding in report.findings:
        parts += _finding(finding, report)
    return "\n\n".join(parts) + "\n"


def plain(text: str) -> str:
    """Text in which nothing is markup, on one line; a message in the user's language."""
    return _MARKUP.sub(r"\\\1", _CONTROL.sub(" ", str(shown(text))))


def _table(head: Sequence[str], rows: Sequence[Sequence[str]], words: int = 1) -> str:
    """A table; cells are markup already."""
    lines = [
        " --- " if column < words or not title else " ---: " for column, title in enumerate(head)
    ]
    titles, *cells = (
        f"| {' | '.join(str(shown(cell)) for cell in row)} |" for row in (head, *rows)
    )
    return "\n".join([titles, f"|{'|'.join(lines)}|", *cells])


def _overall(report: ScoreReport) -> Iterator[str]:
    yield "## " + tr("Measures")
    scores = [report.overall[result] for result in report.results]
    for group, members in by_group(tables.measures_of(report)).items():
        rows = []
        for measure in members:
            best = measure.best(scores)
            cells = [measure.shown(score) for score in scores]
            cells = [f"**{c}**" if number in best else c for number, c in enumerate(cells)]
            rows.append([plain(measure.name), *cells, plain(measure.says)])
        head = [plain(group), *map(plain, report.results), ""]
        yield _table(head, rows)


def _sequences(report: ScoreReport, result: str) -> str:
    names = (plain(each.name) for each in tables.main_measures(report))
    *rows, last = tables.sequence_rows(report, result)
    return _table([plain(result), *names], [*((plain(one), *more) for one, *more in rows), last])


def _finding(finding: Finding, report: ScoreReport) -> Iterator[str]:
    yield f"## {plain(finding.subject.name)}: {plain(finding.result)}"
    if lines := [
        f"- {shown(title)}: {plain(at + more)}" for title, at, more in sources_said(finding)
    ]:
        yield "\n".join(lines)
    yield from map(plain, lacking_said(finding))
    if finding.ranges:
        names = (plain(each.name) for each in tables.main_measures(report))
        yield _table([msg("frames"), *names], tables.range_rows(finding, report))
    if finding.distances:
        yield _table(*distance_rows(finding.distances))
    else:
        yield plain(NO_PLACES)
    if finding.people:
        head, cells = tables.people_rows(finding)
        yield _table(head, [[plain(cell) for cell in row] for row in cells])
    if finding.parts is not None:
        yield _table(PART_HEAD, part_rows(finding.parts))
    yield from _switches(finding)


def _switches(finding: Finding) -> Iterator[str]:
    found = finding.errors.of_kind(ErrorKind.SWITCH)
    if not len(found):
        return
    columns = (found.frame, found.truth, found.earlier, found.result)
    rows = [
        [str(int(column[row])) for column in columns]
        for row in range(min(len(found), MOST_SWITCHES))
    ]
    yield _table(
        [
            msg("switch in frame"),
            msg("person"),
            msg("from track"),
            msg("to track"),
        ],
        rows,
        words=0,
    )
    if len(found) > MOST_SWITCHES:
        yield tr("{n} more switches are in the JSON file.", n=len(found) - MOST_SWITCHES)
