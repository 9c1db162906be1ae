"""Folds split by person, never by frame: frames that follow each other are nearly one sample."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from tracking.errors import TrainingError
from tracking.failure.training.questions import Question

_TRIES = 50


def folds_of(
    questions: Sequence[Question], most: int, random: np.random.Generator
) -> NDArray[np.int64]:
    """A fold for each person of a recording, from 0 on; -1 for those who answer no question.

    The answers to every question are spread as evenly as whole people allow, and what is left
    when any fold is held out answers each question both ways.

    Args:
        most: folds at most; fewer where one of the answers comes from fewer people.

    Raises TrainingError where no such folds are found.
    """
    answers = _answers(questions)
    count = max(2, min(most, int((answers > 0).sum(axis=0).min())))
    for _ in range(_TRIES):
        folds = _spread(answers, count, random)
        held = np.stack([answers[folds == fold].sum(axis=0) for fold in range(count)])
        if bool((answers.sum(axis=0) > held).all()):
            return folds
    raise TrainingError("the samples of one answer are nearly all of one person; label more people")


def folds_of_few(
    questions: Sequence[Question], most: int, random: np.random.Generator
) -> NDArray[np.int64]:
    """The same where what is left need not answer everything: a fold a person, at most so many."""
    answers = _answers(questions)
    count = max(2, min(most, int((answers > 0).any(axis=1).sum())))
    return _spread(answers, count, random)


def _answers(questions: Sequence[Question]) -> NDArray[np.int64]:
    """(people, answers) how often each person gives each answer to each question."""
    people = 1 + max(int(question.people.max(initial=-1)) for question in questions)
    return np.stack(
        [
            np.bincount(question.people[question.yes == yes], minlength=people)
            for question in questions
            for yes in (False, True)
        ],
        axis=1,
    )


def _spread(
    answers: NDArray[np.int64], count: int, random: np.random.Generator
) -> NDArray[np.int64]:
    """(p,) each person, those with most samples first, into the fold that lacks them most."""
    folds = np.full(len(answers), -1)
    shares = answers / np.maximum(answers.sum(axis=0), 1)
    held = np.zeros((count, answers.shape[1]))
    shuffled = random.permutation(len(answers))
    for person in shuffled[np.argsort(-shares[shuffled].max(axis=1), kind="stable")]:
        if answers[person].any():
            uneven = ((held + shares[person]) ** 2 - held**2).sum(axis=1)
            fold = int(np.argmin(uneven))
            folds[person], held[fold] = fold, held[fold] + shares[person]
    return folds


def thinned(question: Question, most: int, random: np.random.Generator) -> Question:
    """At most so many samples, half of each answer where there are enough, spread over people."""
    if len(question) <= most:
        return question
    yes = int(question.yes.sum())
    kept_yes = min(yes, max(most // 2, most - (len(question) - yes)))
    chosen = [
        _some_of(np.flatnonzero(question.yes == answer), kept, question, random)
        for answer, kept in ((True, kept_yes), (False, most - kept_yes))
    ]
    return question.of(np.sort(np.concatenate(chosen)))


def _some_of(
    rows: NDArray[np.int64], kept: int, question: Question, random: np.random.Generator
) -> NDArray[np.int64]:
    """Rows taken from the people in turn, until there are enough."""
    shuffled = random.permutation(rows)
    people = question.people[shuffled]
    order = np.argsort(people, kind="stable")
    first = np.searchsorted(people[order], people[order])
    turn = np.empty(len(rows), np.int64)
    turn[order] = np.arange(len(rows)) - first
    return shuffled[np.argsort(turn, kind="stable")[:kept]]
