"""Points are followed from picture to picture and end where they cannot be."""

from __future__ import annotations

import numpy as np
import pytest
from flow_scenes import SIZE, floor_picture
from numpy.typing import NDArray

from tracking.trackers.flow.point_tracker import PointFollower
from tracking.trackers.flow.settings import PointSettings

Grey = NDArray[np.uint8]

SPACING = np.full(SIZE[::-1], 16.0, np.float32)


def grey(seed: int = 1, shift: tuple[int, int] = (0, 0)) -> Grey:
    return np.roll(floor_picture(seed)[..., 0], shift, axis=(0, 1))


@pytest.fixture
def follower() -> PointFollower:
    return PointFollower(PointSettings(), 7, SPACING)


def test_points_follow_the_picture_to_a_fraction_of_a_pixel(follower: PointFollower) -> None:
    first = follower.step(grey(), None)
    second = follower.step(grey(shift=(3, 5)), None)
    kept = np.isin(second.id, first.id)
    shift = second.path[kept, 0] - second.path[kept, 1]
    assert len(first) > 100
    assert kept.sum() > 0.8 * len(first)
    np.testing.assert_allclose(np.median(shift, axis=0), (5, 3), atol=0.05)
    assert (np.hypot(*(shift - (5, 3)).T) < 0.5).mean() > 0.95


def test_points_on_what_is_not_there_any_more_end(follower: PointFollower) -> None:
    first = follower.step(grey(), None)
    second = follower.step(np.full(SIZE[::-1], 120, np.uint8), None)
    assert len(first) > 100
    assert not np.isin(first.id, second.id).any()


def test_there_are_never_more_points_than_asked_for() -> None:
    follower = PointFollower(PointSettings(max_points=50), 7, SPACING)
    for number in range(4):
        assert len(follower.step(grey(shift=(0, 2 * number)), None)) <= 50


def test_new_points_are_found_only_where_they_are_looked_for(follower: PointFollower) -> None:
    seek = np.zeros((SIZE[1] // 2, SIZE[0] // 2), np.uint8)
    seek[60:120, 80:160] = 1
    found = follower.step(grey(), seek).path[:, 0]
    assert len(found) > 5
    assert ((found >= (160, 120)) & (found < (322, 242))).all()


def test_what_is_dropped_is_followed_no_further(follower: PointFollower) -> None:
    first = follower.step(grey(), None)
    gone = np.arange(len(first)) % 2 == 0
    follower.drop(gone)
    second = follower.step(grey(), np.zeros((240, 320), np.uint8))
    assert not np.isin(first.id[gone], second.id).any()
    assert np.isin(first.id[~gone], second.id).mean() > 0.9


def test_ids_are_ascending_and_never_given_out_again(follower: PointFollower) -> None:
    known: set[int] = set()
    for number in range(5):
        ids = follower.step(grey(seed=number), None).id
        assert (np.diff(ids) > 0).all()
        fresh = set(ids.tolist()) - known
        assert not known or min(fresh) > max(known)
        known |= fresh


def test_a_picture_without_corners_has_no_points(follower: PointFollower) -> None:
    assert len(follower.step(np.full(SIZE[::-1], 90, np.uint8), None)) == 0
