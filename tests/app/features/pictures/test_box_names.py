"""Numbers of people in a picture hide no heads."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations

import pytest
from drawn_scenes import person, picture
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from PySide6.QtCore import QEvent, QRectF
from PySide6.QtWidgets import QApplication

from app.core.look.theme import scaled_font
from app.features.pictures import box_names

BOXES = st.tuples(
    st.integers(10, 280), st.integers(30, 150), st.integers(15, 50), st.integers(40, 85)
)


@pytest.fixture
def plates(monkeypatch, view):
    """Shows people, and tells whose plates were drawn where."""

    def shown(*people):
        drawn = {}
        monkeypatch.setattr(
            box_names, "draw_plate", lambda _, rect, text, *__: drawn.__setitem__(text, rect)
        )
        view.show_scene(picture(*people))
        view.grab()
        return drawn

    return shown


def head(view, box):
    whole = view.viewport.rect(QRectF(*box))
    return QRectF(whole.left(), whole.top(), whole.width(), 0.2 * whole.height())


@given(st.lists(BOXES, min_size=2, max_size=9))
@settings(max_examples=25, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_no_number_lies_on_a_head_or_another_number(view, plates, boxes):
    found = plates(*[person(number + 1, box) for number, box in enumerate(boxes)])
    assert found
    assert not any(a.intersects(b) for a, b in combinations(found.values(), 2))
    heads = [head(view, box).adjusted(0.1, 0.1, -0.1, -0.1) for box in boxes]
    assert not any(plate.intersects(one) for plate in found.values() for one in heads)


def test_a_number_stands_above_who_stands_alone(view, plates):
    box = (100, 100, 30, 80)
    (plate,) = plates(person(1, box)).values()
    whole = view.viewport.rect(QRectF(*box))
    assert whole.top() - 6 < plate.bottom() < whole.top()
    assert abs(plate.left() - whole.left()) < 3


def test_a_number_covers_nobody_where_there_is_room_elsewhere(view, plates):
    behind, before = (100, 60, 30, 80), (100, 145, 30, 80)
    found = plates(person(1, behind), person(2, before))
    assert not found["2"].intersects(view.viewport.rect(QRectF(*behind)))


def crowd(**changed):
    """Somebody amid others, whose heads are all around."""
    around = [(x, y, 22, 40) for x in range(80, 200, 22) for y in range(40, 160, 8)]
    people = [person(number + 2, box) for number, box in enumerate(around)]
    return [*people, person(1, (140, 100, 20, 40), **changed)]


def test_who_cannot_be_named_without_hiding_a_head_is_named_once_selected(plates):
    assert "1" not in plates(*crowd())
    assert "1" in plates(*crowd(selected=True))


def test_who_is_under_the_cursor_is_named(view, plates):
    assert "1" not in plates(*crowd())
    middle = view.viewport.rect(QRectF(140, 100, 20, 40)).center()
    view.cursor_at(middle)
    over = view.track_at(middle)
    assert str(over) in plates(*crowd())


def _middle(view, one):
    return view.viewport.rect(QRectF(*one.box)).center()


def _by_name(view, plates, people):
    """The middle of somebody who is pointed at there and named, and of one who is not named."""
    view._over = 0
    named = plates(*people)
    at = {one.track: _middle(view, one) for one in people}
    met = {track: place for track, place in at.items() if view.track_at(place) == track}
    with_name = next(place for track, place in met.items() if str(track) in named)
    without = next(place for track, place in met.items() if str(track) not in named)
    return with_name, without


@pytest.fixture
def asked(monkeypatch, view):
    """How often a view asked to be drawn anew."""
    times = []
    monkeypatch.setattr(view, "update", lambda *_: times.append(1))
    return times


def test_the_name_of_who_is_under_the_cursor_is_under_no_other(view, plates):
    people = [one for one in crowd() if one.track != 1]
    beside = [person(1, (one.box[0] + 1, one.box[1] + 1, 22, 40)) for one in people[::5]]
    met = 0
    for one in beside:
        view._over = 0
        if "1" in plates(*people, one) or view.track_at(_middle(view, one)) != 1:
            continue
        view.cursor_at(_middle(view, one))
        drawn = plates(*people, one)
        own = drawn.pop("1")
        met += 1
        assert not any(own.intersects(plate) for plate in drawn.values())
    assert met > 3


def test_a_name_shown_for_the_cursor_alone_goes_with_it(view, plates, asked):
    people = crowd()
    usual = plates(*people)
    with_name, without = _by_name(view, plates, people)
    for on in (with_name, view.viewport.rect(view.content()).topLeft() * 2):
        view.cursor_at(without)
        assert plates(*people) != usual
        asked.clear()
        view.cursor_at(on)
        assert asked
        assert plates(*people) == usual


def test_a_name_shown_for_the_cursor_alone_goes_when_the_cursor_leaves(view, plates, asked):
    people = crowd()
    usual = plates(*people)
    view.cursor_at(_by_name(view, plates, people)[1])
    assert plates(*people) != usual
    asked.clear()
    QApplication.sendEvent(view, QEvent(QEvent.Type.Leave))
    assert asked
    assert plates(*people) == usual


def test_pointing_at_somebody_named_draws_nothing_anew(view, plates, asked):
    people = crowd()
    with_name, _ = _by_name(view, plates, people)
    usual = plates(*people)
    asked.clear()
    view.cursor_at(with_name)
    QApplication.sendEvent(view, QEvent(QEvent.Type.Leave))
    assert not asked
    view.cursor_at(with_name)
    assert plates(*people) == usual


def test_over_a_handle_nobody_else_stays_named(view, plates):
    people = [*crowd(), person(99, (250, 150, 40, 80), movable=True, selected=True)]
    usual = plates(*people)
    view.cursor_at(_by_name(view, plates, people)[1])
    view.cursor_at(view.viewport.rect(QRectF(250, 150, 40, 80)).bottomRight())
    assert plates(*people) == usual


def test_a_long_name_gives_way_to_its_number(plates):
    wall = [person(2, (0, 2, 130, 230)), person(3, (180, 2, 139, 230))]
    assert "1" in plates(person(1, (136, 20, 40, 219), label="1 somebody in red"), *wall)


def test_numbers_are_smaller_in_a_small_picture(view, plates):
    box = (100, 100, 30, 80)
    (large,) = plates(person(1, box)).values()
    view.resize(290, 217)
    (small,) = plates(person(1, box)).values()
    assert small.width() < 0.85 * large.width()
    assert small.height() < 0.85 * large.height()


def test_a_number_stays_on_its_side_while_that_is_free(plates):
    above, other = (100, 100, 30, 80), (98, 60, 40, 39)
    first = plates(person(1, above), person(2, other))["1"]
    again = plates(person(1, above), person(2, (220, 60, 40, 39)))["1"]
    assert again == first


@pytest.fixture
def measured(monkeypatch, view):
    """How many plates were measured anew."""
    done = []
    size = box_names.plate_sizes
    monkeypatch.setattr(box_names, "plate_sizes", lambda *it: done.append(1) or size(*it))
    return done


def test_names_are_placed_once_for_a_picture_that_is_painted_again(view, plates, measured):
    people = crowd()
    places = [_middle(view, one) for one in people]
    plates(*people)
    measured.clear()
    for at in places[::9]:
        view.cursor_at(at)
        view.grab()
    assert not measured


@pytest.mark.parametrize(
    "change",
    [
        lambda view: view.zoom(1.1),
        lambda view: view.resize(600, 480),
        lambda view: view.setFont(scaled_font(view.font(), 1.3)),
        lambda view: view.show_scene(picture(*crowd(selected=True))),
        lambda view: view.show_scene(replace(view._scene, people=tuple(crowd()[:9]))),
    ],
    ids=["zoom", "size", "font", "selection", "people"],
)
def test_names_are_placed_anew_where_anything_is_another(view, plates, measured, change):
    plates(*crowd())
    measured.clear()
    change(view)
    view.grab()
    assert measured


def test_a_name_makes_way_for_a_message_about_the_same_people(view, plates):
    drawn = plates(person(1, (140, 234, 40, 5)))  # low down, where there is no other place
    assert drawn
    drawn.clear()
    view.show_scene(replace(view._scene, message="Frame 128 of this camera: the same instant"))
    view.grab()
    assert not drawn


def test_a_long_name_is_whole_where_it_hides_nobody_and_shortened_among_others(plates):
    name, box = "10 Brown jumper, umbrella", (100, 100, 30, 60)
    assert name in plates(person(10, box, label=name))
    row = [person(number, (x, 40, 10, 190)) for number, x in enumerate(range(20, 300, 14), 20)]
    assert name not in plates(person(10, box, label=name), *row)
