"""What `score` prints: measures as JSON, or as tables for people."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from app.cli.score_measuring import Asked, Measured
from app.cli.sequences import Pairing
from tracking.scoring import Score, combined
from tracking.scoring.parts import Rates
from tracking.scoring.report import Finding, people_data, ranges_data
from tracking.scoring.report.measures import Measure, measures_by
from tracking.scoring.report.tables import COMBINED, people_rows


def document_of(asked: Asked, pairing: Pairing, measured: Measured) -> dict[str, Any]:
    """The JSON document; of a single pair its measures alone."""
    findings = {(one.result, one.subject.name): one for one in measured.findings}
    ranges = bool(asked.ranges)
    by_result: dict[str, dict[str, Any]] = {}
    for result, scores in measured.scores.items():
        sequences = {
            name: single_document(
                score,
                findings.get((result, name)),
                measured.parts,
                per_person=asked.per_person,
                ranges=ranges,
            )
            for name, score in scores.items()
        }
        overall = combined(list(scores.values())).as_json()
        by_result[result] = (
            {"sequences": sequences, "combined": overall}
            if pairing.is_batch
            else next(iter(sequences.values()))
        )
    document = next(iter(by_result.values())) if len(by_result) == 1 else {"results": by_result}
    return document | ({"left_out": list(pairing.unmatched)} if pairing.is_batch else {})


def text_of(asked: Asked, pairing: Pairing, measured: Measured) -> str:
    """The same for people."""
    overall = {name: combined(list(found.values())) for name, found in measured.scores.items()}
    pieces = []
    if pairing.is_batch:
        pieces += [sequences_text(measured.scores[name], overall[name], name) for name in overall]
    if len(overall) > 1:
        pieces.append(comparison_text(overall))
    if not pieces:
        (score,) = overall.values()
        finding = measured.findings[0] if measured.findings else None
        return single_text(
            score,
            finding,
            measured.parts,
            per_person=asked.per_person,
            ranges=bool(asked.ranges),
        )
    for finding in measured.findings:
        title = f"{finding.result} on {finding.subject.name}"
        if asked.per_person:
            pieces.append(f"{title}\n{people_text(finding)}")
        if asked.ranges:
            pieces.append(f"{title}\n{ranges_text(finding)}")
    return "\n\n".join(pieces)


def single_document(
    score: Score, finding: Finding | None, parts: Rates | None, *, per_person: bool, ranges: bool
) -> dict[str, Any]:
    """One result on one sequence, as JSON."""
    document = score.as_json() | ({} if parts is None else {"parts": parts.as_json()})
    if finding is not None and per_person:
        document["per_person"] = people_data(finding)
    if finding is not None and ranges:
        document["ranges"] = ranges_data(finding)
    return document


def single_text(
    score: Score, finding: Finding | None, parts: Rates | None, *, per_person: bool, ranges: bool
) -> str:
    """The same for people."""
    pieces = [score.as_text(), *([] if parts is None else [parts.as_text()])]
    if finding is not None and per_person:
        pieces.append(people_text(finding))
    if finding is not None and ranges:
        pieces.append(ranges_text(finding))
    return "\n\n".join(pieces)


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
    return grid(("frames", *(each.name for each in shown)), rows)


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
    widths = [max(map(len, column)) for column in zip(head, *rows, strict=True)]
    return "\n".join(_line(row, widths) for row in (head, *rows))


def _line(cells: Sequence[str], widths: Sequence[int]) -> str:
    first = cells[0].ljust(widths[0])
    rest = [cell.rjust(width) for cell, width in zip(cells[1:], widths[1:], strict=True)]
    return "  ".join([first, *rest]).rstrip()


def _main(finding: Finding, scores: Sequence[Score]) -> list[Measure]:
    conventions = finding.score.clear.conventions
    return [each for each in measures_by(conventions, scores) if each.main]
