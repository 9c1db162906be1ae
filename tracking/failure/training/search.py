"""The grid search: which parameters find most failures of people who were held out."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.failure.core.machines import Machines
from tracking.failure.core.operating_points import Curve
from tracking.failure.core.preparation import Preparation
from tracking.failure.training.questions import SEVERAL, Question
from tracking.failure.training.steps import Steps
from tracking.failure.training.svm_fit import Candidate, fitted
from tracking.tracks import PARTS


@dataclass(frozen=True, slots=True, eq=False)
class Tried:
    """How well some parameters did.

    Attributes:
        question: number of it. by_size: of the preparation. candidate: its text names it.
        worth: mean share of failures found while false alarms are few; of one-or-several, where
            both mistakes cost alike, at any number of them.
        unsure: the standard error of a share found, of as many failures as there were.
    """

    question: int
    by_size: bool
    candidate: object
    worth: float
    unsure: float = 0.0


@dataclass(frozen=True, slots=True, eq=False)
class Choice:
    """What the search chose: one preparation for all, parameters for each question."""

    by_size: bool
    candidates: tuple[Any, ...]


def search(
    questions: Sequence[Question],
    folds: NDArray[np.int64],
    preparations: Mapping[bool, Sequence[Preparation]],
    grid: Sequence[Candidate],
    most_false_alarms: float,
    steps: Steps,
) -> tuple[Choice, list[Tried]]:
    """Try everything; gives the choice and all results.

    Args:
        folds: of each person. preparations: by whether they measure in bodies, one a fold.
        most_false_alarms: how far the operating points of interest reach.
    """
    tried = [
        Tried(question.number, by_size, candidate, *_worth(curve_of(question, scores), most))
        for by_size, of_folds in preparations.items()
        for question in questions
        for candidate, scores in zip(
            grid, held_out_scores(question, folds, of_folds, grid, steps), strict=True
        )
        for most in [1.0 if question.number == SEVERAL else most_false_alarms]
    ]
    return best_of(tried, len(questions)), tried


def held_out_scores(
    question: Question,
    folds: NDArray[np.int64],
    preparations: Sequence[Preparation],
    grid: Sequence[Candidate],
    steps: Steps,
) -> Floats:
    """(candidates, n) scores of each sample by machines that never saw its person.

    Those that were made are learnt from and not scored: NaN.
    """
    fold = folds[question.people]
    scores = np.full((len(grid), len(question)), np.nan)
    for held, preparation in enumerate(preparations):
        inside, outside = fold != held, (fold == held) & ~question.made
        values = preparation.of(question.features[inside])
        asked = preparation.of(question.features[outside])
        for at, candidate in enumerate(grid):
            machine = fitted(values, question.yes[inside], candidate)
            scores[at, outside] = Machines((machine,)).decide(asked)[:, 0]
            steps.take()
    return scores


def curve_of(question: Question, scores: Floats) -> Curve:
    """The operating points of held-out scores (n,)."""
    asked = ~question.made
    return Curve(np.sort(scores[asked & ~question.yes]), np.sort(scores[asked & question.yes]))


def _worth(curve: Curve, most_false_alarms: float) -> tuple[float, float]:
    """The share found over few false alarms, and its standard error."""
    worth = curve.area(most_false_alarms)
    return worth, float(np.sqrt(worth * (1.0 - worth) / max(len(curve.off), 1)))


def best_of(tried: Sequence[Tried], questions: int) -> Choice:
    """For each preparation the best candidate of each question; then the better preparation.

    The first in the grid that is no more than one standard error worse than the best: with few
    failures the best is so by chance, and wiggly machines fare worse on scenes they never saw.
    """
    chosen: dict[bool, list[Tried]] = {}
    for by_size in (False, True):
        for question in range(questions):
            of_it = [one for one in tried if (one.question, one.by_size) == (question, by_size)]
            best = max(of_it, key=lambda one: one.worth)
            enough = best.worth - best.unsure
            chosen.setdefault(by_size, []).append(next(o for o in of_it if o.worth >= enough))
    total = {by_size: sum(one.worth for one in best[:PARTS]) for by_size, best in chosen.items()}
    by_size = total[True] >= total[False]
    return Choice(by_size, tuple(one.candidate for one in chosen[by_size]))
