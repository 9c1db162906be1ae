import numpy as np
import pytest

from tracking.filtering import hiding_reach, out_of_hiding

SOMEBODY = np.array([[0.0, 5.0]])


@pytest.mark.parametrize(
    ("place", "away_m"),
    [((0.0, 6.0), 0.0), ((0.2, 5.5), 0.0), ((0.0, 3.0), 1.7), ((1.3, 6.0), 1.0), ((0.0, 8.0), 1.0)],
)
def test_behind_somebody_is_a_hiding_place_and_beside_or_before_is_none(place, away_m):
    particles = np.array([[place]], np.float32)
    away = out_of_hiding(particles, SOMEBODY, np.array([2.0]), body_m=0.3)
    assert away[0, 0] == pytest.approx(away_m, abs=1e-5)


def test_the_nearest_of_several_hiding_places_counts():
    particles = np.array([[[0.0, 6.0], [3.0, 6.0]]], np.float32)
    two = np.array([[0.0, 5.0], [2.5, 5.0]])
    assert (out_of_hiding(particles, two, np.array([2.0, 2.0]), 0.3) < 0.2).all()


def test_a_low_camera_sees_less_of_what_is_behind_people_than_a_high_one():
    low, high = (hiding_reach(SOMEBODY, height)[0] for height in (2.4, 6.4))
    assert low > 3.0 > 1.0 > high
    assert np.isfinite(hiding_reach(SOMEBODY, 1.0)).all()
