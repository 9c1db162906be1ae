"""Numbers of people in a picture hide no heads."""

from __future__ import annotations

from itertools import combinations

import pytest
from drawn_scenes import person, picture
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from PySide6.QtCore import QRectF

from app.presenters.scenes import Eye
from app.views.pictures import box_names
from app.views.pictures.picture import PictureView

BOXES = st.tuples(
    st.integers(10, 280), st.integers(30, 150), st.integers(15, 50), st.integers(40, 85)
)


@pytest.fixture
def view(qtbot, dark):
    widget = PictureView(Eye.LEFT)
    qtbot.addWidget(widget)
    widget.resize(640, 480)
    widget.show_scene(picture())
    widget.grab()
    return widget


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
