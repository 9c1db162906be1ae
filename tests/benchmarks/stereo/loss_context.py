"""Where and behind whom a person was when its track went wrong."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tests.benchmarks.stereo.truth import Floats, Integers, Truth

HIDDEN_BY_PERSON = "behind somebody"
HIDDEN_BY_THINGS = "behind a thing"
AT_EDGE = "at the image edge"
CLOSE = "beside somebody"
OPEN = "in the open"
WHERE = (HIDDEN_BY_PERSON, HIDDEN_BY_THINGS, AT_EDGE, CLOSE, OPEN)

_HIDDEN = 0.7  # share seen below which something must be in the way
_COVERED = 0.15  # of the box; boxes are larger than bodies, so little of them says little
_OUTSIDE = 0.15
_CLOSE_M = 1.0


@dataclass(frozen=True, slots=True)
class LossContext:
    """Of a moment, as the truth has it.

    Attributes:
        where: one of `WHERE`.
        neighbour: who was in front or beside; 0: nobody.
        share: the least that was seen of the person, 0 to 1.
    """

    where: str
    neighbour: int
    share: float


def loss_context(truth: Truth, person: int, first: int, last: int) -> LossContext:
    """What is in a person's way within frames, both included, when least of it is seen."""
    rows = truth.of(person, first, last)
    if not len(rows):
        rows = _nearest_rows(truth, person, first)
    row = int(rows[np.argmin(truth.share[rows])])
    gone = len(rows) < last - first + 1 and _walks_on(truth, person, last)
    share = 0.0 if gone else float(truth.share[row])
    if share < _HIDDEN:
        front, covered = _in_front(truth, row)
        outside = _outside(truth, row)
        if outside >= max(_OUTSIDE, covered):
            return LossContext(AT_EDGE, 0, share)
        if covered >= _COVERED:
            return LossContext(HIDDEN_BY_PERSON, front, share)
        return LossContext(HIDDEN_BY_THINGS, 0, share)
    neighbour, apart_m = _nearest(truth, rows)
    if apart_m <= _CLOSE_M:
        return LossContext(CLOSE, neighbour, share)
    return LossContext(OPEN, 0, share)


def _nearest_rows(truth: Truth, person: int, frame: int) -> Integers:
    own = np.flatnonzero(truth.person == person)
    return own[[np.argmin(np.abs(truth.frame[own] - frame))]]


def _walks_on(truth: Truth, person: int, frame: int) -> bool:
    """Whether somebody without rows was hidden altogether, and did not leave."""
    return bool((truth.frame[truth.person == person] >= frame).any())


def _in_front(truth: Truth, row: int) -> tuple[int, float]:
    """Who nearer to the camera covers most of a person's box, and what share of it."""
    away = np.hypot(*truth.place.T)
    others = truth.beside(row)
    others = others[away[others] < away[row]]
    if not len(others):
        return 0, 0.0
    covered = _overlaps(truth.box[others], truth.box[row]) / max(_area(truth.box[row]), 1e-9)
    most = int(np.argmax(covered))
    return int(truth.person[others[most]]), float(covered[most])


def _outside(truth: Truth, row: int) -> float:
    """Share of a person's box that is out of the picture."""
    box = truth.box[row]
    picture = np.array([[0.0, 0.0, *truth.size]])
    return 1.0 - float(_overlaps(picture, box)[0]) / max(_area(box), 1e-9)


def _nearest(truth: Truth, rows: Integers) -> tuple[int, float]:
    """Who comes nearest to a person in some rows of its, and how near, in metres."""
    nearest, apart_m = 0, np.inf
    for row in rows.tolist():
        others = truth.beside(row)
        if len(others):
            distance = np.hypot(*(truth.place[others] - truth.place[row]).T)
            closest = int(np.argmin(distance))
            if distance[closest] < apart_m:
                nearest, apart_m = int(truth.person[others[closest]]), float(distance[closest])
    return nearest, apart_m


def _overlaps(boxes: Floats, box: Floats) -> Floats:
    """(n,) px² that boxes share with one."""
    low = np.maximum(boxes[:, :2], box[:2])
    high = np.minimum(boxes[:, :2] + boxes[:, 2:], box[:2] + box[2:])
    return np.asarray(np.prod(np.maximum(high - low, 0.0), axis=1))


def _area(box: Floats) -> float:
    return float(box[2] * box[3])
