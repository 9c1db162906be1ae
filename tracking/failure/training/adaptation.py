"""A detector adapted to other footage: its machines mixed with machines that learnt there.

Five people's labels show few failures of a part. A machine that learns from those alone is good by
luck; one that ignores them knows nothing of the camera. So each part's machine is a mixture of the
one there was and of one that learnt from the labels, with the same kernel, and how much of each is
chosen by people who were held out. None of the new one is among the choices: what is kept is never
worse on them than what there was.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.failure.core.detector import Detector
from tracking.failure.core.machines import Machine, Machines
from tracking.failure.training.questions import Question
from tracking.failure.training.search import Tried, curve_of
from tracking.failure.training.steps import Steps
from tracking.failure.training.svm_fit import Candidate, fitted

_COSTS = (1.0, 10.0)
_SHARES = (1 / 3, 2 / 3, 1.0)


@dataclass(frozen=True, slots=True, order=True)
class Blend:
    """How much of a mixture learnt from the labels.

    Attributes:
        share: of the machine that did; 0: the machine there was.
        cost: of a sample on the wrong side.
    """

    share: float
    cost: float

    def __str__(self) -> str:
        """As a report and a detector file name it."""
        return f"{self.share:.0%} from these labels, C {self.cost:g}" if self.share else KEPT


KEPT = "as built in"
BLENDS = (Blend(0.0, 0.0), *(Blend(share, cost) for share in _SHARES for cost in _COSTS))


@dataclass(frozen=True, slots=True, eq=False)
class Adapted:
    """A machine after adaptation.

    Attributes:
        machine: that answers the question now. blend: what it is made of.
        scores: (n,) of each sample by machines that never saw its person; NaN of those made.
        before: (n,) by the machine there was.
        tried: each mixture and its worth, the area under its curve.
    """

    machine: Machine
    blend: Blend
    scores: Floats
    before: Floats
    tried: tuple[Tried, ...]


def adapted(question: Question, folds: NDArray[np.int64], base: Detector, steps: Steps) -> Adapted:
    """The best mixture for a question, by people held out; the machine there was on a tie.

    Args:
        folds: (people,) of each person.
    """
    machine = base.machines.each[question.number]
    values = base.preparation.of(question.features)
    before = Machines((machine,)).decide(values)[:, 0]
    before[question.made] = np.nan
    held = {cost: _held_out(question, values, folds, machine, cost, steps) for cost in _COSTS}
    scores = {blend: _mixed(before, held, blend) for blend in BLENDS}
    tried = tuple(
        Tried(question.number, base.preparation.by_size, blend, curve_of(question, one).area())
        for blend, one in scores.items()
    )
    best = _chosen([one.worth for one in tried], int(question.asked().yes.sum()))
    own = machine
    if best.share:
        new = fitted(values, question.yes, _candidate(machine, best.cost))
        own = mixture(machine, new, best.share)
    steps.take()
    return Adapted(own, best, scores[best], before, tried)


def _chosen(worth: Sequence[float], failures: int) -> Blend:
    """The mixture with least of what is new among those that are as good as the best.

    None of it where nothing is better than the machine there was. As good: no more than one
    standard error worse, of as many failures as there were. With ten of them the best is so by
    chance, and whoever learns much from ten fares worse with everybody else.
    """
    best = max(worth)
    if best <= worth[0]:
        return BLENDS[0]
    enough = best - float(np.sqrt(best * (1.0 - best) / max(failures, 1)))
    return next(
        blend
        for blend, own in zip(BLENDS[1:], worth[1:], strict=True)
        if own >= enough and own > worth[0]
    )


def unchanged(question: Question, base: Detector) -> Adapted:
    """The machine there was, for a question that too few samples answer."""
    machine = base.machines.each[question.number]
    scores = Machines((machine,)).decide(base.preparation.of(question.features))[:, 0]
    return Adapted(machine, BLENDS[0], scores, scores, ())


def steps_of(questions: Sequence[Question], folds: int) -> int:
    """How many steps the adaptation to so many questions takes."""
    return len(questions) * (folds * len(_COSTS) + 1)


def mixture(there_was: Machine, new: Machine, share: float) -> Machine:
    """One machine that says what two of the same kernel say together; `share` of the new one."""
    rest = 1.0 - share
    return Machine(
        np.concatenate((there_was.support, new.support)) if rest else new.support,
        np.concatenate((rest * there_was.coefficient, share * new.coefficient))
        if rest
        else new.coefficient,
        rest * there_was.intercept + share * new.intercept,
        there_was.gamma,
    )


def _candidate(machine: Machine, cost: float) -> Candidate:
    """Parameters with the kernel that a machine has."""
    return Candidate(cost, machine.gamma * machine.support.shape[1])


def _held_out(
    question: Question,
    values: Floats,
    folds: NDArray[np.int64],
    machine: Machine,
    cost: float,
    steps: Steps,
) -> Floats:
    """(n,) scores by new machines that never saw the person; NaN where there is none.

    Nobody can learn from others who all answer alike.
    """
    fold = folds[question.people]
    scores = np.full(len(question), np.nan)
    for held in range(int(folds.max()) + 1):
        inside, outside = fold != held, (fold == held) & ~question.made
        answers = question.yes[inside & ~question.made]
        if outside.any() and answers.any() and not answers.all():
            new = fitted(values[inside], question.yes[inside], _candidate(machine, cost))
            scores[outside] = Machines((new,)).decide(values[outside])[:, 0]
        steps.take()
    return scores


def _mixed(before: Floats, held: dict[float, Floats], blend: Blend) -> Floats:
    """(n,) scores of a mixture; of the machine there was where nobody else can be asked."""
    if not blend.share:
        return before
    mixed = (1.0 - blend.share) * before + blend.share * held[blend.cost]
    return np.where(np.isfinite(mixed), mixed, before)
