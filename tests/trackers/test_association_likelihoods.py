from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.stats import multivariate_t

from tracking.filtering import associate
from tracking.trackers.joint.appearance import CUES, AppearanceModel
from tracking.trackers.joint.association_likelihoods import place_density
from tracking.trackers.joint.motion import predict, update_motion
from tracking.trackers.joint.settings import JointSettings
from tracking.trackers.stereo.population import empty_population, unknown_motion


@given(
    st.floats(-2, 2), st.floats(-2, 2), st.floats(0.01, 1), st.floats(0.01, 1), st.floats(-0.9, 0.9)
)
def test_places_follow_students_t_of_the_particles_spread(x, y, xx, yy, share):
    xy = share * np.sqrt(xx * yy)
    found = place_density(np.array([[[x, y]]]), np.array([[xx, yy, xy]]), np.array([0.1]))
    shape = [[xx + 0.01, xy], [xy, yy + 0.01]]
    expected = multivariate_t([0.0, 0.0], shape, df=4).logpdf([x, y])
    assert found[0, 0] == pytest.approx(expected, abs=1e-6)


def people(count: int):
    empty = empty_population(400, 1, 4)
    zeros = {
        name: np.zeros((count, *getattr(empty, name).shape[1:]), getattr(empty, name).dtype)
        for name in ("particles", "position", "velocity", "missed_s")
    }
    return empty.replace(**zeros, motion=unknown_motion(np.full(count, 0.1)))


def test_particles_spread_as_the_place_becomes_less_known():
    random, settings = np.random.default_rng(0), JointSettings()
    one = people(3)
    start = one.motion[:, 0]
    for _ in range(20):
        one = predict(one, settings, 0.05, random)
    grown = one.particles.var(axis=1).mean(axis=1)
    np.testing.assert_allclose(grown, one.motion[:, 0] - start, rtol=0.25)


def test_a_measured_place_makes_place_and_velocity_better_known():
    random, settings = np.random.default_rng(0), JointSettings()
    ahead = predict(people(1), settings, 0.05, random)
    velocity, motion = update_motion(ahead, np.array([[0.2, 0.0]]), np.array([0.05]))
    assert motion[0, 0] < min(ahead.motion[0, 0], 0.05**2)
    assert motion[0, 2] < ahead.motion[0, 2]
    assert velocity[0, 0] > 0.0 == velocity[0, 1]


def test_cues_that_tell_nobody_apart_say_nothing():
    alike = np.tile((0.03, 0.03, 0.03, 2.0, 0.03), (3000, 1))
    model = AppearanceModel.prior()
    for _ in range(5):
        model = model.update(alike, alike)
    assert abs(model.log_likelihood_ratio(0.5 * alike[0])) < 0.5
    assert abs(model.log_likelihood_ratio(3.0 * alike[0])) < 0.5


def test_cues_that_tell_people_apart_speak_for_who_looks_alike_and_against_others():
    same, other = np.full((3000, CUES), 0.03), np.full((3000, CUES), 0.4)
    model = AppearanceModel.prior().update(same, other)
    assert model.log_likelihood_ratio(np.full(CUES, 0.02)) > 2.0
    assert model.log_likelihood_ratio(np.full(CUES, 0.4)) < -2.0


def test_what_is_not_known_of_somebody_says_nothing():
    assert AppearanceModel.prior().log_likelihood_ratio(np.full(CUES, np.nan)) == 0.0


def test_being_missed_may_cost_each_person_something_else():
    cost = np.array([[1.0], [1.0]])
    allowed = np.ones((2, 1), bool)
    assert associate(cost, allowed, np.array([0.1, 3.0])).track.tolist() == [1]
    assert associate(cost, allowed, np.array([3.0, 0.1])).track.tolist() == [0]
