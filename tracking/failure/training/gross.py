"""Gross failures made from parts that were on their place: nobody need label those.

Trackers that are any good lose parts a little, and whoever labels finds few that went to the other
end of the picture. A kernel machine knows nothing out there and falls back to its constant, which
may say that all is well. So to learn from, and never to be measured on, states are made of labelled
ones by carrying a part away: it has failed then, and the others have not.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.failure.core.features import NUMBERS, PAPER_FEATURES
from tracking.failure.core.preparation import body_sizes
from tracking.failure.core.samples import Samples
from tracking.failure.training.questions import SEVERAL, Question
from tracking.tracks import PART_EVIDENCE, PARTS

_NEAREST, _FARTHEST = 0.5, 8.0
"""How far a part is carried, in sizes of the person."""
_SIZES_A_HEIGHT = 0.5
"""The size of a person, see `body_sizes`, in heights."""
_LEAST_ALIKE = 0.4
"""How alike colours of something else are at least, as a share of one's own."""
_LEAST, _MOST = 40, 400
"""Failures made of each kind; else as many as were labelled."""


def with_gross_failures(
    question: Question, samples: Samples, random: np.random.Generator
) -> Question:
    """The question with made answers of both kinds added, marked as made."""
    count = int(np.clip(question.yes.sum(), _LEAST, _MOST))
    if question.number == SEVERAL:
        rows = _whole_instants(samples)
        moved = [(2, True), (1, False)]
    else:
        rows = question.rows[~question.yes]
        moved = [(1, True), (1, False)]
    if not len(rows):
        return question
    made = [
        _made(question, samples, random.choice(rows, count), moves, answer, random)
        for moves, answer in moved
    ]
    return _joined([question, *made])


def _whole_instants(samples: Samples) -> NDArray[np.int64]:
    """A row of each instant in which all three parts are on their place."""
    on = np.flatnonzero(samples.columns["label"] == 1)
    _, first, which = np.unique(samples.instants()[on], return_index=True, return_inverse=True)
    parts = np.zeros((len(first), PARTS), bool)
    parts[which.reshape(-1), samples.columns["part"][on]] = True
    return on[first[parts.all(axis=1)]]


def _made(
    question: Question,
    samples: Samples,
    rows: NDArray[np.int64],
    moves: int,
    answer: bool,
    random: np.random.Generator,
) -> Question:
    """The states of some rows with parts carried away, as answers to a question."""
    features = samples.features[rows]
    order = np.argsort(random.random((len(rows), PARTS)), axis=1)
    if question.number != SEVERAL:
        # Of a part: it is carried away itself, or one of the other two is.
        own = np.full(len(rows), question.number)
        other = (own + random.integers(1, PARTS, len(rows))) % PARTS
        order[:, 0] = own if answer else other
    for turn in range(moves):
        features = carried_away(features, order[:, turn], random)
    people = samples.people()[rows]
    yes = np.full(len(rows), answer)
    return Question(question.number, rows, features, yes, people, np.ones(len(rows), bool))


def carried_away(features: Floats, part: NDArray[np.int64], random: np.random.Generator) -> Floats:
    """Features (n, 60) with one part (n,) of each elsewhere: just now, or for a while already."""
    count = len(features)
    size = body_sizes(features)
    far = size * np.exp(random.uniform(np.log(_NEAREST), np.log(_FARTHEST), count))
    way = random.uniform(0, 2 * np.pi, count)
    shift = far[:, None] * np.column_stack((np.cos(way), np.sin(way)))
    # The mean of the three goes along by a third.
    share = np.eye(PARTS)[part] - 1 / PARTS
    paper, evidence = np.split(features, [PAPER_FEATURES], axis=1)
    moved = paper.reshape(count, PAPER_FEATURES // NUMBERS // PARTS, PARTS, NUMBERS).copy()
    moved[:, 0, :, :2] += share[..., None] * shift[:, None]
    just_now = random.random(count) < 0.5
    moved[just_now, 1, :, :2] += (share[..., None] * shift[:, None])[just_now]
    evidence = _nowhere(evidence, part, far * _SIZES_A_HEIGHT / size, random)
    return np.concatenate((moved.reshape(count, PAPER_FEATURES), evidence), axis=1)


def _nowhere(
    evidence: Floats, part: NDArray[np.int64], far: Floats, random: np.random.Generator
) -> Floats:
    """Evidence (n, 24) with one part (n,) of each carried so far (n,), in heights: off everything.

    Nothing of the person is where it went, its colours are some others, and the other two parts
    are off by half as much, since it takes part in saying where they should be.
    """
    count = len(evidence)
    changed = evidence.reshape(count, PARTS, len(PART_EVIDENCE)).copy()
    rows = np.arange(count)
    for name in ("support", "above", "below", "beside"):
        changed[rows, part, PART_EVIDENCE.index(name)] = 0.0
    other = random.uniform(_LEAST_ALIKE, 1.0, count)
    likeness, change = (PART_EVIDENCE.index(name) for name in ("likeness", "change"))
    changed[rows, part, change] -= changed[rows, part, likeness] * (1.0 - other)
    changed[rows, part, likeness] *= other
    share = np.where(np.arange(PARTS) == part[:, None], 1.0, 0.5)
    offset = PART_EVIDENCE.index("offset")
    changed[..., offset] = np.maximum(changed[..., offset], share * far[:, None])
    return np.where(np.isnan(evidence), np.nan, changed.reshape(evidence.shape))


def _joined(each: list[Question]) -> Question:
    return Question(
        each[0].number,
        np.concatenate([one.rows for one in each]),
        np.concatenate([one.features for one in each]),
        np.concatenate([one.yes for one in each]),
        np.concatenate([one.people for one in each]),
        np.concatenate([one.made for one in each]),
    )
