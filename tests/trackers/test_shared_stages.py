"""What trackers share of their steps: clock, ids, gates, boxes to report, rows of results."""

from __future__ import annotations

import numpy as np
import pytest

from tracking.trackers.shared.gating import WideningGate, gate_pairs, nearest_others_m
from tracking.trackers.shared.occluders import occluder_mask
from tracking.trackers.shared.shown_boxes import steady_boxes
from tracking.trackers.shared.tracker_base import FrameClock, TrackIds
from tracking.tracks.columns import merged_rows


def test_no_time_passes_in_the_first_frame_nor_where_time_goes_back() -> None:
    clock = FrameClock()
    assert [clock.elapsed_s(time_s) for time_s in (5.0, 5.5, 5.2, 6.0)] == [0.0, 0.5, 0.0, 0.5]
    clock.set(1.0)
    assert clock.elapsed_s(1.25) == 0.25


def test_ids_have_no_gaps() -> None:
    ids = TrackIds(4)
    assert (ids.take(2).tolist(), ids.take(0).tolist(), ids.take(1).tolist()) == ([5, 6], [], [7])


def test_a_gate_widens_with_the_time_missed_up_to_its_widest() -> None:
    gate = WideningGate(at_once=0.5, a_second=1.0, widest=2.0)
    assert gate.radius(np.array([0.0, 1.0, 9.0])).tolist() == [0.5, 1.5, 2.0]


def test_pairs_within_the_radius_of_each_track_pass_the_gate() -> None:
    expected, measured = np.zeros((2, 2)), np.array([[0.6, 0.8], [3.0, 0.0]])
    gated = gate_pairs(expected, measured, np.array([[0.9], [1.0]]))
    assert gated.distance[0] == pytest.approx([1.0, 3.0])
    assert gated.allowed.tolist() == [[False, False], [True, False]]


def test_who_is_alone_is_near_nobody() -> None:
    assert nearest_others_m(np.zeros((1, 2))).tolist() == [np.inf]
    assert nearest_others_m(np.array([[0.0, 0.0], [3.0, 4.0], [3.0, 5.0]])).tolist() == [5, 1, 1]


def test_of_who_shares_a_region_the_learnt_outline_is_reported() -> None:
    box, seen = np.zeros((2, 4)), np.full((2, 4), 100.0)
    assert steady_boxes(box, seen, np.array([True, False]))[:, 0].tolist() == [85.0, 0.0]


def test_what_is_drawn_hides_the_pixels_in_it() -> None:
    mask = occluder_mask([np.array([(1.0, 1.0), (3.0, 1.0), (3.0, 2.0), (1.0, 2.0)])], (4, 5))
    assert mask.sum() == 6
    assert mask[1:3, 1:4].all()


def test_rows_of_tables_are_merged_by_frame_then_track() -> None:
    one = {"frame": np.array([0, 2]), "track": np.array([1, 1])}
    other = {"frame": np.array([2, 1]), "track": np.array([0, 7])}
    rows, order = merged_rows(one, other)
    assert list(zip(rows["frame"].tolist(), rows["track"].tolist(), strict=True)) == [
        (0, 1),
        (1, 7),
        (2, 0),
        (2, 1),
    ]
    assert order.tolist() == [0, 3, 2, 1]
