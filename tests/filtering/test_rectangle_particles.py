"""Particles that are rectangles in the picture, as many as each target needs."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tracking.filtering import (
    Clouds,
    drifted,
    entropies,
    joined_clouds,
    mean_states,
    no_clouds,
    particle_counts,
    redrawn,
    restarted,
    scattered,
    weighed_by,
)

counts = st.lists(st.integers(1, 40), min_size=1, max_size=5)


def clouds_of(count: list[int], seed: int = 4100) -> Clouds:
    random = np.random.default_rng(seed)
    state = np.tile((50.0, 60.0, 10.0, 20.0, 3.0, -2.0), (len(count), 1, 1))
    state[:, 0, 0] += 100.0 * np.arange(len(count))
    return scattered(state, np.full(state.shape, 2.0), np.array(count), random)


def test_particles_scatter_round_their_state_and_are_never_empty():
    clouds = clouds_of([4000])
    np.testing.assert_allclose(mean_states(clouds)[0, 0], (50, 60, 10, 20, 3, -2), atol=0.2)
    wide = scattered(
        np.full((1, 1, 6), 3.0), np.full((1, 1, 6), 9.0), np.array([50]), np.random.default_rng(1)
    )
    assert (wide.state[..., 2:4] >= 3.0).all()


def test_a_drift_moves_centres_by_their_velocity_and_nothing_else():
    clouds = clouds_of([5, 7])
    moved = drifted(clouds, 0.5, np.zeros((2, 1, 6)), np.random.default_rng(0))
    np.testing.assert_allclose(
        moved.state[..., :2] - clouds.state[..., :2], clouds.state[..., 4:] / 2, atol=1e-4
    )
    np.testing.assert_array_equal(moved.state[..., 2:], clouds.state[..., 2:])


@given(counts, st.integers(0, 2**32 - 1))
@settings(deadline=None, max_examples=40)
def test_weights_sum_to_one_for_every_target_however_unlikely_all_are(count, seed):
    log = np.random.default_rng(seed).normal(-4000.0, 300.0, sum(count))
    weighed = weighed_by(clouds_of(count), log)
    total = np.add.reduceat(weighed.weight.astype(np.float64), weighed.start[:-1])
    np.testing.assert_allclose(total, 1.0, rtol=1e-5)


@given(counts, st.data())
@settings(deadline=None, max_examples=40)
def test_redrawing_gives_every_target_its_number_of_its_own_particles(count, data):
    clouds = clouds_of(count)
    weighed = weighed_by(clouds, np.random.default_rng(1).normal(0, 2, sum(count)))
    wanted = np.array([data.draw(st.integers(1, 60)) for _ in count])
    drawn = redrawn(weighed, wanted, np.random.default_rng(2))
    assert drawn.count.tolist() == wanted.tolist()
    for target in range(len(count)):
        own = weighed.state[weighed.start[target] : weighed.start[target + 1], 0, 0]
        new = drawn.state[drawn.start[target] : drawn.start[target + 1], 0, 0]
        assert np.isin(new, own).all()


def test_a_particle_is_redrawn_as_often_as_it_weighs():
    clouds = clouds_of([4])
    weighed = clouds.weighed(np.array([0.5, 0.25, 0.25, 0.0], np.float32))
    drawn = redrawn(weighed, np.array([400]), np.random.default_rng(0))
    times = [(drawn.state[:, 0, 0] == clouds.state[k, 0, 0]).sum() for k in range(4)]
    np.testing.assert_allclose(times, (200, 100, 100, 0), atol=1)


def test_entropy_is_one_where_all_weigh_alike_and_nought_where_one_has_all():
    clouds = clouds_of([50, 50])
    log = np.zeros(100)
    log[50] = 1e4
    np.testing.assert_allclose(entropies(weighed_by(clouds, log)), (1.0, 0.0), atol=1e-6)


@pytest.mark.parametrize(
    ("entropy", "expected"), [(1.0, 600), (0.5, 300), (0.1, 200), (5.0 / 3, 1000)]
)
def test_the_next_number_follows_the_entropy_between_its_limits(entropy, expected):
    # N_t = 1.2 * 500 * entropy, the entropy over that of equal weights [ZhaoLee2009, eq. 2]
    count = particle_counts(np.array([500]), np.array([entropy]), 1.2, 200, 1000)
    assert count.tolist() == [expected]


def test_targets_are_chosen_and_joined_with_their_particles():
    clouds = clouds_of([3, 5, 2])
    chosen = clouds.select(np.array([2, 0]))
    assert chosen.count.tolist() == [2, 3]
    np.testing.assert_array_equal(chosen.state[:2], clouds.state[8:])
    back = joined_clouds(chosen, clouds.select(np.array([1])))
    assert back.count.tolist() == [2, 3, 5]
    assert joined_clouds(no_clouds(1), clouds).count.tolist() == [3, 5, 2]
    assert len(mean_states(no_clouds(1))) == len(entropies(no_clouds(1))) == 0


def test_a_restart_scatters_the_chosen_rectangles_only():
    random = np.random.default_rng(4100)
    state = np.full((2, 3, 6), 40.0)
    clouds = scattered(state, np.ones(state.shape), np.array([30, 30]), random)
    clouds = weighed_by(clouds, random.normal(0, 1, 60))
    which = np.array([[False, True, False], [True, True, True]])
    new = restarted(clouds, which, np.full(state.shape, 200.0), np.ones(state.shape), random)
    moved = np.abs(new.state[..., 0] - clouds.state[..., 0]) > 100
    assert moved[:30].all(axis=0).tolist() == [False, True, False]
    assert moved[30:].all()
    np.testing.assert_array_equal(new.weight[:30], clouds.weight[:30])
    np.testing.assert_allclose(new.weight[30:], 1 / 30)
