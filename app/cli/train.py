"""`train`: the part-failure detector from labelled samples."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import typer

from app.cli.destination import check_file, check_folder, check_replaced, nearest_folder
from app.cli.mistakes import pictures_of
from app.cli.output import print_json, print_line, progress, say
from app.cli.training_set import read_training_set
from tracking.errors import OutputError, TrainingError
from tracking.failure import (
    Trained,
    TrainingPlan,
    built_in_detector,
    check_training_folder,
    save_detector,
    train,
    write_report,
)
from tracking.failure.detector_layout import FORMAT
from tracking.failure.training import QuestionReport, TrainingReport
from tracking.translation import Message, joined, msg

_ENDINGS = (".h5", ".hdf5")
MOST_FALSE_ALARMS = 0.5
"""With more of them a detector tells less than a tossed coin."""


@dataclass(frozen=True, slots=True)
class TrainRequest:
    """What is to be trained.

    Attributes:
        sources: sessions, and exported samples. out: the detector to make.
        report: a folder for a report; None: none.
        false_alarms: share of good parts that may be taken for failed. seed: of the folds.
        from_truth: labels are made from the truth beside rendered recordings.
        allow_outside: a recording outside of its session's folder may be opened.
        from_scratch: nothing of the built-in detector is kept.
        paper: by the paper's features alone.
    """

    sources: tuple[Path, ...]
    out: Path
    report: Path | None
    false_alarms: float
    seed: int
    from_truth: bool = False
    allow_outside: bool = False
    from_scratch: bool = False
    paper: bool = False


def run_train(request: TrainRequest, *, as_json: bool) -> None:
    """Train, write the detector and say how good it is.

    Raises TrainingError where the samples are too few.
    """
    _check(request)
    training_set = read_training_set(
        request.sources, from_truth=request.from_truth, allow_outside=request.allow_outside
    )
    samples = training_set.samples
    if not len(samples):
        names = joined(", ", request.sources)
        raise TrainingError(
            "{names}: no label of a tracked body part; label some parts first", names=names
        )
    plan = TrainingPlan(
        false_alarms=request.false_alarms,
        adapt=None if request.from_scratch else built_in_detector,
        paper=request.paper,
    )
    with progress("training") as told:
        made = train(samples, plan, random=np.random.default_rng(request.seed), progress=told)
    save_detector(request.out, made.detector)
    page = None
    if request.report is not None:
        pictures = pictures_of(made, training_set, allow_outside=request.allow_outside)
        page = write_report(request.report, made.report, pictures)[0]
    _print(made, request, page, as_json=as_json)


def _check(request: TrainRequest) -> None:
    """Refuse what could not be written in the end, or would be lost."""
    if request.out.suffix.lower() not in _ENDINGS:
        reason = msg(
            "a part-failure detector's name ends in .h5: give {stem}.h5",
            stem=request.out.stem or "NAME",
        )
        raise typer.BadParameter(reason, param_hint="--out")
    if not 0 <= request.false_alarms <= MOST_FALSE_ALARMS:  # NaN, too
        reason = msg(
            "{false_alarms} is not from 0 to {most}",
            false_alarms=request.false_alarms,
            most=MOST_FALSE_ALARMS,
        )
        raise typer.BadParameter(reason, param_hint="--false-alarms")
    check_file(request.out)
    check_replaced(request.out, FORMAT)
    if request.report is not None:
        check_folder(nearest_folder(request.report))
        check_training_folder(request.report)
        if request.report.resolve() in request.out.resolve().parents:
            raise OutputError(
                "{out} would lie in the report's folder; choose another place with -o",
                out=request.out,
            )


def _print(made: Trained, request: TrainRequest, page: Path | None, *, as_json: bool) -> None:
    report = made.report
    if as_json:
        written = {"written": str(request.out), "report": str(page) if page else None}
        print_json({**written, **report.as_json()})
        return
    for question in report.questions:
        say(_line_of(question))
    _say_what_was_kept(report)
    if report.by_chance:
        names = joined(", ", (msg(question.name) for question in report.by_chance))
        say(
            msg(
                "warning: no better than chance: {names}; do not track with this detector "
                "before labels were looked over, or more parts labelled",
                names=names,
            )
        )
    print_line(request.out)
    if page is not None:
        print_line(page)


def _line_of(question: QuestionReport) -> Message:
    """How well a question is answered, and how well the built-in detector answers it."""
    if math.isnan(question.curve.area()):
        return msg(
            "{question:<8} too few labels: {off} off, {on} on; {chosen}",
            question=msg(question.name),
            off=question.confusion[1].sum(),
            on=question.confusion[0].sum(),
            chosen=question.candidate,
        )
    before = Message()
    if not math.isnan(question.area_before):
        before = msg(" (built-in detector: {area:.2f})", area=question.area_before)
    return msg(
        "{question:<8} {found:6.1%} of {off} found, {alarms:5.1%} of {on} false alarms, "
        "area under the curve {area:.2f}{before}; {chosen}",
        question=msg(question.name),
        found=question.found,
        off=question.confusion[1].sum(),
        alarms=question.false_alarms,
        on=question.confusion[0].sum(),
        area=question.curve.area(),
        before=before,
        chosen=question.candidate,
    )


def _say_what_was_kept(report: TrainingReport) -> None:
    """Say where the labels made nothing better, and which features are seen."""
    if report.kept:
        names = joined(", ", (msg(question.name) for question in report.kept))
        say(
            msg(
                "kept from the built-in detector, as nothing learnt from these labels is better on "
                "people held out: {names}",
                names=names,
            )
        )
    if report.adapted and report.detector.preparation.paper:
        say(
            msg(
                "note: by the paper's features alone; sessions tracked with an older version know "
                "no others: track again and label there for a better detector"
            )
        )
