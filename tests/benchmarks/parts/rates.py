"""Curves of how many people are still tracked rightly so many frames after their start."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tests.benchmarks.parts.judging import Bools, Floats, Judged
from tests.benchmarks.parts.truth import PARTS

SUBJECTS = (*PARTS, "person")
LAST_FRAME = 150


@dataclass(frozen=True, slots=True, eq=False)
class Rates:
    """Rates by frames since a person's start; row i is frame i, columns are `SUBJECTS`.

    Attributes:
        people: (k,) how many people are in view for so long.
        right: (k, 4) share of them that is right in that frame: the paper's curves, which rise
            again where a part comes back and where people leave.
        unbroken: (k, 4) share of them that was right in every frame until then.
        foreign: (3,) mean share of each part's rectangles that holds something else.
    """

    people: NDArray[np.int64]
    right: Floats
    unbroken: Floats
    foreign: Floats


def rates_of(judged: Sequence[Judged], last: int = LAST_FRAME) -> Rates:
    """The curves of all people of all clips."""
    people = np.zeros(last + 1, np.int64)
    right, unbroken = np.zeros((2, last + 1, len(SUBJECTS)))
    for person in judged:
        good = _good(person)[: last + 1]
        people[: len(good)] += 1
        right[: len(good)] += good
        unbroken[: len(good)] += np.logical_and.accumulate(good, axis=0)
    share = np.maximum(people, 1)[:, None]
    return Rates(people, right / share, unbroken / share, _mean_foreign(judged))


def margin(share: float, people: int) -> float:
    """Half the width of Wilson's 95 % interval of a share of so many people."""
    z = 1.96
    spread = np.sqrt(share * (1 - share) / people + z**2 / (4 * people**2))
    return float(z * spread / (1 + z**2 / people))


def _mean_foreign(judged: Sequence[Judged]) -> Floats:
    """Mean (3,) over all rectangles there are; NaN where there are none."""
    foreign = np.concatenate([np.zeros((0, len(PARTS))), *(one.foreign for one in judged)])
    there = np.isfinite(foreign)
    total, count = np.where(there, foreign, 0.0).sum(axis=0), there.sum(axis=0)
    return np.asarray(np.where(count, total / np.maximum(count, 1), np.nan))


def _good(person: Judged) -> Bools:
    return np.column_stack((person.parts, person.person_right))
