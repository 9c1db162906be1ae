"""Who is seen at the same time does not look alike, and nobody's colour changes."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.core.colours.co_occurrence import closeness, find_co_occurrences
from app.core.colours.colour_sight import alike, of_one_hue
from app.core.colours.palette import NOBODY, TRACK_COLOURS
from app.core.colours.shown_colours import THEMES, readable_colour
from app.core.colours.track_colours import TrackColours
from tracking.tracks import CORRECTED_COLUMNS, TrackTable

_ALIKE = {
    (a, b): much
    for a, row in zip(TRACK_COLOURS, alike(TRACK_COLOURS), strict=True)
    for b, much in zip(TRACK_COLOURS, row, strict=True)
}


def rows_of(stays, place=lambda track: (track * 1.5, 4.0)):
    """Rows by frame of tracks: id -> half-open frames in which it stands at its place."""
    frames = np.concatenate([np.arange(*stay) for stay in stays.values()])
    tracks = np.concatenate([np.full(b - a, one) for one, (a, b) in stays.items()])
    order = np.lexsort((tracks, frames))
    rows = {name: np.zeros(len(frames), kind) for name, kind in CORRECTED_COLUMNS.items()}
    rows["frame"], rows["track"] = frames[order], tracks[order]
    rows["x"], rows["y"] = np.array([place(one) for one in rows["track"].tolist()]).T
    return rows


def colours_of(stays, **where):
    return TrackColours().and_of(TrackTable(rows_of(stays, **where)))


def test_an_id_has_the_same_colour_alone_and_among_others():
    ids = np.arange(0, 40, dtype=np.int32)
    colours = colours_of({1: (0, 9), 25: (0, 9)})
    many = colours.of_all(ids)
    assert [tuple(row) for row in many.tolist()] == [colours.of(int(one)) for one in ids]


def test_who_cannot_have_the_usual_colour_gets_another_hue_rather_than_another_shade():
    colours = colours_of(dict.fromkeys(range(1, 8), (0, 9)), place=lambda one: (one / 5, 4.0))
    given = [colours.of(one) for one in range(1, 8)]
    hues = of_one_hue(given) - np.eye(len(given))
    moved = [place for place, one in enumerate(given) if one != TRACK_COLOURS[place]]
    assert moved
    assert hues[moved].max() < 0.5


def test_seven_people_of_any_ids_are_of_seven_hues():
    for first in range(1, 25):
        ids = range(first, first + 7)
        colours = colours_of(dict.fromkeys(ids, (0, 9)), place=lambda one: (one * 2.0, 4.0))
        hues = of_one_hue([colours.of(one) for one in ids]) - np.eye(7)
        assert hues.max() < 0.7, first


def test_nobody_is_grey():
    assert TrackColours().of(0) == NOBODY
    assert TrackColours().of_all(np.array([0, -3], np.int32)).tolist() == [list(NOBODY)] * 2


def test_ids_that_would_share_a_colour_differ_where_they_are_seen_together():
    stays = {one: (600 * one, 600 * one + 50) for one in range(1, len(TRACK_COLOURS) + 2)}
    apart = colours_of(stays)
    assert apart.of(1) == apart.of(25)
    together = colours_of({1: (0, 50), 25: (30, 80)})
    assert _ALIKE[together.of(1), together.of(25)] < 0.05


def test_nobody_shares_a_colour_where_there_are_fewer_people_than_colours():
    drawn = TrackColours()
    for track in (1, 2, 3, 26, 4, 25, 50):  # one after the other, never together
        drawn.meet_over(track, [])
    assert len({drawn.of(track) for track in (1, 2, 3, 26, 4, 25, 50)}) == 7


def test_who_comes_up_as_somebody_leaves_does_not_take_their_colour():
    colours = colours_of({1: (0, 50), 25: (60, 80)})
    assert colours.of(1) != colours.of(25)


@pytest.mark.parametrize("theme", THEMES)
def test_people_close_to_each_other_are_told_apart_as_a_theme_shows_them(theme):
    shown = alike([readable_colour(theme, one) for one in TRACK_COLOURS])
    places = {colour: place for place, colour in enumerate(TRACK_COLOURS)}
    pairs = [(a, b) for a in range(1, 25) for b in range(1, a)]
    for a, b in pairs:
        colours = colours_of({a: (0, 9), b: (0, 9)}, place=lambda one: (one / 99, 4.0))
        assert shown[places[colours.of(a)], places[colours.of(b)]] < 0.15, (a, b)


@settings(max_examples=20, deadline=None)
@given(st.lists(st.integers(1, 400), min_size=2, max_size=14, unique=True))
def test_fourteen_people_of_any_ids_are_told_apart(ids):
    colours = colours_of(dict.fromkeys(ids, (0, 20)))
    shown = [colours.of(one) for one in ids]
    assert max(_ALIKE[a, b] for i, a in enumerate(shown) for b in shown[:i]) < 0.55
    assert len(set(shown)) == len(ids)


def test_in_a_crowd_of_more_than_there_are_colours_who_is_near_differs():
    random = np.random.default_rng(5)
    places = random.uniform(0, 30, (61, 2))
    colours = colours_of(dict.fromkeys(range(1, 61), (0, 20)), place=lambda one: places[one])
    for one in range(1, 61):
        apart = np.linalg.norm(places[1:] - places[one], axis=1)
        apart[one - 1] = np.inf
        nearest = int(apart.argmin()) + 1
        assert colours.of(one) != colours.of(nearest)


def test_colours_given_while_a_tracker_works_stay_as_others_come_and_go():
    colours, given_first = TrackColours(), {}
    rows = rows_of({one: (10 * one, 10 * one + 60) for one in range(1, 60)})
    for frame in range(10, 650):
        inside = rows["frame"] == frame
        colours.meet({name: column[inside] for name, column in rows.items()})
        here = rows["track"][inside].tolist()
        for one in here:
            assert colours.of(one) == given_first.setdefault(one, colours.of(one))
        assert len({colours.of(one) for one in here}) == len(here)


@pytest.mark.parametrize("place", [lambda _: (np.nan, np.nan), lambda one: (one, one)])
def test_people_without_places_on_a_floor_have_colours_too(place):
    colours = colours_of({1: (0, 9), 2: (0, 9), 25: (3, 9)}, place=place)
    assert len({colours.of(one) for one in (1, 2, 25)}) == 3


def test_colours_do_not_depend_on_the_order_of_rows_within_a_frame():
    random = np.random.default_rng(4)
    for crowd in range(8):
        places = {one: random.uniform(0, 3, 2) for one in range(1, 13)}
        rows = rows_of(dict.fromkeys(places, (0, 5)), place=places.__getitem__)
        mixed = np.lexsort((random.random(len(rows["frame"])), rows["frame"]))
        given = find_co_occurrences(rows).nearness
        again = find_co_occurrences({name: column[mixed] for name, column in rows.items()}).nearness
        assert {one: near[0].tolist() for one, near in given.items()} == {
            one: near[0].tolist() for one, near in again.items()
        }, crowd


def test_nobody_is_near_to_one_who_is_not_in_the_frame():
    rows = rows_of({1: (0, 1), 2: (0, 1)})
    assert closeness(rows, 7) == {}
    assert list(closeness(rows, 1)) == [2]
