"""Tracklets are gathered by mean shift, exactly as one after the other would be."""

from __future__ import annotations

import numpy as np
from flow_scenes import view_of
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from plain_mean_shift import plain_settled, plain_step

from tracking.trackers.flow import kernel_table
from tracking.trackers.flow.mean_shift import (
    cluster_cold,
    cluster_warm,
    is_inside,
    join_modes,
    settle_modes,
    shift_modes,
    shrink_kernels,
)

Vectors = NDArray[np.float64]

TABLE = kernel_table(view_of(2.2, 20.0)).scaled(2.0)
FEWEST, JOIN = 4, 0.5


def bundle(u: float, v: float, pace: tuple[float, float], count: int, seed: int) -> Vectors:
    """Tracklets spread over a body at a pixel, moving px a frame."""
    random = np.random.default_rng(seed)
    half = TABLE.at(np.array([u, v])) / 4
    now = np.array([u, v]) + random.uniform(-0.6, 0.6, (count, 2)) * half
    return np.stack([now - back * np.asarray(pace) for back in range(3)], axis=1)


def moved(tracklets: Vectors, pace: tuple[float, float]) -> Vectors:
    newest = tracklets[:, :1] + np.asarray(pace)
    return np.concatenate((newest, tracklets[:, :2]), axis=1)


@settings(max_examples=8, deadline=None)
@given(st.integers(0, 10**6), st.integers(1, 16))
def test_settled_modes_are_those_of_the_plain_way(seed: int, count: int) -> None:
    random = np.random.default_rng(seed)
    now = random.uniform((100, 200), (540, 440), (count, 2))
    tracklets = now[:, None] + np.cumsum(random.normal(0, 4, (count, 3, 2)), axis=1)
    np.testing.assert_allclose(
        settle_modes(tracklets, tracklets, TABLE), plain_settled(tracklets, TABLE), atol=1e-9
    )


def test_one_step_is_that_of_the_plain_way() -> None:
    tracklets = np.concatenate([bundle(300, 300, (4, 1), 10, 1), bundle(345, 310, (4, 1), 10, 2)])
    size = TABLE.at(tracklets)
    step = shift_modes(tracklets, is_inside(tracklets, size, tracklets), tracklets)
    plain = [plain_step(one, tracklets, TABLE) for one in tracklets]
    np.testing.assert_allclose(step, plain, atol=1e-9)


def test_people_side_by_side_are_two_clusters() -> None:
    tracklets = np.concatenate([bundle(250, 300, (3, 0), 15, 3), bundle(360, 300, (3, 0), 12, 4)])
    found = cluster_cold(tracklets, TABLE, FEWEST, JOIN)
    assert len(found) == 2
    assert len(set(found.label[:15])) == 1
    assert len(set(found.label[15:])) == 1
    assert found.label[0] != found.label[-1]


def test_people_who_pass_each_other_at_one_place_are_two_clusters() -> None:
    tracklets = np.concatenate(
        [bundle(300, 300, (45, 0), 15, 5), bundle(300, 300, (-45, 0), 15, 6)]
    )
    found = cluster_cold(tracklets, TABLE, FEWEST, JOIN)
    assert len(found) == 2
    assert not set(found.label[:15]) & set(found.label[15:])


def test_few_tracklets_are_nobody() -> None:
    found = cluster_cold(bundle(300, 300, (3, 0), FEWEST - 1, 7), TABLE, FEWEST, JOIN)
    assert len(found) == 0
    assert (found.label == -1).all()


def test_modes_of_the_frame_before_lead_to_the_same_clusters_in_one_step() -> None:
    pace = (5.0, 1.0)
    tracklets = np.concatenate([bundle(250, 300, pace, 15, 8), bundle(360, 300, pace, 12, 9)])
    before = cluster_cold(tracklets, TABLE, FEWEST, JOIN)
    now = moved(tracklets, pace)
    warmly, coldly = (
        cluster_warm(before.mode, now, TABLE, FEWEST, JOIN),
        cluster_cold(now, TABLE, FEWEST, JOIN),
    )
    assert len(warmly) == len(coldly) == 2
    np.testing.assert_array_equal(
        warmly.label[:, None] == warmly.label, coldly.label[:, None] == coldly.label
    )


def test_somebody_new_gets_a_cluster_beside_those_of_the_frame_before() -> None:
    pace = (5.0, 0.0)
    one, new = bundle(250, 300, pace, 15, 10), bundle(450, 320, pace, 10, 11)
    before = cluster_cold(one, TABLE, FEWEST, JOIN)
    found = before
    both = np.concatenate((one, new))
    for _ in range(3):
        both = moved(both, pace)
        found = cluster_warm(found.mode, both, TABLE, FEWEST, JOIN)
    assert len(found) == 2


def test_modes_near_each_other_join_the_heaviest() -> None:
    mode = np.array([[[100.0, 300.0]] * 3, [[104.0, 302.0]] * 3, [[300.0, 300.0]] * 3])
    target = join_modes(mode, TABLE.at(mode), np.array([3, 9, 4]), JOIN)
    assert target.tolist() == [1, 1, 2]


def test_a_kernel_shrinks_where_the_lower_body_has_no_tracklets() -> None:
    mode = np.full((1, 3, 2), (300.0, 300.0))
    size = TABLE.at(mode)
    height = size[0, 0, 1]
    head = np.full((5, 3, 2), (300.0, 300.0 - 0.15 * height))
    feet = np.full((2, 3, 2), (300.0, 300.0 + 0.15 * height))
    assert shrink_kernels(mode, size, head)[0, 0, 1] < 0.8 * height
    whole = shrink_kernels(mode, size, np.concatenate((head, feet)))
    np.testing.assert_array_equal(whole, size)


def test_no_tracklets_and_no_modes_are_no_clusters() -> None:
    none = np.zeros((0, 3, 2))
    assert len(cluster_cold(none, TABLE, FEWEST, JOIN)) == 0
    assert len(cluster_warm(none, none, TABLE, FEWEST, JOIN)) == 0
    some = cluster_cold(bundle(300, 300, (3, 0), 9, 12), TABLE, FEWEST, JOIN)
    assert len(cluster_warm(some.mode, none, TABLE, FEWEST, JOIN)) == 0
