import itertools

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from tracking.filtering import associate


def everything(cost: np.ndarray) -> np.ndarray:
    return np.ones(cost.shape, bool)


def least_total(cost: np.ndarray, left_out: float) -> float:
    """The smallest total by trying everything."""
    tracks, detections = cost.shape
    choices = itertools.product(range(-1, detections), repeat=tracks)
    totals = []
    for choice in choices:
        real = [c for c in choice if c >= 0]
        if len(set(real)) == len(real):
            costs = [left_out if c < 0 else cost[t, c] for t, c in enumerate(choice)]
            totals.append(sum(costs))
    return min(totals)


@given(st.integers(0, 3), st.integers(0, 3), st.integers(0, 1000))
def test_the_total_is_the_smallest_there_is(tracks, detections, seed):
    cost = np.random.default_rng(seed).random((tracks, detections)) * 2
    found = associate(cost, everything(cost), left_out=1.0)
    left = tracks - len(found.track)
    total = cost[found.track, found.detection].sum() + left * 1.0
    assert np.isclose(total, least_total(cost, 1.0))


@given(st.permutations(range(4)), st.integers(0, 1000))
def test_the_pairs_do_not_depend_on_the_order_of_tracks(order, seed):
    cost = np.random.default_rng(seed).random((4, 5))
    straight = associate(cost, everything(cost), 9.0)
    shuffled = associate(cost[order], everything(cost), 9.0)
    pairs = {order[t]: d for t, d in zip(shuffled.track, shuffled.detection, strict=True)}
    assert pairs == dict(zip(straight.track, straight.detection, strict=True))


def test_pairs_outside_the_gate_are_never_made():
    cost = np.array([[0.1, 0.9]])
    found = associate(cost, np.array([[False, True]]), left_out=1.0)
    assert found.detection.tolist() == [1]


def test_a_pair_dearer_than_leaving_out_is_not_made():
    cost = np.array([[1.5]])
    assert len(associate(cost, everything(cost), left_out=1.0).track) == 0


def test_a_missing_detection_does_not_shift_everybody_to_the_next():
    """The first person is unseen; the others keep their own detections."""
    cost = np.array([[0.8, 9.0], [0.1, 0.8], [9.0, 0.1]])
    found = associate(cost, everything(cost), left_out=1.0)
    assert (found.track.tolist(), found.detection.tolist()) == ([1, 2], [0, 1])


def test_the_margin_is_that_of_an_exchange_where_two_could_be_swapped():
    cost = np.array([[0.1, 0.3], [0.5, 0.2]])
    found = associate(cost, everything(cost), left_out=9.0)
    np.testing.assert_allclose(found.margin, [0.5, 0.5])


def test_the_margin_is_that_of_a_free_detection_where_one_is_near():
    cost = np.array([[0.1, 0.15]])
    np.testing.assert_allclose(associate(cost, everything(cost), 9.0).margin, [0.05])


def test_the_margin_is_that_of_a_free_track_where_one_could_take_over():
    cost = np.array([[0.1], [0.3]])
    np.testing.assert_allclose(associate(cost, everything(cost), 9.0).margin, [0.2])


def test_without_another_choice_there_is_no_margin():
    cost = np.array([[0.1]])
    assert np.isnan(associate(cost, everything(cost), 9.0).margin).all()
