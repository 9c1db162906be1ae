"""Newcomers before a camera at eye level: where they begin, and that they are confirmed."""

from __future__ import annotations

import cv2
import numpy as np
import pytest
from people_of_one_colour import view

from tracking.geometry import FlatView, ellipses_of
from tracking.trackers.spheroid import births, floor_cells
from tracking.trackers.spheroid.births import (
    NewPlace,
    SpheroidCandidates,
    find_candidates,
    update_candidates,
)
from tracking.trackers.spheroid.floor_cells import FloorCells

EYE_LEVEL = FlatView(view(1.2, 0.0, focal=300.0))
STREET = FlatView(view(1.66, 2.0, focal=800.0))
CAMERA = np.array([0.0, 0.0, 1.2])
NOBODY = np.zeros((0, 2))


def _walker(away_m: float, flat: FlatView = EYE_LEVEL) -> np.ndarray:
    """(240, 320) B times 255 of somebody in the middle of a stride, seen from the side."""
    ramp = np.zeros(flat.size[::-1], np.uint8)
    for height_m, semi_axes_m in ((1.58, (0.1, 0.1, 0.14)), (1.15, (0.2, 0.2, 0.4))):
        part = ellipses_of(
            flat.projection, np.array([[0.0, away_m, height_m]]), np.array([semi_axes_m])
        )
        cv2.fillPoly(ramp, [np.rint(part.polygons(40)[0]).astype(np.int32)], 255)
    thick = max(2, round(0.13 * 300.0 / away_m))
    for foot in (-0.34, 0.34):
        ends = flat.flat_from_world(np.array([[0.0, away_m, 0.85], [foot, away_m, 0.0]]))
        cv2.line(ramp, *np.rint(ends).astype(int).tolist(), 255, thick)
    return ramp


def _first(ramp: np.ndarray, flat: FlatView = EYE_LEVEL) -> NewPlace:
    everywhere = np.ones(ramp.shape, bool)
    cells = FloorCells(flat, 1.72, 0.25)
    return find_candidates(ramp, everywhere, cells, NOBODY, everywhere)[0]


def _at(*places: tuple[float, float]) -> tuple[NewPlace, ...]:
    return tuple(
        NewPlace(np.array(xy), np.array([xy]), np.zeros((1, 2)), np.ones(1)) for xy in places
    )


def _confirmed(first: tuple[float, float], then: tuple[float, float]) -> bool:
    before = update_candidates(SpheroidCandidates.none(), _at(first), 0.0, CAMERA)
    return bool(update_candidates(before, _at(then), 0.2, CAMERA).searches[0] == 2)


@pytest.mark.parametrize("away_m", [4.5, 6.0, 8.0])
def test_a_trunk_is_nobody_smaller_who_is_farther_away(away_m: float) -> None:
    """Legs apart leave the spheroid half empty; a smaller one of the trunk alone is full."""
    assert np.hypot(*_first(_walker(away_m)).xy) == pytest.approx(away_m, rel=0.15)


def test_hypotheses_of_a_newcomer_spread_over_the_depths_that_are_likely() -> None:
    drawn = _first(_walker(8.0)).draw(500, np.random.default_rng(1))
    assert drawn[:, 1].std() > 3.0 * drawn[:, 0].std()
    assert np.abs(drawn[:, 0]).max() < 0.6
    assert abs(np.median(drawn[:, 1]) - 8.0) < 1.5


def test_newcomers_may_jump_along_the_line_of_sight_but_not_across() -> None:
    assert _confirmed((0.0, 10.0), (0.0, 12.5))
    assert _confirmed((0.0, 10.0), (0.8, 12.0))
    assert not _confirmed((0.0, 10.0), (2.0, 10.0))
    assert not _confirmed((0.0, 10.0), (0.0, 16.0))


def test_with_a_gate_that_is_round_newcomers_who_jump_in_depth_are_never_confirmed(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(births, "_DEPTH_GATE", 0.0)
    assert not _confirmed((0.0, 10.0), (0.0, 12.5))
    assert not _confirmed((0.0, 10.0), (0.8, 12.0))


def test_depths_that_jump_say_nothing_of_how_fast_somebody_comes() -> None:
    before = update_candidates(SpheroidCandidates.none(), _at((0.0, 10.0)), 0.0, CAMERA)
    now = update_candidates(before, _at((0.4, 12.0)), 0.2, CAMERA)
    assert abs(now.velocity[0, 1]) < 0.5
    assert now.velocity[0, 0] > 0.5


def test_two_newcomers_do_not_confirm_one_candidate() -> None:
    before = update_candidates(SpheroidCandidates.none(), _at((0.0, 10.0)), 0.0, CAMERA)
    now = update_candidates(before, _at((0.1, 10.0), (0.5, 10.0)), 0.2, CAMERA)
    assert now.searches.tolist() == [2, 1]


def test_people_are_looked_for_as_far_as_the_image_shows_them_large_enough() -> None:
    """Not only as far as a row of pixels tells the place: at eye level that ends soon."""
    cells = FloorCells(STREET, 1.72, 0.25)
    away_m, height_px = np.hypot(*cells.xy.T), np.subtract(*cells.outlines.rows()[::-1])
    assert away_m.max() > 28.0
    assert height_px.min() >= 40.0
    assert np.hypot(*_first(_walker(30.0, STREET), STREET).xy) == pytest.approx(30.0, rel=0.15)


def test_nobody_is_found_beyond_the_farthest_place(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(floor_cells, "_FARTHEST_M", 28.0)
    ramp = _walker(34.0, STREET)
    everywhere = np.ones(ramp.shape, bool)
    cells = FloorCells(STREET, 1.72, 0.25)
    places = find_candidates(ramp, everywhere, cells, NOBODY, everywhere)
    assert all(np.hypot(*place.xy) < 28.5 for place in places)
