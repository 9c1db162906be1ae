"""Corners of shapes are dragged, also while shapes come and go."""

import pytest
from drawn_scenes import picture
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.core.scenes import Side
from app.features.labelling.shapes import ShapesLayer
from app.features.pictures.picture_view import PictureView

FIRST = ((20.0, 20.0), (60.0, 20.0), (60.0, 60.0))
SECOND = ((80.0, 20.0), (110.0, 20.0), (110.0, 60.0))
BOTH = {0: FIRST, 1: SECOND}
LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def layer(qtbot, dark):
    view = PictureView(Side.LEFT)
    qtbot.addWidget(view)
    view.resize(300, 240)
    view.show_scene(picture())
    view.show()
    layer = ShapesLayer(view)
    layer.begin()
    show(layer, BOTH)
    return layer


def show(layer, shapes):
    layer.show_shapes(shapes, closed=True, colour=(255, 255, 255))


def at(layer, corner):
    return layer.canvas.viewport.point(*corner).toPoint()


def dragged(layer, corner, meanwhile):
    """What is told where a corner is dragged and the shapes change meanwhile."""
    told = []
    layer.reshaped.connect(lambda number, corners: told.append((number, corners)))
    QTest.mousePress(layer, LEFT, pos=at(layer, corner))
    QTest.mouseMove(layer, at(layer, (corner[0] + 10, corner[1] + 8)))
    show(layer, meanwhile)
    QTest.mouseRelease(layer, LEFT, pos=at(layer, corner))
    return told


@pytest.mark.parametrize("meanwhile", [BOTH, {1: SECOND, 0: FIRST}])
def test_a_corner_is_dragged_while_all_shapes_are_shown_again(layer, meanwhile):
    ((number, corners),) = dragged(layer, FIRST[0], meanwhile)
    assert number == 0
    assert corners[1:] == FIRST[1:]
    assert corners[0] != FIRST[0]


@pytest.mark.parametrize("meanwhile", [{}, {0: SECOND}, {1: SECOND}, {0: SECOND, 1: FIRST}])
def test_a_corner_whose_shape_is_gone_or_another_one_is_let_go(layer, meanwhile):
    assert dragged(layer, FIRST[0], meanwhile) == []
