"""Training: samples to a detector, with its operating points measured on people held out."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass
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
from tracking.failure.training.folds import folds_of, thinned
from tracking.failure.training.gross import with_gross_failures
from tracking.failure.training.questions import NAMES, SEVERAL, Question, questions_of
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
    """

    false_alarms: float = FALSE_ALARMS
    folds: int = 5
    grid: tuple[Candidate, ...] = GRID
    searched: int = 1200
    learnt: int = 4000


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

    Raises:
        TrainingError: a part has too few samples, or of too few people.
        CancelledError: by `progress`.
    """
    plan = plan or TrainingPlan()
    questions = questions_of(samples)
    folds = folds_of(questions, plan.folds, random)
    count = int(folds.max()) + 1
    few, many = (
        [with_gross_failures(thinned(one, most, random), samples, random) for one in questions]
        for most in (plan.searched, plan.learnt)
    )
    total = len(questions) * (count * (2 * len(plan.grid) + 1) + 1)
    steps = Steps(total, progress)
    preparations = _preparations(samples, folds[samples.people()], count)
    wide = max(0.1, 2 * plan.false_alarms)
    choice, tried = search(few, folds, preparations, plan.grid, wide, steps)
    scores = [
        held_out_scores(question, folds, preparations[choice.by_size], [candidate], steps)[0]
        for question, candidate in zip(many, choice.candidates, strict=True)
    ]
    detector = _detector(many, choice, samples, scores, plan, steps)
    return Trained(detector, _report(detector, many, scores, samples, choice, tried, count))


def _preparations(
    samples: Samples, fold: NDArray[np.int64], count: int
) -> dict[bool, list[Preparation]]:
    """By whether they measure in bodies: for each fold one that never saw its samples."""
    usual = samples.columns["label"] == 1
    return {
        by_size: [
            fitted_preparation(samples.features[usual & (fold != held)], by_size=by_size)
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
) -> Detector:
    """The detector that has learnt from everybody, at operating points of those held out."""
    usual = samples.features[samples.columns["label"] == 1]
    preparation = fitted_preparation(usual, by_size=choice.by_size)
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
