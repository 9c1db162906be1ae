"""The shapes of particle clouds."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from tracking.filtering import cloud_shapes


def even(people: int, count: int) -> np.ndarray:
    return np.full((people, count), 1 / count, np.float32)


def bells(seed: int, people: int = 4, count: int = 500) -> np.ndarray:
    return np.random.default_rng(seed).normal(size=(people, count, 2)).astype(np.float32)


@given(st.integers(0, 2**32 - 1))
def test_the_spread_is_the_longest_axis_of_the_weighted_covariance(seed: int) -> None:
    random = np.random.default_rng(seed)
    particles = (bells(seed) @ random.normal(size=(2, 2)) + random.normal(size=2)).astype("f4")
    weights = random.random((4, 500)).astype(np.float32)
    weights /= weights.sum(axis=1, keepdims=True)
    spread, _ = cloud_shapes(particles, weights)
    for person in range(4):
        covariance = np.cov(particles[person].T, aweights=weights[person], ddof=0)
        largest = np.sqrt(np.linalg.eigvalsh(covariance)[-1])
        np.testing.assert_allclose(spread[person], largest, rtol=1e-3)


def test_one_cloud_is_not_split() -> None:
    assert cloud_shapes(bells(3101), even(4, 500))[1].max() == 0.0


def test_clouds_apart_are_the_more_split_the_farther_they_are() -> None:
    cloud = bells(3102, people=1) * 0.1
    splits = []
    for apart in (0.3, 0.6, 2.0):
        both = np.concatenate((cloud[:, :200], cloud[:, 200:] + np.float32([apart, 0])), axis=1)
        splits.append(float(cloud_shapes(both, even(1, 500))[1][0]))
    assert splits == sorted(splits)
    assert splits[0] < 0.3 < 0.9 < splits[-1]


def test_what_weighs_nothing_splits_nothing() -> None:
    both = bells(3103, people=1) * np.float32(0.1)
    both[:, 250:] += 5.0
    weights = even(1, 500).copy()
    weights[:, 250:] = 0.0
    weights *= 2
    spread, split = cloud_shapes(both, weights)
    assert spread[0] < 0.2
    assert split[0] == 0.0


def test_all_particles_in_one_place_have_no_shape() -> None:
    spread, split = cloud_shapes(np.ones((1, 50, 2), np.float32), even(1, 50))
    assert spread[0] < 1e-6
    assert split[0] == 0.0


def test_nobody_has_no_shapes() -> None:
    spread, split = cloud_shapes(np.zeros((0, 500, 2), np.float32), even(0, 500))
    assert spread.shape == split.shape == (0,)


def test_each_person_is_told_alike_alone_and_among_others() -> None:
    particles, weights = bells(3104), even(4, 500)
    together = cloud_shapes(particles, weights)
    for person in range(4):
        alone = cloud_shapes(particles[person : person + 1], weights[person : person + 1])
        assert [column[0] for column in alone] == [column[person] for column in together]
