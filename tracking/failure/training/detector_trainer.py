"""Training: samples to a detector, with its operating points measured on people held out."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, replace
from datetime import UTC, datetime

import numpy as np
from numpy.typing import NDArray

import tracking
from tracking.arrays import Floats
from tracking.failure.core.detector import FALSE_ALARMS, Detector, Origin
from tracking.failure.core.machines import Machines
from tracking.failure.core.operating_points import Curve
from tracking.failure.core.preparation import Preparation, fitted_preparation
from tracking.failure.core.samples import SAMPLE_COLUMNS, TEXT, Samples
from tracking.failure.training.adaptation import Adapted, adapted, steps_of, unchanged
from tracking.failure.training.folds import folds_of, folds_of_few, thinned
from tracking.failure.training.gross import with_gross_failures
from tracking.failure.training.questions import (
    LEAST_SAMPLES,
    LEAST_TO_ADAPT,
    NAMES,
    SEVERAL,
    Question,
    all_questions,
    questions_of,
    shortage,
)
from tracking.failure.training.report import TrainingReport, question_report
from tracking.failure.training.search import Choice, Tried, curve_of, held_out_scores, search
from tracking.failure.training.steps import Steps
from tracking.failure.training.svm_fit import GRID, Candidate, fitted, library
from tracking.progress import Progress
from tracking.tracks import PARTS


@dataclass(frozen=True, slots=True)
class TrainingPlan:
    """How to train.

    Attributes:
        false_alarms: share of samples on their part that may fail at the operating point.
        folds: at most so many; fewer where there are fewer people.
        grid: parameters to try.
        searched, learnt: samples of each question to search with, and to learn from, at most.
        adapt: gives the detector to be adapted, asked with `paper`, whether it is to see the
            paper's features alone; None: all is learnt from these samples.
        paper: whether the detector sees the features of [ZhaoLee2009] alone.
    """

    false_alarms: float = FALSE_ALARMS
    folds: int = 5
    grid: tuple[Candidate, ...] = GRID
    searched: int = 1200
    learnt: int = 4000
    adapt: Callable[..., Detector] | None = None
    paper: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class Trained:
    """A detector and what was measured while it was made."""

    detector: Detector
    report: TrainingReport


def train(
    samples: Samples,
    plan: TrainingPlan | None = None,
    *,
    random: np.random.Generator,
    progress: Progress | None = None,
) -> Trained:
    """Train a detector; the same samples and random numbers give the same one.

    Folds are split by recording and person. Each operating point is chosen on scores of people
    that were held out; the machines that are kept have learnt from everybody. They learn from
    failures that were made, too (see `gross`), but every rate is of labelled samples alone.

    Samples without evidence are left out where enough others are left; where not, the detector
    sees the paper's features alone.

    Raises:
        TrainingError: a part has too few samples, or of too few people; to adapt, all parts do.
        CancelledError: by `progress`.
    """
    plan = plan or TrainingPlan()
    least = LEAST_TO_ADAPT if plan.adapt else LEAST_SAMPLES
    paper = plan.paper or not _keeps_enough(samples, samples.has_evidence, least)
    rows = np.flatnonzero(samples.has_evidence | paper)
    made = (
        _adapt(samples[rows], plan, plan.adapt(paper=paper), random, progress)
        if plan.adapt is not None
        else _train(samples[rows], plan, paper, random, progress)
    )
    return replace(made, report=made.report.of_rows(rows))


def _keeps_enough(samples: Samples, known: NDArray[np.bool_], least: int) -> bool:
    """Whether no part that can be learnt from all samples lacks those that are not known."""
    every, some = all_questions(samples)[:PARTS], all_questions(samples[known])[:PARTS]
    able = [not shortage(question, least) for question in every]
    return bool(known.any()) and not any(
        may and shortage(question, least) for may, question in zip(able, some, strict=True)
    )


def _adapt(
    samples: Samples,
    plan: TrainingPlan,
    base: Detector,
    random: np.random.Generator,
    progress: Progress | None,
) -> Trained:
    """The base adapted, part by part; see `adaptation`."""
    asked = all_questions(samples)[: len(base.machines.each)]
    able = [question for question in asked if not shortage(question, LEAST_TO_ADAPT)]
    if not any(question.number < PARTS for question in able):
        questions_of(samples, LEAST_TO_ADAPT)  # says what is missing
    folds = folds_of_few(able, plan.folds, random)
    count = int(folds.max()) + 1
    steps = Steps(steps_of(able, count), progress)
    numbers = {question.number for question in able}
    questions = [
        with_gross_failures(thinned(one, plan.learnt, random), samples, random)
        if one.number in numbers
        else one
        for one in asked
    ]
    each = [
        adapted(one, folds, base, steps) if one.number in numbers else unchanged(one, base)
        for one in questions
    ]
    curves = tuple(
        curve_of(one, made.scores) if one.number in numbers else base.curves[one.number]
        for one, made in zip(questions, each, strict=True)
    )
    choice = Choice(base.preparation.by_size, tuple(one.blend for one in each))
    machines = Machines(tuple(one.machine for one in each))
    detector = _with_thresholds(machines, curves, numbers, base, plan)
    detector = replace(detector, origin=_origin(samples, questions, choice))
    return Trained(detector, _adapted_report(detector, questions, each, samples, choice, count))


def _with_thresholds(
    machines: Machines,
    curves: tuple[Curve, ...],
    numbers: Collection[int],
    base: Detector,
    plan: TrainingPlan,
) -> Detector:
    """The adapted detector: new operating points where samples say so, else those there were."""
    thresholds = [
        curves[part].threshold_for(plan.false_alarms)
        if part in numbers
        else float(base.thresholds[part])
        for part in range(PARTS)
    ]
    several = _evenly(curves[SEVERAL]) if SEVERAL in numbers else base.several_threshold
    return Detector(base.preparation, machines, np.array(thresholds), several, curves)


def _adapted_report(
    detector: Detector,
    questions: Sequence[Question],
    each: Sequence[Adapted],
    samples: Samples,
    choice: Choice,
    folds: int,
) -> TrainingReport:
    thresholds = [*detector.thresholds.tolist(), detector.several_threshold]
    reports = tuple(
        question_report(
            *(one.asked(), made.scores[~one.made], threshold, samples, choice, made.tried),
            before=made.before[~one.made],
        )
        for one, made, threshold in zip(questions, each, thresholds, strict=False)
    )
    return TrainingReport(reports, choice.by_size, folds, detector, adapted=True)


def _train(
    samples: Samples,
    plan: TrainingPlan,
    paper: bool,
    random: np.random.Generator,
    progress: Progress | None,
) -> Trained:
    """A detector that learns from nothing but these samples."""
    questions = questions_of(samples)
    folds = folds_of(questions, plan.folds, random)
    count = int(folds.max()) + 1
    few, many = (
        [with_gross_failures(thinned(one, most, random), samples, random) for one in questions]
        for most in (plan.searched, plan.learnt)
    )
    total = len(questions) * (count * (2 * len(plan.grid) + 1) + 1)
    steps = Steps(total, progress)
    preparations = _preparations(samples, folds[samples.people()], count, paper)
    wide = max(0.1, 2 * plan.false_alarms)
    choice, tried = search(few, folds, preparations, plan.grid, wide, steps)
    scores = [
        held_out_scores(question, folds, preparations[choice.by_size], [candidate], steps)[0]
        for question, candidate in zip(many, choice.candidates, strict=True)
    ]
    detector = _detector(many, choice, samples, scores, plan, steps, paper)
    return Trained(detector, _report(detector, many, scores, samples, choice, tried, count))


def _preparations(
    samples: Samples, fold: NDArray[np.int64], count: int, paper: bool
) -> dict[bool, list[Preparation]]:
    """By whether they measure in bodies: for each fold one that never saw its samples."""
    usual = samples.columns["label"] == 1
    return {
        by_size: [
            fitted_preparation(
                samples.features[usual & (fold != held)], by_size=by_size, paper=paper
            )
            for held in range(count)
        ]
        for by_size in (False, True)
    }


def _detector(
    questions: Sequence[Question],
    choice: Choice,
    samples: Samples,
    scores: Sequence[Floats],
    plan: TrainingPlan,
    steps: Steps,
    paper: bool,
) -> Detector:
    """The detector that has learnt from everybody, at operating points of those held out."""
    usual = samples.features[samples.columns["label"] == 1]
    preparation = fitted_preparation(usual, by_size=choice.by_size, paper=paper)
    machines = []
    for question, candidate in zip(questions, choice.candidates, strict=True):
        machines.append(fitted(preparation.of(question.features), question.yes, candidate))
        steps.take()
    curves = tuple(curve_of(one, values) for one, values in zip(questions, scores, strict=True))
    several = _evenly(curves[SEVERAL]) if len(curves) > SEVERAL else 0.0
    origin = _origin(samples, questions, choice)
    made = Detector(
        preparation, Machines(tuple(machines)), np.zeros(PARTS), several, curves, origin
    )
    return made.with_operating_point(plan.false_alarms)


def _evenly(curve: Curve) -> float:
    """The threshold at which both answers are right equally often, as nearly as can be."""
    points = curve.points()
    return float(points[np.argmin(np.abs(1.0 - points[:, 2] - points[:, 1])), 0])


def _origin(samples: Samples, questions: Sequence[Question], choice: Choice) -> Origin:
    instants = np.zeros(2, np.int64)
    if len(questions) > SEVERAL:
        instants = np.bincount(questions[SEVERAL].asked().yes, minlength=2)
    recordings = sorted(set(samples.columns["recording"].tolist()))
    chosen = [f"{NAMES[at]}: {candidate}" for at, candidate in enumerate(choice.candidates)]
    return Origin(
        counts=samples.counts(),
        instants=instants,
        recordings=tuple(recordings),
        people=int(samples.people().max()) + 1,
        samples=_hash_of(samples),
        made=datetime.now(UTC).isoformat(timespec="seconds"),
        software=f"trackwright {tracking.__version__}, {library()}, numpy {np.__version__}",
        chosen="; ".join((*chosen, f"in {'bodies' if choice.by_size else 'pixels'}")),
    )


def _hash_of(samples: Samples) -> str:
    """SHA-256 over what the samples say, row by row in their order."""
    said = hashlib.sha256(np.ascontiguousarray(samples.features, "<f8").tobytes())
    for name, dtype in SAMPLE_COLUMNS.items():
        column = samples.columns[name]
        text = dtype == TEXT
        said.update("\0".join(column).encode() if text else column.astype("<i8").tobytes())
    return said.hexdigest()


def _report(
    detector: Detector,
    questions: Sequence[Question],
    scores: Sequence[Floats],
    samples: Samples,
    choice: Choice,
    tried: Sequence[Tried],
    folds: int,
) -> TrainingReport:
    thresholds = [*detector.thresholds.tolist(), detector.several_threshold]
    reports = tuple(
        question_report(question.asked(), values[~question.made], threshold, samples, choice, tried)
        for question, values, threshold in zip(questions, scores, thresholds, strict=False)
    )
    return TrainingReport(reports, choice.by_size, folds, detector)
