"""Running sums against the plain double loop."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from hypothesis import example, given, settings
from hypothesis import strategies as st
from people_of_one_colour import view

from tracking.geometry import Ellipses, FlatView, standing_ellipses
from tracking.trackers.spheroid.hypothesis_scores import (
    JudgedFrame,
    count_covering,
    judge,
    windows_of,
)
from tracking.trackers.spheroid.sums import sums_inside, window

SHAPE = (240, 320)
places = st.tuples(st.floats(-2.5, 2.5), st.floats(-2.0, 2.0))


def _one(outlines: Ellipses, person: int, hypothesis: int) -> Ellipses:
    return outlines[person : person + 1, hypothesis]


def _inside(outline: Ellipses) -> np.ndarray:
    """(height, width) bool: the pixels whose centres lie inside, line by line."""
    found = np.zeros(SHAPE, bool)
    left, right = outline.ends(np.arange(SHAPE[0])[None].astype(float))
    for v in range(SHAPE[0]):
        if np.isfinite(left[0, v]):
            for u in range(max(int(left[0, v]) - 1, 0), min(int(right[0, v]) + 2, SHAPE[1])):
                found[v, u] = left[0, v] <= u <= right[0, v]
    return found


def _plain_score(ramp: np.ndarray, counted: np.ndarray, own, region) -> float:
    """[Waechter2013] eq. 2 by a double loop over all pixels of the region that count."""
    shared, either = 0.0, 0.0
    body, around = _inside(own), _inside(region)
    for v, u in zip(*np.nonzero((around | body) & counted), strict=True):
        b, drawn = ramp[v, u] / 255.0, float(body[v, u])
        shared += b * drawn
        either += max(b, drawn)
    return shared / max(either, 1e-9)


@settings(max_examples=12, deadline=None)
@given(st.lists(places, min_size=2, max_size=3), st.floats(20.0, 90.0), st.integers(0, 99))
@example([(0.0, 0.0), (0.0, -2.0)], 70.0, 73)
def test_scores_by_running_sums_are_those_of_a_plain_double_loop(
    xy: list[tuple[float, float]], tilt: float, seed: int
) -> None:
    random = np.random.default_rng(seed)
    flat = FlatView(view(4.0, tilt))
    people = np.array(xy) + np.array([0.0, 4.0 * np.cos(np.deg2rad(tilt))])
    state = people[:, None] + random.normal(0, 0.2, (len(people), 2, 2))
    tall = random.uniform(1.5, 1.9, state.shape[:2])
    ramp = random.integers(0, 256, SHAPE, dtype=np.uint8)
    own = standing_ellipses(flat.projection, people, np.full(len(people), 1.7), 0.25)
    seen = standing_ellipses(flat.projection, state, tall, 0.25)
    region = standing_ellipses(flat.projection, state, tall, 0.25, 2.0)
    drawn = random.random(SHAPE) > 0.1
    judged = JudgedFrame(ramp, drawn, count_covering(SHAPE, own))
    windows = windows_of(judged, region, own, 0)
    found = judge(windows, seen, region).scores()
    for k in range(len(people)):
        others = count_covering(SHAPE, own[np.arange(len(people)) != k])
        counted = drawn & (others == 0)
        for j in range(2):
            plain = _plain_score(ramp, counted, _one(seen, k, j), _one(region, k, j))
            assert abs(found[k, j] - plain) < 1e-9


def test_where_nobody_is_in_the_picture_nothing_lies_inside() -> None:
    flat = FlatView(view(4.0, 45.0))
    away = np.array([[[40.0, 3.0], [41.0, 3.0]]])
    seen = standing_ellipses(flat.projection, away, np.full((1, 2), 1.7), 0.25)
    nothing = np.zeros((0, SHAPE[1]), np.uint8)
    empty = window(nothing, nothing > 0, 0, 0)
    found = sums_inside([replace(empty, sums=empty.sums[:, :0])], seen)
    assert not found.ramp.any()
    assert not found.area.any()


def test_what_lies_out_of_the_picture_or_nowhere_does_not_count() -> None:
    flat = FlatView(view())
    ramp = np.full(SHAPE, 255, np.uint8)
    xy = np.array([[[2.4, 0.0], [9.0, 0.0], [0.0, 0.0]]])
    seen = standing_ellipses(flat.projection, xy, np.full((1, 3), 1.7), 0.25)
    found = sums_inside([window(ramp, ramp > 0, 0, 0)], seen)
    assert found.area[0, 0] == _inside(_one(seen, 0, 0)).sum()
    assert found.area[0, 1] == 0.0
    assert np.allclose(found.ramp, found.area)


def test_rows_that_are_summed_to_lines_hardly_change_what_is_found() -> None:
    flat = FlatView(view())
    ramp = np.random.default_rng(1).integers(0, 256, SHAPE, dtype=np.uint8)
    xy = np.array([[[0.4, 0.3], [-0.8, 0.5]]])
    seen = standing_ellipses(flat.projection, xy, np.full((1, 2), 1.7), 0.25)
    fine, coarse = (sums_inside([window(ramp, ramp >= 0, 0, 0, n)], seen) for n in (1, 3))
    assert np.allclose(coarse.area, fine.area, rtol=0.05)
    assert np.allclose(coarse.ramp / coarse.area, fine.ramp / fine.area, atol=0.05)


def test_people_far_apart_are_summed_in_windows_of_their_own() -> None:
    flat = FlatView(view())
    people = np.array([[-1.2, 0.4], [1.3, -0.5]])
    own = standing_ellipses(flat.projection, people, np.full(2, 1.7), 0.25)
    ramp = np.random.default_rng(2).integers(0, 256, SHAPE, dtype=np.uint8)
    judged = JudgedFrame(ramp, np.ones(SHAPE, bool), count_covering(SHAPE, own))
    windows = windows_of(judged, own[:, None], own, 0)
    assert all(one.sums.shape[1] < 150 for one in windows)
    found = sums_inside(windows, own[:, None])
    for k in range(2):
        body = _inside(own[k : k + 1])
        assert found.area[k, 0] == body.sum()
        assert np.isclose(found.ramp[k, 0], ramp[body].sum() / 255.0)
        low = body & (np.arange(SHAPE[0])[:, None] > own.v[k])
        assert found.low_area[k, 0] == low.sum()
        assert np.isclose(found.low_ramp[k, 0], ramp[low].sum() / 255.0)
