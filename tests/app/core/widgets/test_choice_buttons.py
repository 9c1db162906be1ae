"""Joined buttons stand in as many rows as their words need."""

import pytest
from PySide6.QtWidgets import QToolButton

from app.core.scenes import ChoiceRow
from app.core.widgets.choices import ChoiceButtons


@pytest.mark.parametrize(
    ("options", "rows"),
    [
        (("one", "two", "three"), 1),
        (("from here on", "this range", "this frame", "the whole track"), 2),
        (("ここから先", "この範囲", "このフレーム", "トラック全体"), 2),
    ],
)
def test_wide_letters_have_the_room_of_two(qapp, options, rows):
    choices = ChoiceButtons()
    choices.show_scene(ChoiceRow(0, "Scope", options, 0, "R"))
    choices.show()
    choices.adjustSize()
    qapp.processEvents()
    buttons = choices.findChildren(QToolButton)
    assert [one.text() for one in buttons] == list(options)
    assert len({one.y() for one in buttons}) == rows
