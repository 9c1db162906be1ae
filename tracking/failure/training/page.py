"""A training report as a page: curves, confusions and mistakes, in one file that needs no other."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from tracking.failure.training.report import QuestionReport, TrainingReport
from tracking.pages import Panel, Plot, check_report_folder, render, write_report_folder
from tracking.translation import msg

PAGE, DATA = "index.html", "report.json"
KIND = "trackwright training report"

_POINTS = 400
_BEST = 5


def check_training_folder(folder: Path) -> None:
    """Refuse a folder with anything in it but an earlier report; raises OutputError."""
    check_report_folder(folder, (PAGE, DATA), KIND)


def write_report(
    folder: Path, report: TrainingReport, pictures: Mapping[int, bytes] | None = None
) -> tuple[Path, Path]:
    """Write the page and its data into a folder, which is made where it is missing.

    Args:
        folder: missing, empty, or with an earlier report in it, which is replaced.
        pictures: JPEG images of mistakes, by the row of the sample.

    Raises OutputError where something else is in the folder, or it cannot be written.
    """
    data = json.dumps(report.as_json(), indent=2, allow_nan=False) + "\n"
    write_report_folder(folder, {PAGE: page_of(report, pictures or {}), DATA: data}, KIND)
    return folder / PAGE, folder / DATA


def page_of(report: TrainingReport, pictures: Mapping[int, bytes]) -> str:
    """The page as HTML."""
    return render(
        "failure/training/page.html",
        title=msg("Part-failure detector"),
        kind=KIND,
        report=report,
        pictures=pictures,
        rates=[_rates(question) for question in report.questions],
        best={question.name: _best(question) for question in report.questions},
        sections=[(question, _curve(question)) for question in report.questions],
    )


def _rates(question: QuestionReport) -> tuple[str | int, ...]:
    off, on = int(question.confusion[1].sum()), int(question.confusion[0].sum())
    shares = (question.found, question.false_alarms, question.curve.area(), question.area_before)
    return (msg(question.name), off, on, *map(_share, shares))


def _best(question: QuestionReport) -> list[tuple[str, str]]:
    best = sorted(question.tried, key=lambda one: -one.worth)[:_BEST]
    return [(str(one.candidate), f"{one.worth:.3f}") for one in best]


def _curve(question: QuestionReport) -> Plot:
    """The curve of failures found over false alarms, with the operating point."""
    points = question.curve.points()
    kept = np.unique(np.linspace(0, len(points) - 1, _POINTS).round().astype(int))
    alarms, found = 100 * points[kept, 1], 100 * points[kept, 2]
    at = (100 * question.false_alarms, 100 * question.found)
    name = msg(question.name)
    panel = Panel(
        msg("operating points: {question}", question=name),
        {name: np.append(0.0, found)},
        np.append(0.0, alarms),
        (msg("false alarms, %"), msg("failures found, %")),
        (0.0, 100.0),
        (0.0, 100.0),
        {msg("chosen"): at} if all(map(math.isfinite, at)) else {},
    )
    return Plot([panel], 1, says=msg("failures found over false alarms: {question}", question=name))


def _share(value: float) -> str:
    return "–" if math.isnan(value) else f"{value:.1%}"
