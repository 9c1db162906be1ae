import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tracking.filtering import bhattacharyya_distance, direction_cost, turning_angle

ANGLES = st.floats(-3.1, 3.1)


def heading(angle: float, length: float = 1.0) -> np.ndarray:
    return length * np.array([np.cos(angle), np.sin(angle)])


@given(ANGLES, ANGLES, st.floats(0.1, 10.0))
def test_the_turn_is_the_angle_between_the_headings_whatever_their_length(walked, way, length):
    angle = turning_angle(heading(walked)[None], heading(way, length)[None, None])[0, 0]
    apart = abs(walked - way)
    assert angle == pytest.approx(min(apart, 2 * np.pi - apart), abs=1e-9)


def test_without_a_heading_there_is_no_turn():
    angle = turning_angle(np.full((1, 2), np.nan), np.ones((1, 3, 2)))
    assert np.isnan(direction_cost(angle, 1.22, 0.5)).all()


def test_a_turn_costs_more_the_sharper_it_is_up_to_the_threshold():
    cost = direction_cost(np.array([[0.0, 0.61, 1.22, 3.0]]), 1.22, 0.5)
    np.testing.assert_allclose(cost, [[0.0, 0.25, 0.5, 0.5]])


def test_equal_histograms_have_no_distance_and_disjoint_ones_have_one():
    one = np.array([[0.5, 0.5, 0.0, 0.0]], np.float32)
    other = np.array([[0.0, 0.0, 0.3, 0.7]], np.float32)
    both = np.concatenate((one, other))
    np.testing.assert_allclose(bhattacharyya_distance(both, both), [[0, 1], [1, 0]], atol=1e-3)
