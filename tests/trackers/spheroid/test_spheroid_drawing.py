"""What the window draws of the spheroid tracker."""

from __future__ import annotations

import numpy as np
from people_of_one_colour import Body, built, frames_of, standing, view

from tracking.geometry import FlatView
from tracking.trackers.spheroid import outlines, region_of_evaluation


def test_outlines_are_drawn_through_the_lens() -> None:
    plain, lens = view(3.0, 40.0), view(3.0, 40.0, (-0.25, 0.06, 0.0, 0.0, 0.0))
    xy = np.array([[0.0, 4.0], [1.6, 3.0], [0.0, -5.0]])
    straight, bent = outlines(plain, xy, 1.75), outlines(lens, xy, np.full(3, 1.75))
    assert straight.shape == bent.shape == (3, 32, 2)
    assert np.isnan(bent[2]).all()
    carried = FlatView(lens).recorded_from_flat(
        FlatView(lens).flat_from_world(np.array([[1.6, 3.0, 0.875]]))
    )
    low, high = bent[1].min(axis=0), bent[1].max(axis=0)
    assert (low < carried[0]).all()
    assert (carried[0] < high).all()
    assert np.abs(bent[1] - straight[1]).max() > 3


def test_the_region_of_evaluation_is_twice_as_large_and_leaves_others_out() -> None:
    seen_by = view(3.6, 90.0)
    others = np.array([[0.6, 0.0], [-0.5, 0.4]])
    region = region_of_evaluation(seen_by, np.array([0.1, 0.2]), 1.75, others, np.full(2, 1.7))
    own = outlines(seen_by, np.array([[0.1, 0.2]]), 1.75)[0]
    assert (np.ptp(region.outline, axis=0) > 1.7 * np.ptp(own, axis=0)).all()
    assert region.masked.shape == (2, 64, 2)
    assert np.allclose(region.masked[0, ::2], outlines(seen_by, others[:1], 1.7)[0])


def test_the_ramp_picture_shows_people_in_recorded_pixels() -> None:
    seen_by = view(3.6, 90.0, (-0.25, 0.06, 0.0, 0.0, 0.0))
    frame = frames_of(seen_by, [Body(standing((0.8, 0.3), 1))])[0]
    perception, _ = built(seen_by)
    shown = perception.ramp_picture(frame)
    assert shown.shape == frame.left.shape[:2]
    centre = outlines(seen_by, np.array([[0.8, 0.3]]), 1.72)[0].mean(axis=0)
    u, v = np.rint(centre).astype(int)
    assert shown[v, u] > 200
    assert (shown > 60).mean() < 0.2
