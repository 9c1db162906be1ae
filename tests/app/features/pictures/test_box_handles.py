import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QPoint, QPointF, QRectF
from PySide6.QtGui import QColor, QImage, QPainter

from app.features.pictures.box_handles import (
    INSIDE,
    Grip,
    draw_outline_beyond,
    handle_at,
    handles_of,
)

RECT = QRectF(100, 50, 80, 160)


@pytest.mark.parametrize(
    ("at", "handle"),
    [
        ((100, 50), (-1, -1)),
        ((181, 209), (1, 1)),
        ((140, 52), (0, -1)),
        ((178, 130), (1, 0)),
        ((140, 130), INSIDE),
        ((300, 130), None),
    ],
)
def test_the_nearest_handle_is_taken_else_the_inside(at, handle):
    assert handle_at(RECT, QPointF(*at)) == handle


def test_a_small_box_has_only_corners_so_that_it_can_still_be_moved():
    small = QRectF(0, 0, 14, 30)
    assert len(handles_of(small)) == 4
    assert handle_at(small, small.center()) == INSIDE


@pytest.mark.parametrize("size", [(26, 70), (14, 30), (30, 30)])
def test_all_of_a_small_box_moves_it_and_its_corners_are_held_from_outside(size):
    small = QRectF(100, 50, *size)
    near = [QPointF(small.left() + 3, y) for y in (small.top() + 6, small.center().y())]
    assert [handle_at(small, at) for at in near] == [INSIDE, INSIDE]
    assert handle_at(small, small.topLeft() - QPointF(4, 4)) == (-1, -1)
    assert handle_at(small, small.bottomRight()) == (1, 1)


def test_dragging_a_corner_over_the_opposite_one_turns_the_box_round():
    grip = Grip((1, 1), (10.0, 10.0, 20.0, 30.0), QPointF(30, 40))
    assert grip.moved_to(QPointF(5, 0)) == (5.0, 0.0, 5.0, 10.0)


@given(
    st.tuples(st.sampled_from((-1, 0, 1)), st.sampled_from((-1, 0, 1))),
    st.floats(-500, 500),
    st.floats(-500, 500),
)
def test_a_dragged_box_never_has_a_negative_size_and_the_inside_keeps_it(handle, dx, dy):
    box = (10.0, 20.0, 30.0, 60.0)
    moved = Grip(handle, box, QPointF(0, 0)).moved_to(QPointF(dx, dy))
    assert min(moved[2:]) >= 0
    if handle == INSIDE:
        assert moved == (10.0 + dx, 20.0 + dy, 30.0, 60.0)


def test_a_box_that_goes_beyond_the_picture_keeps_its_outline_with_its_handles(inked):
    shot = QImage(300, 300, QImage.Format.Format_RGB32)
    shot.fill(QColor(0, 0, 0))
    painter = QPainter(shot)
    draw_outline_beyond(painter, RECT, QColor(255, 0, 0), shown=QRectF(0, 0, 300, 120))
    painter.end()
    line = [QPoint(100, y) for y in range(125, 205, 10)]
    assert any(inked(shot, at, QColor(255, 0, 0)) for at in line)
    assert not any(inked(shot, QPoint(100, y), QColor(255, 0, 0)) for y in range(55, 115, 10))
