import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from tracking.filtering import (
    effective_share,
    likelihood,
    move,
    resample,
    scatter,
    weigh,
    weighted_mean,
)

SEEDS = st.integers(0, 2**32 - 1)
PEOPLE = st.integers(0, 6)


def cloud(seed: int, people: int = 4, count: int = 50) -> np.ndarray:
    return np.random.default_rng(seed).normal(size=(people, count, 2)).astype(np.float32)


@given(SEEDS, PEOPLE, st.floats(0.01, 5.0), st.floats(0.0, 100.0))
def test_weights_of_each_person_sum_to_one(seed, people, sigma, away):
    weights = weigh(cloud(seed, people), np.full((people, 2), away), np.full(people, sigma))
    np.testing.assert_allclose(weights.sum(axis=1), 1.0, rtol=1e-5)


def test_weights_are_the_normalised_likelihood():
    particles, measured, sigma = cloud(1), np.zeros((4, 2)), np.array([0.5, 1.0, 2.0, 3.0])
    expected = likelihood(np.linalg.norm(particles, axis=2).astype(float), sigma)
    expected /= expected.sum(axis=1, keepdims=True)
    np.testing.assert_allclose(weigh(particles, measured, sigma), expected, rtol=1e-4)


def test_likelihood_is_the_papers_gaussian():
    at = likelihood(np.array([[0.0, 0.3]]), np.array([0.3]))
    peak = 1.0 / (np.sqrt(2.0 * np.pi) * 0.3)
    np.testing.assert_allclose(at, [[peak, peak * np.exp(-0.5)]])


@given(SEEDS, PEOPLE)
def test_resampling_copies_each_particle_its_share_rounded_up_or_down(seed, people):
    random = np.random.default_rng(seed)
    weights = random.random((people, 30)).astype(np.float32) ** 4
    weights /= weights.sum(axis=1, keepdims=True)
    numbered = np.broadcast_to(np.arange(30.0, dtype=np.float32)[:, None], (people, 30, 2))
    taken = resample(np.ascontiguousarray(numbered), weights, random)[..., 0].astype(int)
    for person in range(people):
        copies = np.bincount(taken[person], minlength=30)
        assert np.abs(copies - 30 * weights[person]).max() < 1.0 + 1e-3


def test_resampling_is_unbiased():
    random = np.random.default_rng(5)
    weights = np.array([[0.55, 0.27, 0.13, 0.05]], np.float32)
    numbered = np.arange(4, dtype=np.float32)[None, :, None].repeat(2, axis=2)
    draws = np.concatenate([resample(numbered, weights, random)[0, :, 0] for _ in range(4000)])
    shares = np.bincount(draws.astype(int), minlength=4) / len(draws)
    np.testing.assert_allclose(shares, weights[0], atol=0.01)


def test_resampling_keeps_a_person_whose_whole_weight_is_one_particle():
    weights = np.zeros((1, 10), np.float32)
    weights[0, 7] = 1.0
    particles = cloud(2, 1, 10)
    resampled = resample(particles, weights, np.random.default_rng(0))
    assert (resampled == particles[0, 7]).all()


@given(st.permutations(range(4)))
def test_weighing_does_not_depend_on_the_order_of_people(order):
    particles, sigma = cloud(3), np.array([0.2, 0.4, 0.6, 0.8])
    measured = np.arange(8.0).reshape(4, 2)
    weights = weigh(particles, measured, sigma)
    shuffled = weigh(particles[order], measured[order], sigma[order])
    np.testing.assert_array_equal(shuffled, weights[order])
    mean = weighted_mean(particles, weights)
    np.testing.assert_array_equal(weighted_mean(particles[order], shuffled), mean[order])


def test_moving_adds_the_step_and_the_asked_spread():
    start = np.zeros((2, 20000, 2), np.float32)
    step, spread = np.array([[1.0, 2.0], [-3.0, 0.5]]), np.array([0.1, 0.4])
    moved = move(start, step, spread, np.random.default_rng(0))
    np.testing.assert_allclose(moved.mean(axis=1), step, atol=0.02)
    np.testing.assert_allclose(moved.std(axis=1), spread[:, None].repeat(2, 1), rtol=0.03)


def test_the_same_seed_scatters_the_same_particles():
    centre, spread = np.array([[1.0, 2.0]]), np.array([0.3])
    one, two = (scatter(centre, spread, 100, np.random.default_rng(9)) for _ in range(2))
    assert one.tobytes() == two.tobytes()


def test_effective_share_is_one_for_even_weights_and_one_nth_for_a_single_one():
    weights = np.array([[0.25, 0.25, 0.25, 0.25], [1.0, 0.0, 0.0, 0.0]], np.float32)
    np.testing.assert_allclose(effective_share(weights), [1.0, 0.25])


def test_the_filter_comes_to_rest_on_a_measurement_that_repeats():
    random = np.random.default_rng(1)
    particles = scatter(np.array([[0.0, 0.0]]), np.array([0.5]), 500, random)
    measured, sigma = np.array([[0.4, -0.3]]), np.array([0.1])
    for _ in range(10):
        particles = move(particles, np.zeros((1, 2)), np.array([0.02]), random)
        weights = weigh(particles, measured, sigma)
        particles = resample(particles, weights, random)
    np.testing.assert_allclose(particles.mean(axis=1), measured, atol=0.03)
