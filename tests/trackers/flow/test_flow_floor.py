"""Where tracklets say that people are, and what holds people together on the floor."""

from __future__ import annotations

import numpy as np
import pytest
from flow_scenes import view_of
from hypothesis import given, settings
from hypothesis import strategies as st

from tracking.trackers.flow.floor import Floor, sight_axes
from tracking.trackers.flow.silhouettes import (
    BODY,
    SHADE,
    draw_cover,
    fit_silhouettes,
    score_silhouettes,
)
from tracking.trackers.flow.tracklet_owners import (
    TrackletOwners,
    adapt_offsets,
    estimate_places,
    move_offsets,
    release_misfits,
)
from tracking.trackers.flow.walkers import Walkers, begin_walkers, predict, update_measured

FLOOR = Floor(view_of(3.0, 35.0))
_SPOTS = np.array(
    [[dx, dy, z] for dx in (-0.15, 0.0, 0.15) for dy in (-0.1, 0.1) for z in (0.4, 0.9, 1.4)]
)


def walkers_at(*places: tuple[float, float]) -> Walkers:
    count = len(places)
    return begin_walkers(
        np.arange(1, count + 1, dtype=np.int32), np.array(places), np.zeros((count, 2))
    )


def held(walkers: Walkers) -> tuple[TrackletOwners, np.ndarray]:
    """Tracklets spread over the bodies of everybody, and their slopes."""
    place = np.repeat(walkers.place, len(_SPOTS), axis=0)
    spots = np.tile(_SPOTS, (len(walkers), 1))
    owner = np.repeat(walkers.track, len(_SPOTS))
    slope = slopes_of(place, spots)
    rows = np.arange(len(owner))
    return TrackletOwners.none().for_ids(rows + 1).assign(rows, owner, place, slope, FLOOR), slope


def slopes_of(place: np.ndarray, spots: np.ndarray) -> np.ndarray:
    pixels = FLOOR.pixels(place + spots[:, :2], spots[:, 2])
    return FLOOR.slopes(pixels)


def body_mask(*people: tuple[float, float], value: int = BODY) -> np.ndarray:
    """The foreground of people at half resolution, by the silhouettes that hide others."""
    cover = draw_cover(np.array(people), FLOOR)
    return np.where(np.isfinite(cover), np.uint8(value), np.uint8(0))


@settings(max_examples=40, deadline=None)
@given(st.floats(-1.5, 1.5), st.floats(2.5, 8.0), st.floats(0.1, 1.7))
def test_a_points_ray_passes_its_person_at_the_points_height(x: float, y: float, z: float) -> None:
    place = np.array([[x, y]])
    slope = FLOOR.slopes(FLOOR.pixels(place, np.array([z])))
    np.testing.assert_allclose(FLOOR.places(slope, np.array([z])), place, atol=1e-6)
    np.testing.assert_allclose(FLOOR.heights(slope, place), [z], atol=0.05)


@settings(max_examples=30, deadline=None)
@given(st.floats(-0.3, 0.3), st.floats(-0.3, 0.3))
def test_tracklets_say_how_far_people_walked(dx: float, dy: float) -> None:
    walkers = walkers_at((0.3, 4.0), (-0.8, 5.0))
    owners, _ = held(walkers)
    step = np.array([dx, dy])
    place = np.repeat(walkers.place + step, len(_SPOTS), axis=0)
    estimate = estimate_places(walkers, owners, slopes_of(place, np.tile(_SPOTS, (2, 1))), FLOOR)
    np.testing.assert_allclose(estimate.place, walkers.place + step, atol=0.05)
    assert (estimate.count >= len(_SPOTS) - 2).all()


def test_a_few_tracklets_that_move_otherwise_move_nobody_and_are_released() -> None:
    walkers = walkers_at((0.3, 4.0))
    owners, slope = held(walkers)
    slope[:4] += (0.3, 0.0)
    estimate = estimate_places(walkers, owners, slope, FLOOR)
    np.testing.assert_allclose(estimate.place, walkers.place, atol=0.05)
    after = release_misfits(owners, estimate.misfit, 0.3)
    assert (after.owner[:4] == 0).all()
    assert (after.owner[4:] == 1).all()


def test_people_without_tracklets_are_told_nothing_of() -> None:
    walkers = walkers_at((0.3, 4.0), (1.0, 6.0))
    owners, slope = held(walkers.select(np.array([True, False])))
    estimate = estimate_places(walkers, owners, slope, FLOOR)
    assert np.isfinite(estimate.place[0]).all()
    assert np.isnan(estimate.place[1]).all()


def test_tracklets_go_along_when_a_person_is_found_farther_away() -> None:
    walkers = walkers_at((0.0, 4.0))
    owners, slope = held(walkers)
    by = np.array([[0.0, 0.5]])
    there = walkers_at((0.0, 4.5))
    np.testing.assert_allclose(
        estimate_places(there, move_offsets(there, owners, slope, by, FLOOR), slope, FLOOR).place,
        there.place,
        atol=0.06,
    )


def test_tracklets_that_lie_beside_the_body_are_set_free() -> None:
    walkers = walkers_at((0.0, 4.0))
    owners, slope = held(walkers)
    assert (adapt_offsets(walkers, owners, slope, FLOOR, 0.1).owner == 1).all()
    aside = walkers_at((0.8, 4.0))
    assert (adapt_offsets(aside, owners, slope, FLOOR, 0.1).owner == 0).all()


def test_a_body_fills_its_own_silhouette_best() -> None:
    mask, nobody = body_mask((0.3, 4.0)), draw_cover(np.zeros((0, 2)), FLOOR)
    places = np.array([[0.3, 4.0], [0.3, 3.2], [0.3, 5.2], [0.8, 4.0]])
    score = score_silhouettes(places, mask, nobody, FLOOR).score
    assert score.argmax() == 0
    assert score[0] > 0.8
    assert score[1:].max() < 0.7


def test_people_are_drawn_to_where_the_foreground_has_them() -> None:
    believed = np.array([[0.2, 4.3]])
    mask = body_mask((0.3, 4.0))
    to = fit_silhouettes(believed, mask, draw_cover(believed, FLOOR), FLOOR)
    before, after = (np.hypot(*(at[0] - (0.3, 4.0))) for at in (believed, to.place))
    assert after < 0.5 * before


def test_a_shadow_on_the_floor_fills_nobody() -> None:
    mask = body_mask((0.3, 4.0), value=SHADE)
    nobody = draw_cover(np.zeros((0, 2)), FLOOR)
    seen = score_silhouettes(np.array([[0.3, 4.0]]), mask, nobody, FLOOR)
    assert seen.own[0] == 0.0


def test_somebody_behind_another_is_in_sight_only_in_part() -> None:
    nearer = np.array([[0.0, 4.0]])
    cover = draw_cover(nearer, FLOOR)
    mask = body_mask((0.0, 4.0), (0.0, 4.7))
    both = score_silhouettes(np.array([[0.0, 4.7], [1.2, 4.7]]), mask, cover, FLOOR)
    assert both.seen[0] < 0.5
    assert both.seen[1] > 0.9


def test_nothing_is_told_of_somebody_wholly_hidden() -> None:
    believed = np.array([[0.0, 4.0], [0.0, 4.35]])
    low = Floor(view_of(1.8, 8.0))
    cover = draw_cover(believed, low)
    mask = np.where(np.isfinite(cover), np.uint8(BODY), np.uint8(0))
    to = fit_silhouettes(believed, mask, cover, low)
    assert np.isfinite(to.place[0]).all()
    assert np.isnan(to.place[1]).all()


def test_the_filter_follows_somebody_who_walks_evenly() -> None:
    walkers, pace = walkers_at((0.0, 4.0)), np.array([0.4, -1.1])
    for step in range(1, 31):
        walkers = predict(walkers, 0.1)
        walkers = update_measured(
            walkers, np.array([[0.0, 4.0]]) + 0.1 * step * pace, np.array([[0.1, 0.1]])
        )
    np.testing.assert_allclose(walkers.pace[0], pace, atol=0.02)
    assert np.isfinite(walkers.spread).all()


def test_what_is_not_measured_is_left_as_predicted() -> None:
    walkers = walkers_at((0.0, 4.0), (1.0, 5.0))
    place = np.array([[np.nan, np.nan], [1.2, 5.0]])
    after = update_measured(walkers, place, np.full((2, 2), 0.1))
    np.testing.assert_array_equal(after.state[0], walkers.state[0])
    assert after.state[1, 0] == pytest.approx(1.19, abs=0.02)


def test_sight_axes_are_square_also_straight_below_the_camera() -> None:
    axes = sight_axes(np.array([[0.0, 0.0], [1.0, 2.0]]))
    square = np.tile(np.eye(2), (2, 1, 1))
    np.testing.assert_allclose(axes @ np.swapaxes(axes, 1, 2), square, atol=1e-12)
