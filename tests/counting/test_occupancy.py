"""People inside regions in steps; speeds; steps themselves."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from walks import crowd, together, walk, walk_at

from tracking.counting import (
    CountingLine,
    CountSettings,
    Paths,
    Region,
    Steps,
    area,
    count,
    inside,
    lengths,
    occupancy,
    velocities,
)
from tracking.errors import CountingError

HALL = Region("hall", ((0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (0.0, 2.0)))
BEND = ((0.0, 0.0), (3.0, 0.0), (3.0, 3.0), (2.0, 3.0), (2.0, 1.0), (0.0, 1.0))


def test_people_are_counted_in_the_frame_at_which_each_step_begins() -> None:
    there = walk([(1, 1)] * 12)
    late = walk([(1, 1)] * 3, track=2, first=6)  # between the second step's frame and the third's
    (hall,) = occupancy(together(there, late), 10.0, [HALL], 20)
    assert hall.people.tolist() == [1, 1, 1, 0]
    assert hall.person_steps == 3


def test_density_is_people_a_square_metre() -> None:
    (hall,) = occupancy(together(walk([(1, 1)]), walk([(2, 1)], track=2)), 10.0, [HALL])
    assert hall.density.tolist() == [2 / 8]


def test_the_mean_speed_is_of_those_inside() -> None:
    inside_it = walk([(0.1 * k + 0.5, 1.0) for k in range(11)])
    outside = walk([(10.0 + k, 1.0) for k in range(11)], track=2)
    (hall,) = occupancy(together(inside_it, outside), 10.0, [HALL])
    assert hall.mean_speed == pytest.approx([1.0, 1.0, 1.0])


def test_nobody_has_no_speed() -> None:
    (hall,) = occupancy(walk([(9, 9)] * 11), 10.0, [HALL])
    assert np.isnan(hall.mean_speed).all()


def test_nobody_is_put_inside_in_a_gap() -> None:
    (hall,) = occupancy(walk_at([(0, (1, 1)), (15, (1, 1))]), 10.0, [HALL])
    assert hall.people.tolist() == [1, 0, 0, 1]


def test_a_region_in_the_picture_counts_feet_and_has_no_density() -> None:
    person = walk([(20.0, 90.0)] * 6)
    person["x"], person["y"] = np.linspace(0, 1, 6), np.zeros(6)
    corners = ((0.0, 80.0), (50.0, 80.0), (50.0, 95.0), (0.0, 95.0))
    (seen,) = occupancy(person, 10.0, [Region("shelf", corners, in_picture=True)])
    assert seen.people.tolist() == [1, 1]
    assert np.isnan(seen.density).all()
    assert seen.mean_speed == pytest.approx([2.0, 2.0])


def test_without_places_on_the_floor_a_region_in_the_picture_has_no_speed() -> None:
    person = walk([(20.0, 90.0)] * 6)
    person["x"][:] = np.nan
    corners = ((0.0, 80.0), (50.0, 80.0), (50.0, 95.0), (0.0, 95.0))
    (seen,) = occupancy(person, 10.0, [Region("shelf", corners, in_picture=True)])
    assert seen.people.tolist() == [1, 1]
    assert np.isnan(seen.mean_speed).all()


def test_the_inside_of_a_bent_polygon_follows_the_bend() -> None:
    places = np.array([(0.5, 0.5), (1.0, 2.0), (2.5, 2.5), (2.5, 0.5), (-1, 0.5), (np.nan, 1)])
    assert inside(BEND, places).tolist() == [True, False, True, True, False, False]
    assert area(BEND) == 5.0


def test_an_edge_is_not_inside() -> None:
    assert not inside(BEND, np.array([(1.0, 0.0), (2.0, 2.0), (3.0, 3.0), (1.0, 1.0)])).any()


@given(
    st.lists(st.tuples(st.integers(-40, 400), st.integers(-40, 400)), min_size=1, max_size=20).map(
        lambda rows: np.array(rows) / 100 + np.pi / 1e4
    )
)
def test_neighbouring_regions_share_nobody_and_miss_nobody(places: np.ndarray) -> None:
    left, right = ((0, 0), (1.5, 0), (1.5, 2), (0, 2)), ((1.5, 0), (4, 0), (4, 2), (1.5, 2))
    whole = ((0, 0), (4, 0), (4, 2), (0, 2))
    both = inside(left, places).astype(int) + inside(right, places)
    assert np.array_equal(both, inside(whole, places).astype(int))


def test_a_speed_is_taken_over_half_a_second() -> None:
    way = [(0.01 * k * k, 0.0) for k in range(21)]
    found = lengths(velocities(Paths.on_floor(walk(way)), 20.0))
    assert found[10] == pytest.approx((way[15][0] - way[5][0]) / 0.5)
    assert found[0] == pytest.approx((way[5][0] - way[0][0]) / 0.25)
    assert found[20] == pytest.approx((way[20][0] - way[15][0]) / 0.25)


def test_a_speed_in_a_short_track_is_from_its_first_place_to_its_last() -> None:
    found = lengths(
        velocities(Paths.on_floor(walk([(0, 0), (0.1, 0), (0.4, 0)])), 10.0, frame_step=5)
    )
    assert found == pytest.approx([2.0, 2.0, 2.0])


def test_one_place_has_no_speed() -> None:
    assert np.isnan(lengths(velocities(Paths.on_floor(walk([(0, 0)])), 10.0))).all()


def test_a_speed_at_a_gap_is_that_of_the_straight_way() -> None:
    found = lengths(
        velocities(Paths.on_floor(walk_at([(0, (0, 0)), (20, (2, 0)), (21, (2.1, 0))])), 10.0)
    )
    assert found == pytest.approx([1.0, 1.0, 1.0])


def test_steps_that_are_no_whole_frames_take_the_nearest() -> None:
    steps = Steps.of(90, 29.97, 0.5)
    assert steps.frame.tolist() == [0, 15, 30, 45, 60, 75]
    assert steps.start_s[-1] == 2.5


def test_there_are_as_many_steps_as_begin_in_the_recording() -> None:
    assert len(Steps.of(100, 20.0, 0.5)) == 10
    assert len(Steps.of(101, 20.0, 0.5)) == 11
    assert len(Steps.of(0, 20.0)) == 0


@pytest.mark.parametrize("step_s", [0.0, -1.0, float("nan"), float("inf"), 0.04])
def test_a_step_shorter_than_a_frame_is_refused(step_s: float) -> None:
    with pytest.raises(CountingError, match=r"lasts a frame at least, here 0\.05 s"):
        Steps.of(100, 20.0, step_s)


@given(st.integers(0, 30), st.sampled_from([0.1, 0.25, 0.5, 0.7, 3.0]))
def test_the_steps_of_a_line_sum_to_its_passages(seed: int, step_s: float) -> None:
    lines = [CountingLine("a", (0, -3), (0, 3)), CountingLine("b", (-3, 0.5), (3, 0))]
    found = count(crowd(seed), 10.0, 130, lines, settings=CountSettings(step_s))
    for number, of_line in enumerate(found.lines):
        assert of_line.totals == found.passages.of_line(number).totals
        assert len(of_line.forward) == len(found.steps)


def test_a_passage_stands_in_the_step_in_which_it_was() -> None:
    gate = CountingLine("gate", (0.0, 0.0), (0.0, 2.0))
    found = count(walk([(k - 6.5, 1.0) for k in range(12)]), 10.0, 12, [gate])
    assert found.lines[0].forward.tolist() == [0, 1, 0]


def test_lines_on_the_floor_need_places_there() -> None:
    blind = walk([(20.0, 90.0)] * 6)
    blind["x"][:] = blind["y"][:] = np.nan
    with pytest.raises(CountingError, match=r"'gate' lies on the floor.*draw it in the image"):
        count(blind, 10.0, 6, [CountingLine("gate", (0, 0), (0, 2))])
    lines = [CountingLine("gate", (0, 85), (50, 85), in_picture=True)]
    assert count(blind, 10.0, 6, lines).lines[0].totals == (0, 0)


def test_a_track_beyond_the_recordings_end_is_counted_too() -> None:
    found = count(walk([(1, 1)] * 20), 10.0, 5, regions=[HALL])
    assert found.regions[0].person_steps == 4
