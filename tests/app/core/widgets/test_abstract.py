"""Kinds of widgets that define all they must."""

import pytest

from app.core.drawing.canvas import Canvas
from app.features.pictures.overhead_view import OverheadView


def test_a_widget_of_no_kind_is_not_made(qtbot):
    with pytest.raises(TypeError, match=r"Canvas does not define .*paint"):
        Canvas(upward=True)


def test_one_that_defines_all_is(qtbot):
    view = OverheadView()
    qtbot.addWidget(view)
    assert isinstance(view, Canvas)
