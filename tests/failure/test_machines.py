"""Machines as arrays say what the library they come from says."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sklearn.svm import SVC

from tracking.failure import Machines
from tracking.failure.training.svm_fit import Candidate, fitted


def _fit(random: np.random.Generator, rows: int, numbers: int, candidate: Candidate):
    values = random.normal(size=(rows, numbers))
    failed = values[:, 0] + 0.5 * values[:, 1] ** 2 + random.normal(0, 0.3, rows) > 0.5
    failed[:2] = True, False
    gamma = candidate.gamma / numbers
    kernel = {"kernel": "rbf", "gamma": gamma} if gamma else {"kernel": "linear"}
    library = SVC(C=candidate.cost, class_weight="balanced", **kernel).fit(values, failed)
    return library, fitted(values, failed, candidate)


@settings(max_examples=15, deadline=None)
@given(
    seed=st.integers(0, 2**32),
    rows=st.integers(6, 120),
    numbers=st.sampled_from([2, 36, 37]),
    kinds=st.lists(st.sampled_from([0.0, 0.1, 1.0, 3.0]), min_size=1, max_size=4),
    cost=st.sampled_from([0.1, 1.0, 100.0]),
)
def test_decisions_equal_the_librarys(
    seed: int, rows: int, numbers: int, kinds: list[float], cost: float
) -> None:
    random = np.random.default_rng(seed)
    each = [_fit(random, rows, numbers, Candidate(cost, gamma)) for gamma in kinds]
    asked = random.normal(0, 2, (15, numbers))
    ours = Machines(tuple(machine for _, machine in each)).decide(asked)
    theirs = np.stack([library.decision_function(asked) for library, _ in each], axis=1)
    assert np.abs(ours - theirs).max() < 1e-10


def test_one_row_is_decided_as_among_many() -> None:
    random = np.random.default_rng(4)
    machines = Machines((_fit(random, 80, 36, Candidate(10, 1))[1],))
    asked = random.normal(size=(200, 36))
    alone = np.concatenate([machines.decide(row[None]) for row in asked])
    assert np.allclose(machines.decide(asked), alone, rtol=0, atol=1e-12)


def test_nobody_gets_no_decision() -> None:
    machines = Machines((_fit(np.random.default_rng(4), 80, 36, Candidate(10, 1))[1],))
    assert machines.decide(np.zeros((0, 36))).shape == (0, 1)


@pytest.mark.parametrize("gamma", [0.0, 1.0])
def test_a_number_that_is_none_gives_none(gamma: float) -> None:
    machines = Machines((_fit(np.random.default_rng(4), 80, 36, Candidate(10, gamma))[1],))
    asked = np.zeros((2, 36))
    asked[1, 5] = np.nan
    decided = machines.decide(asked)[:, 0]
    assert np.isnan(decided).tolist() == [False, True]
