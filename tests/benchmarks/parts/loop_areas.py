"""How well detectors tell lost parts of people nobody labelled, with how far chance may move it.

Everybody is drawn into groups of so many people. Each group is labelled once and teaches a
detector, which is asked about everybody else; so each figure is the mean over groups of areas under
the curve of people held out. Its 95 % interval is by bootstrap over people, as what is seen of one
person is nearly one sample.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.errors import TrainingError
from tracking.failure import Detector, Samples, TrainingPlan, built_in_detector, train
from tracking.tracks import PARTS

Area = tuple[float, float, float]
"""The mean and both ends of its interval."""

DETECTORS = ("paper", "built in", "taught")
_ROUNDS = 3
"""How often everybody is drawn into groups."""
_BOOTSTRAPS = 400
_LEAST = 3
"""Samples of each answer among people held out, below which a group says nothing."""


@dataclass(frozen=True, slots=True, eq=False)
class _Comparison:
    """Pairs of samples of one part, one off it and one on it; of people held out.

    Attributes:
        off, on: (n,), (m,) their people.
        ranked: (detectors, n, m) 1 where the one off its part has the higher score, 0.5 equal.
    """

    off: NDArray[np.int64]
    on: NDArray[np.int64]
    ranked: Floats

    def areas(self, drawn: NDArray[np.int64]) -> Floats:
        """(detectors,) under the curves, each person counted as often as `drawn` (people,)."""
        off, on = drawn[self.off].astype(float), drawn[self.on].astype(float)
        pairs = off.sum() * on.sum()
        if not pairs:
            return np.full(len(self.ranked), np.nan)
        found: Floats = np.einsum("n,dnm,m->d", off, self.ranked, on, optimize=True) / pairs
        return found


def areas_held_out(samples: Samples, group: int, seed: int) -> list[dict[str, Area] | None]:
    """Of each part the area of each detector and what teaching gains; None where too few are lost.

    Args:
        group: how many people are labelled.
    """
    random = np.random.default_rng(seed)
    compared: list[list[_Comparison]] = [[] for _ in range(PARTS)]
    people = samples.people()
    for labelled in _groups(int(people.max(initial=-1)) + 1, group, random):
        own = np.isin(people, labelled)
        taught = _taught(samples[own], random)
        if taught is None:
            continue
        for part in range(PARTS):
            one = _compared(samples, people, ~own & (samples.columns["part"] == part), part, taught)
            compared[part] += [one] if one is not None else []
    count = int(people.max(initial=-1)) + 1
    return [_told(several, count, random) if several else None for several in compared]


def _groups(people: int, group: int, random: np.random.Generator) -> Iterator[NDArray[np.int64]]:
    """Everybody in groups of so many, a few times; who is left over is not labelled then."""
    for _ in range(_ROUNDS):
        order = random.permutation(people)
        for start in range(0, people - group + 1, group):
            yield order[start : start + group]


def _taught(samples: Samples, random: np.random.Generator) -> Detector | None:
    """The built-in detector taught by labels; None where these are too few for any part."""
    try:
        return train(samples, TrainingPlan(adapt=built_in_detector), random=random).detector
    except TrainingError:
        return None


def _compared(
    samples: Samples,
    people: NDArray[np.int64],
    asked: NDArray[np.bool_],
    part: int,
    taught: Detector,
) -> _Comparison | None:
    """What all detectors say of a part of people held out, where each of them can judge."""
    every = (built_in_detector(paper=True), built_in_detector(), taught)
    rows = np.flatnonzero(asked & samples.has_evidence)
    score = np.stack([one.judge(samples.features[rows]).score[:, part] for one in every])
    lost = samples.columns["label"][rows] == 0
    if min(lost.sum(), (~lost).sum()) < _LEAST:
        return None
    off, on = score[:, lost, None], score[:, None, ~lost]
    ranked = (off > on) + 0.5 * (off == on)
    return _Comparison(people[rows[lost]], people[rows[~lost]], ranked)


def _told(
    compared: Sequence[_Comparison], people: int, random: np.random.Generator
) -> dict[str, Area]:
    """The mean over groups, with the interval by people drawn anew."""
    drawn = [np.ones(people, np.int64)]
    drawn += [
        np.bincount(random.integers(0, people, people), minlength=people)
        for _ in range(_BOOTSTRAPS)
    ]
    each = np.array([_mean(np.array([one.areas(who) for one in compared])) for who in drawn])
    each = np.column_stack((each, each[:, -1] - each[:, -2]))
    low, high = np.nanquantile(each[1:], (0.025, 0.975), axis=0)
    return {
        name: (round(float(mean), 3), round(float(below), 3), round(float(above), 3))
        for name, mean, below, above in zip((*DETECTORS, "gain"), each[0], low, high, strict=True)
    }


def _mean(areas: Floats) -> Floats:
    """(detectors,) over the groups (n, detectors) of whom anybody drawn lost the part."""
    known = areas[np.isfinite(areas).all(axis=1)]
    return np.asarray(known.mean(axis=0)) if len(known) else np.full(areas.shape[1], np.nan)
