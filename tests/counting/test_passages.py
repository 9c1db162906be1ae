"""Passages over a line: which way, when, where, and what is none."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from walks import crowd, together, walk, walk_at

from tracking.counting import CountingLine, passages
from tracking.errors import CountingError

GATE = CountingLine("gate", (0.0, 0.0), (0.0, 2.0))
"""Looking along it, up, negative x is on the left."""
FAR = CountingLine("far", (0.0, -1e6), (0.0, 1e6))


def test_left_to_right_is_forward_and_back_again_is_backward() -> None:
    found = passages(walk([(-1, 1), (1, 1), (-1, 1)]), 10.0, [GATE])
    assert found.forward.tolist() == [True, False]
    assert found.totals == (1, 1)


def test_a_line_drawn_the_other_way_counts_the_other_way() -> None:
    turned = CountingLine("gate", GATE.end, GATE.start)
    found = passages(walk([(-1, 1), (1, 1)]), 10.0, [GATE, turned])
    assert [found.of_line(number).totals for number in (0, 1)] == [(1, 0), (0, 1)]


def test_the_time_and_the_place_lie_between_two_frames() -> None:
    found = passages(walk([(-0.3, 0.5), (0.1, 0.9)], first=20), 10.0, [GATE])
    assert found.frame.tolist() == [21]
    assert found.time_s[0] == pytest.approx(2.075)
    assert found.place[0] == pytest.approx((0.0, 0.8))


@pytest.mark.parametrize("height", [-0.001, 2.001])
def test_who_walks_round_the_end_has_not_passed(height: float) -> None:
    assert len(passages(walk([(-1, height), (1, height)]), 10.0, [GATE])) == 0


@pytest.mark.parametrize("height", [0.0, 2.0])
def test_the_ends_belong_to_the_line(height: float) -> None:
    assert len(passages(walk([(-1, height), (1, height)]), 10.0, [GATE])) == 1


def test_the_crossing_counts_where_it_is_not_where_the_frames_are() -> None:
    """One way leads through the line between places that lie beside it, one leads past it."""
    through = walk([(-1.0, -0.5), (1.0, 1.5)])
    past = walk([(-1.0, 1.0), (0.25, -0.5)], track=2)
    found = passages(together(through, past), 10.0, [GATE])
    assert found.track.tolist() == [1]


def test_touching_the_line_and_turning_back_is_no_passage() -> None:
    assert len(passages(walk([(-1, 1), (0, 1), (-1, 1)]), 10.0, [GATE])) == 0


def test_standing_on_the_line_is_one_passage_when_it_is_left() -> None:
    found = passages(walk([(-1, 1), (0, 1), (0, 1.2), (0, 1.2), (1, 1.2)]), 10.0, [GATE])
    assert found.totals == (1, 0)
    assert (found.frame[0], found.time_s[0]) == (4, pytest.approx(0.3))
    assert found.place[0] == pytest.approx((0.0, 1.2))


def test_a_track_that_begins_on_the_line_has_come_from_nowhere() -> None:
    assert len(passages(walk([(0, 1), (1, 1)]), 10.0, [GATE])) == 0


def test_a_track_that_ends_on_the_line_has_not_passed() -> None:
    assert len(passages(walk([(-1, 1), (0, 1)]), 10.0, [GATE])) == 0


def test_rounding_puts_nobody_beyond_a_line_they_stand_on() -> None:
    line = CountingLine("gate", (0.3, 0.0), (0.3, 2.0))
    assert len(passages(walk([(0.0, 1.0), (0.1 + 0.2, 1.0), (0.0, 1.0)]), 10.0, [line])) == 0


def test_one_track_begins_where_another_ends_without_a_passage() -> None:
    both = together(walk([(-1, 1), (-2, 1)]), walk([(2, 1), (1, 1)], track=2, first=2))
    assert len(passages(both, 10.0, [GATE])) == 0


def test_a_gap_is_walked_straight_and_told() -> None:
    found = passages(walk_at([(0, (-1, 1)), (10, (1, 1))]), 10.0, [GATE])
    assert (found.time_s[0], found.gap[0], found.frame[0]) == (pytest.approx(0.5), 9, 10)


def test_frames_without_a_place_are_a_gap() -> None:
    nan = float("nan")
    found = passages(walk([(-1, 1), (nan, nan), (1, nan), (1, 1)]), 10.0, [GATE])
    assert (found.totals, found.gap[0]) == ((1, 0), 2)


def test_in_the_picture_the_foot_of_the_box_passes_and_left_is_left_on_the_screen() -> None:
    """Looking to the right along a level line, the upper part of the picture is on the left."""
    line = CountingLine("gate", (0.0, 100.0), (50.0, 100.0), in_picture=True)
    down = walk([(20.0, 90.0), (20.0, 110.0)])
    down["x"][:] = down["y"][:] = np.nan
    found = passages(down, 10.0, [line])
    assert found.totals == (1, 0)
    assert found.place[0] == pytest.approx((20.0, 100.0))


def test_trembling_on_the_line_counts_once_where_that_is_asked_for() -> None:
    trembling = walk([(-1, 1), *[(x, 1) for x in (0.02, -0.03, 0.01, -0.02, 0.04)], (1, 1)])
    assert passages(trembling, 10.0, [GATE]).totals == (3, 2)
    found = passages(trembling, 10.0, [GATE], jitter_m=0.05)
    assert (found.totals, found.frame.tolist()) == ((1, 0), [5])


def test_trembling_and_going_back_counts_as_nothing() -> None:
    trembling = walk([(-1, 1), (0.02, 1), (-0.03, 1), (0.01, 1), (-1, 1)])
    assert len(passages(trembling, 10.0, [GATE], jitter_m=0.05)) == 0


def test_who_goes_farther_than_trembling_passes_both_ways() -> None:
    found = passages(walk([(-1, 1), (0.06, 1), (-1, 1)]), 10.0, [GATE], jitter_m=0.05)
    assert found.totals == (1, 1)


def test_a_track_that_ends_right_behind_the_line_has_passed_all_the_same() -> None:
    assert len(passages(walk([(-1, 1), (0.01, 1)]), 10.0, [GATE], jitter_m=0.05)) == 1


def test_pixels_have_a_trembling_of_their_own() -> None:
    line = CountingLine("gate", (0.0, 100.0), (50.0, 100.0), in_picture=True)
    to_and_fro = walk([(20.0, 90.0), (20.0, 101.0), (20.0, 90.0)])
    assert len(passages(to_and_fro, 10.0, [line], jitter_m=5.0)) == 2
    assert len(passages(to_and_fro, 10.0, [line], jitter_px=1.5)) == 0


def test_a_track_twice_in_a_frame_is_refused() -> None:
    with pytest.raises(CountingError, match="track 1 stands twice in frame 0"):
        passages(walk_at([(0, (-1, 1)), (0, (1, 1))]), 10.0, [GATE])


def test_the_order_of_rows_does_not_matter() -> None:
    columns = crowd(3)
    order = np.random.default_rng(1).permutation(len(columns["frame"]))
    mixed = {name: column[order] for name, column in columns.items()}
    one, other = passages(columns, 10.0, [GATE, FAR]), passages(mixed, 10.0, [GATE, FAR])
    assert np.array_equal(one.time_s, other.time_s)
    assert np.array_equal(one.track, other.track)


def test_nobody_passes_no_line() -> None:
    assert len(passages(crowd(1), 10.0, [])) == 0
    assert len(passages(walk([]), 10.0, [GATE])) == 0


places = st.tuples(
    st.floats(-3, 3).map(lambda x: round(x, 2)), st.floats(-3, 3).map(lambda y: round(y, 2))
)


@given(st.lists(places, min_size=1, max_size=30), st.sampled_from([0.0, 0.3, 2.0]))
def test_forward_less_backward_is_the_change_of_side(
    way: list[tuple[float, float]], jitter_m: float
) -> None:
    """Over a line without end, with places on it too, whatever trembling is left out."""
    ahead, back = passages(walk(way), 10.0, [FAR], jitter_m=jitter_m).totals
    sides = [np.sign(x) for x, _ in way if x != 0]
    change = int(sides[-1] - sides[0]) // 2 if sides else 0
    assert ahead - back == change


@given(st.lists(places, min_size=2, max_size=30), st.integers(1, 28))
def test_cut_lines_count_what_the_whole_one_does(way: list[tuple[float, float]], cut: int) -> None:
    """A line in two pieces, cut where nobody's rounded places let them pass exactly."""
    middle = (0.0, cut / 10 - 1.5 + np.pi / 1e4)
    whole = CountingLine("whole", (0.0, -2.0), (0.0, 2.0))
    pieces = [CountingLine("a", whole.start, middle), CountingLine("b", middle, whole.end)]
    found = passages(walk(way), 10.0, pieces)
    assert found.totals == passages(walk(way), 10.0, [whole]).totals


@given(st.lists(places, min_size=2, max_size=30))
def test_walking_back_in_time_counts_the_other_way(way: list[tuple[float, float]]) -> None:
    off_line = [(x if x != 0 else 0.005, y) for x, y in way]
    ahead, back = passages(walk(off_line), 10.0, [GATE]).totals
    assert passages(walk(off_line[::-1]), 10.0, [GATE]).totals == (back, ahead)
