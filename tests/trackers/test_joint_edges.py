from __future__ import annotations

import numpy as np
import pytest
from people_on_a_floor import view

from tracking.trackers.joint.edges import here_and_a_step_off, share_a_step_off


def on_the_floor(*pixels: tuple[float, float]):
    return view().floor_from_pixel(np.array(pixels), 0.9)


def share(position: np.ndarray):
    _, around = here_and_a_step_off(position, view())
    return share_a_step_off(around, view().camera.size)


def test_who_stands_in_the_middle_is_whole_a_step_further_off():
    width, height = view().camera.size
    assert share(on_the_floor((width / 2, height / 2)))[0] == pytest.approx(1.0)


def test_who_stands_at_a_side_is_out_of_the_picture_a_step_further_off():
    width, height = view().camera.size
    beside = on_the_floor((3.0, height / 2), (width - 3.0, height / 2))
    np.testing.assert_array_equal(share(beside), 0.0)


def test_whose_head_is_cut_off_far_away_does_not_leave_with_the_next_step():
    far = np.array([[0.0, 10.0]])
    here, _ = here_and_a_step_off(far, view())
    assert here.middle[0, 1] < 0.85 * here.px_per_m[0, 0]
    assert share(far)[0] > 0.5
