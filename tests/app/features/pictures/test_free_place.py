"""Words stand beside somebody where they hide nobody."""

from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QRectF, QSizeF

from app.core.drawing.free_place import free_place

AREA = QRectF(0, 0, 800, 600)
SIZE = QSizeF(160, 70)
PERSON = QRectF(300, 200, 40, 120)


def test_words_stand_right_of_a_person_who_is_alone():
    place, hidden = free_place(SIZE, PERSON, [], AREA)
    assert hidden == 0.0
    assert place.left() > PERSON.right()
    assert PERSON.top() <= place.center().y() <= PERSON.bottom()


def test_words_go_to_the_other_side_of_whom_they_would_hide():
    place, hidden = free_place(SIZE, PERSON, [QRectF(360, 190, 50, 130)], AREA)
    assert hidden == 0.0
    assert place.right() < PERSON.left()


def test_at_the_right_edge_words_stand_left():
    person = QRectF(755, 200, 40, 120)
    place, hidden = free_place(SIZE, person, [], AREA)
    assert (hidden, place.right() < person.left()) == (0.0, True)


def test_where_there_is_no_room_it_is_told_how_much_is_hidden():
    place, hidden = free_place(SIZE, PERSON, [AREA], AREA)
    assert AREA.contains(place)
    assert hidden >= SIZE.width() * SIZE.height()


@given(st.lists(st.tuples(st.floats(0, 760), st.floats(0, 480)), max_size=6))
def test_among_a_few_people_words_hide_none(corners):
    people = [QRectF(x, y, 40, 120) for x, y in corners]
    place, hidden = free_place(SIZE, PERSON, people, AREA)
    assert AREA.contains(place)
    assert hidden == 0.0
    assert not any(place.intersects(person) for person in [PERSON, *people])
