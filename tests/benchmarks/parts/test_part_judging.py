"""The measure by which tracked body parts are right or wrong."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.benchmarks.parts.judging import Tracked, foreign_share, judge, right, tracked_parts
from tests.benchmarks.parts.rates import margin, rates_of
from tests.benchmarks.parts.truth import Truth, bounding

FRAMES = 30
TRUE = np.array([[40.0, 20, 60, 40], [35, 40, 65, 90], [36, 90, 64, 160]])
numbers = st.floats(-50, 50)


def _truth(visibility: float = 1.0) -> Truth:
    """Person 7, standing still."""
    parts = np.broadcast_to(TRUE, (FRAMES, 1, 3, 4)).copy()
    seen = np.full((FRAMES, 1), visibility)
    return Truth(np.array([7], np.int32), parts, seen, (200, 200))


def _tracked(tables: dict[int, np.ndarray]) -> Tracked:
    return Tracked(tables, {track: bounding(table) for track, table in tables.items()})


def _exact() -> np.ndarray:
    return np.broadcast_to(TRUE, (FRAMES, 3, 4)).copy()


@given(numbers, numbers)
def test_a_rectangle_as_large_as_its_part_is_right_until_half_of_it_is_off(
    dx: float, dy: float
) -> None:
    moved = TRUE[1] + np.array([dx, dy, dx, dy])
    inside = max(1 - abs(dx) / 30, 0) * max(1 - abs(dy) / 50, 0)
    assert foreign_share(moved, TRUE[1]) == pytest.approx(1 - inside, abs=1e-9)
    if abs(inside - 0.5) > 1e-6:
        assert right(moved, TRUE[1]) == (inside > 0.5)


def test_a_dot_and_no_rectangle_at_all_are_wrong() -> None:
    assert not right(np.array([50.0, 60, 51, 61]), TRUE[1])
    assert not right(np.full(4, np.nan), TRUE[1])
    assert not right(np.array([0.0, 0, 200, 200]), TRUE[1])


def test_who_is_tracked_exactly_is_right_from_the_first_frame_on() -> None:
    (one,) = judge(_truth(), _tracked({3: _exact()}), 20.0)
    assert (one.person, one.track, one.first_frame, len(one.parts)) == (7, 3, 0, FRAMES)
    assert one.parts.all()
    assert one.person_right.all()


def test_the_first_frame_is_the_one_in_which_a_track_stands_on_the_person() -> None:
    table = _exact()
    table[:5] = np.nan
    (one,) = judge(_truth(), _tracked({3: table}), 20.0)
    assert one.first_frame == 5
    assert one.parts.all()


def test_who_is_tracked_too_late_or_never_is_wrong_from_the_start() -> None:
    table = _exact()
    table[:21] = np.nan
    for tracked in (_tracked({3: table}), _tracked({})):
        (one,) = judge(_truth(), tracked, 20.0)
        assert (one.track, one.first_frame) == (0, 0)
        assert not one.parts.any()
        assert not one.person_right.any()


def test_another_id_on_the_same_person_is_worth_nothing() -> None:
    early, late = _exact(), _exact()
    early[10:] = np.nan
    late[:10] = np.nan
    (one,) = judge(_truth(), _tracked({3: early, 4: late}), 20.0)
    assert one.parts[:10].all()
    assert not one.parts[10:].any()


def test_a_track_belongs_to_whom_it_overlaps_most() -> None:
    front = _truth()
    shift = np.array([14.0, 0, 14, 0])
    parts = np.concatenate((front.parts, front.parts + shift), axis=1)
    both = Truth(np.array([7, 8], np.int32), parts, np.ones((FRAMES, 2)), (200, 200))
    late = _exact() + shift
    late[:3] = np.nan
    one, other = judge(both, _tracked({1: _exact(), 2: late}), 20.0)
    assert (one.track, one.first_frame) == (1, 0)
    assert (other.track, other.first_frame) == (2, 3)


def test_a_part_that_is_off_for_a_while_is_wrong_then_and_breaks_the_strict_curve() -> None:
    table = _exact()
    table[8:12, 0] += 40.0
    rates = rates_of(judge(_truth(), _tracked({3: table}), 20.0), last=FRAMES - 1)
    assert rates.right[:, 0].tolist() == [1.0] * 8 + [0.0] * 4 + [1.0] * 18
    assert rates.unbroken[:, 0].tolist() == [1.0] * 8 + [0.0] * 22
    assert (rates.right[:, 1:3] == 1.0).all()


def test_judging_ends_where_somebody_leaves_the_picture() -> None:
    truth = _truth()
    truth.parts[20:, 0, :, [0, 2]] += 150.0
    (one,) = judge(truth, _tracked({3: _exact()}), 20.0)
    assert len(one.parts) == 20


def test_who_is_hidden_from_the_beginning_is_not_judged() -> None:
    assert judge(_truth(visibility=0.5), _tracked({3: _exact()}), 20.0) == []


def test_a_run_s_rows_become_rectangles_round_their_centres() -> None:
    columns = {
        "frame": np.array([2, 2, 2]),
        "track": np.array([9, 9, 9]),
        "part": np.array([0, 1, 2]),
        "cx": np.array([50.0, 50, 50]),
        "cy": np.array([30.0, 65, 125]),
        "width": np.array([20.0, 30, 28]),
        "height": np.array([20.0, 50, 70]),
    }
    tracked = tracked_parts(columns, 4)
    assert np.array_equal(tracked.parts[9][2], TRUE)
    assert tracked.person[9][2].tolist() == [35.0, 20.0, 65.0, 160.0]
    assert np.isnan(tracked.parts[9][[0, 1, 3]]).all()


def test_people_who_leave_no_longer_count() -> None:
    truth = _truth()
    two = Truth(
        np.array([7, 8], np.int32),
        np.concatenate((truth.parts, truth.parts), axis=1),
        np.ones((FRAMES, 2)),
        (200, 200),
    )
    two.parts[10:, 1] = np.nan
    rates = rates_of(judge(two, _tracked({3: _exact()}), 20.0), last=FRAMES + 5)
    assert rates.people.tolist() == [2] * 10 + [1] * 20 + [0] * 6


def test_margins_shrink_with_the_number_of_people() -> None:
    assert margin(0.9, 70) == pytest.approx(0.07, abs=0.01)
    assert margin(0.9, 700) < margin(0.9, 70)
