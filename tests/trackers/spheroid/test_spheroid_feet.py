"""Feet, by which somebody seen from the side is as far away as they look."""

from __future__ import annotations

import cv2
import numpy as np
import pytest
from people_of_one_colour import view

from tracking.geometry import FlatView, ellipses_of, standing_ellipses
from tracking.trackers.spheroid.births import find_candidates
from tracking.trackers.spheroid.feet import feet_of, feet_parts, feet_scores
from tracking.trackers.spheroid.floor_cells import FloorCells
from tracking.trackers.spheroid.hypothesis_scores import (
    LINES,
    JudgedFrame,
    count_covering,
    windows_of,
)
from tracking.trackers.spheroid.weights import _BALANCE, _gains

FLAT = FlatView(view(2.5, 20.0))
ALONG = np.arange(3.4, 7.0, 0.1)


def _seen(*places: tuple[float, float]) -> np.ndarray:
    """(240, 320) B times 255 of people who stand with their legs a little apart."""
    ramp = np.zeros(FLAT.size[::-1], np.uint8)
    for x, y in places:
        trunk = ellipses_of(
            FLAT.projection, np.array([[x, y, 1.22]]), np.array([[0.22, 0.22, 0.5]])
        )
        cv2.fillPoly(ramp, [np.rint(trunk.polygons(40)[0]).astype(np.int32)], 255)
        for leg in (x - 0.12, x + 0.12):
            ends = FLAT.flat_from_world(np.array([[leg, y, 0.8], [leg, y, 0.0]]))
            cv2.line(ramp, *np.rint(ends).astype(int).tolist(), 255, 3)
    return ramp


def _said(ramp: np.ndarray, everybody: np.ndarray, row: int) -> np.ndarray:
    """What feet say of hypotheses along the view of who stands at a row."""
    own = standing_ellipses(FLAT.projection, everybody, np.full(len(everybody), 1.72), 0.25)
    judged = JudgedFrame(ramp, np.ones(ramp.shape, bool), count_covering(ramp.shape, own))
    feet = feet_of(FLAT, np.column_stack((np.zeros(len(ALONG)), ALONG))[None])
    parts = feet_parts(judged, FLAT, own, everybody, feet, np.array([row]))
    return feet_scores(parts, feet)[0]


@pytest.mark.parametrize("away_m", [4.5, 5.5])
def test_feet_speak_for_where_legs_end(away_m: float) -> None:
    said = _said(_seen((0.0, away_m)), np.array([[0.0, away_m]]), 0)
    assert abs(ALONG[said.argmax()] - away_m) < 0.3
    assert said.max() > 0.5
    # Nearer there is nothing, farther away legs go on below.
    assert said[away_m - 1.0 > ALONG].max() < 0.1
    assert said[away_m + 1.0 < ALONG].max() < 0.2


def test_feet_of_who_stands_in_front_are_not_those_of_who_stands_behind() -> None:
    both = np.array([[0.0, 4.2], [0.0, 6.0]])
    ramp = _seen((0.0, 4.2))
    assert _said(ramp, both, 0).max() > 0.5
    assert np.abs(_said(ramp, both, 1)[ALONG < 5.0]).max() < 0.1


def test_feet_out_of_the_picture_say_nothing() -> None:
    below = np.array([[[0.0, 1.2]]])
    feet = feet_of(FLAT, below)
    own = standing_ellipses(FLAT.projection, below[0], np.array([1.72]), 0.25)
    ramp = np.full(FLAT.size[::-1], 255, np.uint8)
    judged = JudgedFrame(ramp, np.ones(ramp.shape, bool), count_covering(ramp.shape, own))
    parts = feet_parts(judged, FLAT, own, below[0], feet, np.array([0]))
    assert feet_scores(parts, feet)[0, 0] == 0.0


def test_new_people_begin_where_their_legs_end() -> None:
    ramp = _seen((0.0, 5.0))
    cells = FloorCells(FLAT, 1.72, 0.25)
    everywhere = np.ones(ramp.shape, bool)
    (place, *_) = find_candidates(ramp, everywhere, cells, np.zeros((0, 2)), everywhere)
    assert abs(place.xy[1] - 5.0) < 0.35


@pytest.mark.parametrize("away_m", [4.5, 5.5])
def test_a_gap_between_legs_makes_nobody_smaller_and_farther_away(away_m: float) -> None:
    """Of hypotheses with their heads at one place, the one that stands there is the best."""
    ramp = _seen((0.0, away_m))
    tall = 2.5 - (2.5 - 1.72) * ALONG / away_m
    axes = np.column_stack((np.zeros(len(ALONG)), ALONG))
    seen = standing_ellipses(FLAT.projection, axes[None], tall[None], 0.25)
    own = standing_ellipses(FLAT.projection, np.array([[0.0, away_m]]), np.array([1.72]), 0.25)
    judged = JudgedFrame(ramp, np.ones(ramp.shape, bool), count_covering(ramp.shape, own))
    windows = windows_of(judged, seen, own, LINES)
    balance = np.array([_BALANCE])
    with_legs, as_body = (
        ALONG[_gains(windows, seen, own, balance, np.array([legs])).argmax()]
        for legs in (True, False)
    )
    assert abs(with_legs - away_m) < 0.5
    assert as_body > with_legs
