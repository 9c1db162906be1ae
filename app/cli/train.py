"""`train`: the part-failure detector from labelled samples."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from app.cli.destination import check_file, check_folder, check_replaced, nearest_folder
from app.cli.mistakes import pictures_of
from app.cli.output import print_json, progress, say
from app.cli.taught import How, all_taught
from tracking.errors import OutputError, TrainingError
from tracking.failure import (
    Trained,
    TrainingPlan,
    check_training_folder,
    save_detector,
    train,
    write_report,
)
from tracking.failure.detector_layout import FORMAT

_ENDINGS = (".h5", ".hdf5")


@dataclass(frozen=True, slots=True)
class Wish:
    """What is to be trained.

    Attributes:
        sources: sessions, and exported samples. out: the detector to make.
        report: a folder for a report; None: none.
        false_alarms: share of good parts that may be taken for failed. seed: of the folds.
        how: labels are come by.
    """

    sources: tuple[Path, ...]
    out: Path
    report: Path | None
    false_alarms: float
    seed: int
    how: How


def run_train(wish: Wish, *, as_json: bool) -> None:
    """Train, write the detector and say how good it is.

    Raises TrainingError where the samples are too few.
    """
    _check(wish)
    taught = all_taught(wish.sources, wish.how)
    samples = taught.samples
    if not len(samples):
        names = ", ".join(map(str, wish.sources))
        raise TrainingError(f"{names}: no label of a tracked body part; label some parts first")
    plan = TrainingPlan(false_alarms=wish.false_alarms)
    with progress("training") as told:
        made = train(samples, plan, random=np.random.default_rng(wish.seed), progress=told)
    save_detector(wish.out, made.detector)
    page = None
    if wish.report is not None:
        pictures = pictures_of(made, taught, allow_outside=wish.how.allow_outside)
        page = write_report(wish.report, made.report, pictures)[0]
    _print(made, wish, page, as_json=as_json)


def _check(wish: Wish) -> None:
    """Refuse what could not be written in the end, or would be lost."""
    if wish.out.suffix.lower() not in _ENDINGS:
        raise OutputError(f"{wish.out}: a detector's name ends in .h5; rename it with -o")
    check_file(wish.out)
    check_replaced(wish.out, FORMAT)
    if wish.report is not None:
        check_folder(nearest_folder(wish.report))
        check_training_folder(wish.report)
        if wish.report.resolve() in wish.out.resolve().parents:
            raise OutputError(
                f"{wish.out} would lie in the report's folder; choose another place with -o"
            )


def _print(made: Trained, wish: Wish, page: Path | None, *, as_json: bool) -> None:
    report = made.report
    if as_json:
        written = {"written": str(wish.out), "report": str(page) if page else None}
        print_json({**written, **report.as_json()})
        return
    for question in report.questions:
        say(
            f"{question.name:<8} {question.found:6.1%} of {question.confusion[1].sum()} found, "
            f"{question.false_alarms:5.1%} of {question.confusion[0].sum()} false alarms, "
            f"area under the curve {question.curve.area():.2f}; {question.candidate}"
        )
    if report.by_chance:
        names = ", ".join(question.name for question in report.by_chance)
        say(
            f"warning: no better than chance: {names}; do not track with this detector before "
            "labels were looked over, or more parts labelled"
        )
    print(wish.out)
    if page is not None:
        print(page)
