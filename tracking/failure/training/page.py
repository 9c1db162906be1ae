"""A training report as a page: curves, confusions and mistakes, in one file that needs no other."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Mapping
from pathlib import Path

import numpy as np

from tracking.failure.training.report import Mistake, QuestionReport, TrainingReport
from tracking.pages import (
    Element,
    Panel,
    check_report_folder,
    drawn,
    element,
    name,
    page,
    picture,
    table,
    write_report_folder,
)

PAGE, DATA = "index.html", "report.json"
KIND = "trackwright training report"

_POINTS = 400
_NAMED = 8


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
    sections = [_section(question, pictures) for question in report.questions]
    return page("Part-failure detector", _summary(report), *sections, kind=KIND)


def _summary(report: TrainingReport) -> Iterator[Element]:
    origin = report.detector.origin
    names = ", ".join(origin.recordings[:_NAMED])
    left = len(origin.recordings) - _NAMED
    measured = "sizes of the person" if report.by_size else "pixels"
    yield element(
        "p",
        f"{origin.people} people of ",
        name(names),
        f" and {left} more" if left > 0 else None,
        f"; {report.folds} folds, split by recording and person; features in {measured}; "
        f"fingerprint {report.detector.fingerprint}; {origin.software}.",
    )
    head = ("", "off its part", "on its part", "failures found", "false alarms")
    yield table((*head, "area under the curve"), map(_rates, report.questions))
    yield element(
        "p",
        "Every rate is of people whom the machine that judged them had not seen. "
        "Parameters and thresholds were chosen by these rates, so others may fare a little worse. "
        "The row several counts instants at which a part is lost: off its part where others are "
        "lost, too, on its part where it is the only one; a false alarm takes one for several.",
        class_="note",
    )


def _rates(question: QuestionReport) -> tuple[str | int, ...]:
    off, on = int(question.confusion[1].sum()), int(question.confusion[0].sum())
    shares = (question.found, question.false_alarms, question.curve.area())
    return (question.name, off, on, *map(_share, shares))


def _section(question: QuestionReport, pictures: Mapping[int, bytes]) -> Iterator[Element]:
    yield element("h2", question.name)
    curve = element("div", _curve(question), class_="drawn narrow")
    yield element("div", curve, element("div", *_choice(question)), class_="row")
    if question.mistakes:
        yield element("h3", "Most informative mistakes")
        colours = "Green rectangles are labelled on their part, red ones off it."
        yield element("p", colours, class_="note")
        shown = [_mistake(one, pictures) for one in question.mistakes]
        yield element("div", shown, class_="pictures little")


def _choice(question: QuestionReport) -> Iterator[Element]:
    """What was counted, and what was chosen."""
    sides = ("one part", "several") if question.name == "several" else ("on its part", "off it")
    said = ("said: one", "said: several") if question.name == "several" else ("said: on", "failed")
    counts = zip(sides, question.confusion.tolist(), strict=True)
    yield table(("truth", *said), [(side, *row) for side, row in counts])
    yield element("p", f"{question.candidate}; fails above {question.threshold:.3f}")
    best = sorted(question.tried, key=lambda one: -one.worth)[:5]
    rows = [(str(one.candidate), f"{one.worth:.3f}") for one in best]
    yield table(("best of the grid", "found while alarms are few"), rows)


def _curve(question: QuestionReport) -> Element:
    """The curve of failures found over false alarms, with the operating point."""
    points = question.curve.points()
    kept = np.unique(np.linspace(0, len(points) - 1, _POINTS).round().astype(int))
    alarms, found = 100 * points[kept, 1], 100 * points[kept, 2]
    at = (100 * question.false_alarms, 100 * question.found)
    panel = Panel(
        f"operating points: {question.name}",
        {question.name: np.append(0.0, found)},
        np.append(0.0, alarms),
        ("false alarms, %", "failures found, %"),
        (0.0, 100.0),
        (0.0, 100.0),
        {"chosen": at} if all(map(math.isfinite, at)) else {},
    )
    return drawn([panel], 1, says=f"failures found over false alarms: {question.name}")


def _mistake(mistake: Mistake, pictures: Mapping[int, bytes]) -> Element:
    said = "said: failed" if mistake.failed else "said: on its part"
    jpeg = pictures.get(mistake.sample)
    where = f", track {mistake.track}, frame {mistake.frame}"
    return element(
        "figure",
        None if jpeg is None else picture(jpeg, f"track {mistake.track}, frame {mistake.frame}"),
        element(
            "figcaption",
            name(mistake.recording),
            where,
            element("br"),
            f"{said}, {mistake.score:+z.2f}",
        ),
    )


def _share(value: float) -> str:
    return "–" if math.isnan(value) else f"{value:.1%}"
