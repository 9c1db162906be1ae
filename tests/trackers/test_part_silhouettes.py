"""What the silhouettes of people say of their parts, their height and of pieces of them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from people_of_three_blocks import GREEN_BROWN, HEIGHT, RED_BLUE, Blocks, observations, walking

from tracking.people.observation import Observation
from tracking.people.parts import ycbcr
from tracking.trackers.three_part.births import without_pieces
from tracking.trackers.three_part.bodies import outlined_boxes
from tracking.trackers.three_part.claims import claims_of, is_sharing, seen_taller, seen_whole
from tracking.trackers.three_part.initiation import begin_people, regions_rectangles
from tracking.trackers.three_part.people import Layout, PartPeople
from tracking.trackers.three_part.reidentification import reidentify
from tracking.trackers.three_part.silhouettes import drawn_home, legs_elsewhere
from tracking.tracks import HEAD, HIP_LEG

LAYOUT = Layout(parts=3, together=1)
TALL = np.array([float(HEIGHT)])


@pytest.fixture
def seen() -> Observation:
    """One person, standing still."""
    return next(observations([Blocks(walking((120.0, 60.0), (0.0, 0.0)), RED_BLUE)], 1))


def _followed(seen: Observation, moved: tuple[int, float] | None = None) -> PartPeople:
    """The person, all parts in place, or one of them moved up by px."""
    assert seen.picture is not None
    picture = ycbcr(seen.picture)
    rectangles = regions_rectangles(seen.people, np.array([0]), picture, LAYOUT)
    if moved is not None:
        rectangles[0, moved[0], 1] -= moved[1]
    random = np.random.default_rng(1)
    people = begin_people(
        np.array([1], np.int32), rectangles, np.zeros((1, 2)), picture, LAYOUT, random
    )
    return people.replace(height=TALL)


def _legs(seen: Observation, people: PartPeople) -> tuple[bool, np.ndarray]:
    assert seen.picture is not None
    claims = claims_of(people.rectangles, seen.people)
    off, belong = legs_elsewhere(people, seen.people, claims, ycbcr(seen.picture))
    return bool(off[0]), belong[0]


def test_legs_in_their_place_stay_there(seen: Observation) -> None:
    off, belong = _legs(seen, _followed(seen))
    assert not off
    assert belong == pytest.approx(_followed(seen).rectangles[0, HIP_LEG])


def test_legs_that_slid_up_the_body_belong_below_the_hip(seen: Observation) -> None:
    right = _followed(seen).rectangles[0, HIP_LEG]
    off, belong = _legs(seen, _followed(seen, (HIP_LEG, 30.0)))
    assert off
    assert belong == pytest.approx(right)


def test_legs_that_grew_over_the_body_are_lost(seen: Observation) -> None:
    people = _followed(seen)
    state = people.state.copy()
    state[0, HIP_LEG, 2:4] *= 2.5
    assert _legs(seen, people.replace(state=state))[0]


def test_nothing_is_said_of_legs_at_the_picture_s_edge(seen: Observation) -> None:
    cut = replace(seen, people=replace(seen.people, truncated=np.array([True])))
    off, belong = _legs(cut, _followed(cut, (HIP_LEG, 30.0)))
    assert not off
    assert np.isnan(belong).all()


def test_who_was_begun_without_feet_is_seen_to_be_taller(seen: Observation) -> None:
    claims = claims_of(_followed(seen).rectangles, seen.people)
    for share, taller, whole in ((1.0, False, True), (0.7, True, False), (0.5, False, False)):
        assert seen_taller(claims, seen.people, share * TALL).tolist() == [taller]
        assert seen_whole(claims, seen.people, share * TALL).tolist() == [whole]


def test_a_low_region_within_somebody_s_reach_is_a_piece_of_them(seen: Observation) -> None:
    box = np.array([[120.0, 60.0, 32.0, 100.0]])
    free = np.array([0])
    assert without_pieces(free, seen.people, box, TALL).tolist() == [0]
    regions = seen.people.regions.copy()
    regions[100:] = 0
    low = replace(seen.people, regions=regions)
    assert without_pieces(free, low, box, TALL).tolist() == []
    assert without_pieces(free, low, box + np.array([150.0, 0, 0, 0]), TALL).tolist() == [0]
    assert without_pieces(free, low, np.zeros((0, 4)), np.zeros(0)).tolist() == [0]


@pytest.mark.parametrize(("clothes", "goes"), [(GREEN_BROWN, True), (RED_BLUE, False)])
def test_who_stands_in_somebody_else_goes_to_where_their_own_clothes_are(
    clothes: tuple[tuple[int, int, int], ...], goes: bool
) -> None:
    first = Blocks(walking((120.0, 60.0), (0.0, 0.0)), RED_BLUE)
    second = Blocks(walking((170.0, 60.0), (0.0, 0.0)), clothes)
    both = next(observations([first, second], 1))
    assert both.picture is not None
    picture, ids, still = ycbcr(both.picture), np.array([1, 2], np.int32), np.zeros((2, 2))
    places = regions_rectangles(both.people, np.arange(2), picture, LAYOUT)
    people = begin_people(ids, places, still, picture, LAYOUT, np.random.default_rng(1))
    state = people.state.copy()
    state[1] = state[0]
    people = people.replace(state=state, height=np.full(2, float(HEIGHT)))
    claims = claims_of(people.rectangles, both.people)
    two = is_sharing(claims, both.people)
    assert two.tolist() == [True, True]
    boxes = outlined_boxes(people.rectangles, people.outline)
    free = np.array([1], np.intp)
    lost = np.zeros(2, bool)
    found, left = reidentify(people, boxes, lost, two, both.people, free, picture, LAYOUT)
    assert np.isfinite(found).all(axis=(1, 2)).tolist() == [False, goes]
    assert len(left) == (not goes)


def test_a_head_slid_down_is_drawn_up_to_its_place_with_its_particles(seen: Observation) -> None:
    assert seen.picture is not None
    right, slid = _followed(seen), _followed(seen, (HEAD, -8.0))
    claims = claims_of(slid.rectangles, seen.people)
    drawn = drawn_home(slid, seen.people, claims, ycbcr(seen.picture), 0.05, LAYOUT)
    step = drawn.rectangles - slid.rectangles
    assert -7.0 < step[0, HEAD, 1] < -1.0
    assert drawn.rectangles[0, 1:] == pytest.approx(right.rectangles[0, 1:])
    moved = (drawn.clouds.state - slid.clouds.state)[drawn.clouds.owner == HEAD, 0, 1]
    assert moved == pytest.approx(step[0, HEAD, 1], abs=1e-4)
