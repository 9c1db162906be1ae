"""What `score` prints: measures as JSON, or as tables for people."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from app.cli.output import escape_controls
from app.cli.score_measurement import MeasureRequest, SequenceMeasurement
from app.cli.sequences import Pairing
from tracking.scoring import Score, combined
from tracking.scoring.report import (
    NO_PLACES,
    Finding,
    distance_rows,
    distances_data,
    people_data,
    ranges_data,
)
from tracking.scoring.report.measures import Measure, measures_by
from tracking.scoring.report.tables import COMBINED, people_rows
from tracking.text_columns import columns_of, to_left, to_right
from tracking.translation import msg, tr


def document_of(
    asked: MeasureRequest, pairing: Pairing, measured: Sequence[SequenceMeasurement]
) -> dict[str, Any]:
    """The JSON document; of a single pair its measures alone."""
    by_result: dict[str, dict[str, Any]] = {}
    for result in pairing.results:
        own = [each for each in measured if each.result == result]
        by_result[result] = (
            {
                "sequences": {each.sequence: _single_document(asked, each) for each in own},
                "combined": combined([each.score for each in own]).as_json(),
            }
            if pairing.is_batch
            else _single_document(asked, own[0])
        )
    document = next(iter(by_result.values())) if len(by_result) == 1 else {"results": by_result}
    return document | ({"left_out": list(pairing.unmatched)} if pairing.is_batch else {})


def text_of(
    asked: MeasureRequest, pairing: Pairing, measured: Sequence[SequenceMeasurement]
) -> str:
    """The same for people."""
    if len(measured) == 1 and not pairing.is_batch:
        return "\n\n".join([measured[0].score.as_text(), *_more(asked, measured[0])])
    scores: dict[str, dict[str, Score]] = {}
    for each in measured:
        scores.setdefault(each.result, {})[each.sequence] = each.score
    overall = {name: combined(list(found.values())) for name, found in scores.items()}
    pieces = []
    if pairing.is_batch:
        pieces += [sequences_text(scores[name], overall[name], name) for name in overall]
    if len(overall) > 1:
        pieces.append(comparison_text(overall))
    for each in measured:
        title = tr("{result} on {sequence}", result=each.result, sequence=each.sequence)
        pieces += [f"{title}\n{piece}" for piece in _more(asked, each)]
    return "\n\n".join(pieces)


def _single_document(asked: MeasureRequest, one: SequenceMeasurement) -> dict[str, Any]:
    document = one.score.as_json()
    if one.parts is not None:
        document["parts"] = one.parts.as_json()
    if one.finding is not None and asked.per_person:
        document["per_person"] = people_data(one.finding)
    if one.finding is not None and asked.ranges:
        document["ranges"] = ranges_data(one.finding)
    if one.finding is not None and asked.distances is not None:
        document["distances"] = distances_data(one.finding.distances)
    return document


def _more(asked: MeasureRequest, one: SequenceMeasurement) -> Iterator[str]:
    """What is told beside the scores."""
    if one.parts is not None:
        yield one.parts.as_text()
    if one.finding is not None and asked.per_person:
        yield people_text(one.finding)
    if one.finding is not None and asked.ranges:
        yield ranges_text(one.finding)
    if one.finding is not None and asked.distances is not None:
        yield (
            grid(*distance_rows(one.finding.distances)) if one.finding.distances else tr(NO_PLACES)
        )


def people_text(finding: Finding) -> str:
    """A line a person."""
    return grid(*people_rows(finding))


def ranges_text(finding: Finding) -> str:
    """A line a range of frames."""
    shown = _main(finding, [finding.score])
    rows = [
        (f"{start}:{stop}", *(each.shown(score) for each in shown))
        for (start, stop), score in finding.ranges.items()
    ]
    return grid((msg("frames"), *(each.name for each in shown)), rows)


def sequences_text(scores: Mapping[str, Score], overall: Score, title: str) -> str:
    """One result: a line a sequence, and the combined one last."""
    shown = [each for each in measures_by(overall.clear.conventions, [overall]) if each.main]
    rows = [(name, *(each.shown(one) for each in shown)) for name, one in scores.items()]
    rows.append((COMBINED, *(each.shown(overall) for each in shown)))
    return grid((title, *(each.name for each in shown)), rows)


def comparison_text(overall: Mapping[str, Score]) -> str:
    """Several results side by side, a line a measure; a star marks the best."""
    scores = list(overall.values())
    rows = []
    for each in measures_by(scores[0].clear.conventions, scores):
        best = each.best(scores)
        marks = [" *" if number in best else "  " for number in range(len(scores))]
        rows.append((each.name, *(each.shown(s) + m for s, m in zip(scores, marks, strict=True))))
    return grid(("", *(f"{name}  " for name in overall)), rows)


def grid(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Columns side by side; the first holds words, the others numbers."""
    lines = [[escape_controls(cell) for cell in row] for row in (head, *rows)]
    widths = [max(map(columns_of, column)) for column in zip(*lines, strict=True)]
    return "\n".join(_line(row, widths) for row in lines)


def _line(cells: Sequence[str], widths: Sequence[int]) -> str:
    first = to_left(cells[0], widths[0])
    rest = [to_right(cell, width) for cell, width in zip(cells[1:], widths[1:], strict=True)]
    return "  ".join([first, *rest]).rstrip()


def _main(finding: Finding, scores: Sequence[Score]) -> list[Measure]:
    conventions = finding.score.clear.conventions
    return [each for each in measures_by(conventions, scores) if each.main]
