"""What a detector learns: is the head, the torso, the hip-leg lost; and one part or several."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.errors import TrainingError
from tracking.failure.core.samples import Samples
from tracking.tracks import PART_NAMES, PARTS
from tracking.translation import N_, Message, count_msg, joined, msg

NAMES = (*PART_NAMES, N_("several"))
SEVERAL = PARTS
LEAST_SAMPLES = 10
"""Of each answer to a question; fewer say nothing of people who were held out."""
LEAST_TO_ADAPT = 5
"""The same where a detector that there is can be kept."""
LEAST_PEOPLE = 2
"""For each answer: one is learnt from, the other one held out."""


@dataclass(frozen=True, slots=True, eq=False)
class Question:
    """One yes-or-no question and the samples that answer it; n rows.

    Attributes:
        number: place in `NAMES`.
        rows: (n,) of the samples.
        features: (n, 60). yes: (n,) part lost, or several lost. people: (n,) who, by number.
        made: (n,) learnt from and not measured on, see `gross`.
    """

    number: int
    rows: NDArray[np.int64]
    features: Floats
    yes: NDArray[np.bool_]
    people: NDArray[np.int64]
    made: NDArray[np.bool_]

    @property
    def name(self) -> str:
        """Of the part, or "several"."""
        return NAMES[self.number]

    def __len__(self) -> int:
        """How many samples answer it."""
        return len(self.rows)

    def of(self, rows: NDArray[np.int64]) -> Question:
        """The same with some of its rows."""
        features, yes, people = self.features[rows], self.yes[rows], self.people[rows]
        return Question(self.number, self.rows[rows], features, yes, people, self.made[rows])

    def asked(self) -> Question:
        """Without what was made."""
        return self.of(np.flatnonzero(~self.made))


def questions_of(samples: Samples, least: int = LEAST_SAMPLES) -> list[Question]:
    """The questions that samples can answer: the three parts, then one-or-several if possible.

    Raises TrainingError where parts have too few samples, of too few people; names them all.
    """
    *asked, several = all_questions(samples)
    short = [why for question in asked if (why := shortage(question, least))]
    if short:
        raise TrainingError(
            "{short}: add labels or sessions until each has at least {least} of {people} "
            "people or more{where_losses_are}",
            short=joined("; ", short),
            least=least,
            people=LEAST_PEOPLE,
            where_losses_are=_where_losses_are(asked, least),
        )
    return asked if shortage(several, least) else [*asked, several]


def _where_losses_are(asked: Sequence[Question], least: int) -> str:
    """How to come by parts that are lost, where there are too few; "" where there are enough."""
    if not any(int(question.yes.sum()) < least for question in asked):
        return ""
    return msg(
        "; a tracker that adjusts its parts seldom loses one: track several minutes of crowded "
        "footage with adjust=false"
    )


def all_questions(samples: Samples) -> list[Question]:
    """The four questions with whatever samples answer them, be it none."""
    people, part = samples.people(), samples.columns["part"]
    lost = samples.columns["label"] == 0
    asked = [
        _question(number, np.flatnonzero(part == number), samples, lost, people)
        for number in range(PARTS)
    ]
    return [*asked, one_or_several(samples, people)]


def one_or_several(samples: Samples, people: NDArray[np.int64]) -> Question:
    """Instants at which it is known whether one part was lost or several.

    Two labels off their part say several; one says one where the other two are known to be on
    theirs. Of an instant the features of the first label off its part are taken: those of a
    rectangle somebody put right belong to another state.
    """
    lost = samples.columns["label"] == 0
    which = samples.instants()
    off = np.zeros((int(which.max(initial=-1)) + 1, PARTS), bool)
    on = np.zeros_like(off)
    off[which[lost], samples.columns["part"][lost]] = True
    on[which[~lost], samples.columns["part"][~lost]] = True
    several = off.sum(axis=1) > 1
    one = (off.sum(axis=1) == 1) & ((on & ~off).sum(axis=1) == PARTS - 1)
    first = np.flatnonzero(lost)
    first = first[np.unique(which[first], return_index=True)[1]]
    rows = first[(several | one)[which[first]]]
    return _question(SEVERAL, rows, samples, several[which], people)


def _question(
    number: int,
    rows: NDArray[np.int64],
    samples: Samples,
    yes: NDArray[np.bool_],
    people: NDArray[np.int64],
) -> Question:
    """The question that some rows answer; yes and people are of all rows."""
    made = np.zeros(len(rows), bool)
    return Question(number, rows, samples.features[rows], yes[rows], people[rows], made)


def shortage(question: Question, least: int = LEAST_SAMPLES) -> Message:
    """Of which answers there are too few samples to learn it; "" where there are enough."""
    short = []
    for yes, side in ((True, msg("off the part")), (False, msg("on the part"))):
        chosen = question.yes == yes
        samples, people = int(chosen.sum()), len(np.unique(question.people[chosen]))
        if samples < least or people < LEAST_PEOPLE:
            few = count_msg(samples, "{n} sample {side}", "{n} samples {side}", side=side)
            who = count_msg(people, "{n} person", "{n} people")
            short.append(msg("{samples}, of {people}", samples=few, people=who))
    return (
        msg("{question}: {short}", question=msg(question.name), short=joined(" and ", short))
        if short
        else Message()
    )
