"""The panel of an edit that waits for Enter."""

from __future__ import annotations

from dataclasses import replace

import pytest
from panel_words import words
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton

from app.core.scenes import ChoiceRow, EditPreview, Proposal
from app.features.correction.panel import EditPanel

SWAP = EditPreview(
    "Swap 4 and 7 from frame 834 on",
    ("91 frames change",),
    834,
    end=850,
    choices=(ChoiceRow(0, "Scope", ("from here on", "this range", "this frame"), 0, "R"),),
    other=7,
    others=(Proposal(7, "7", True, (40, 80, 220)), Proposal(9, "9", False, (220, 40, 40))),
    cuts=(Proposal(0, "834", True, None, "they meet"), Proposal(1, "790", False, None, "near")),
)

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def preview(qtbot, dark):
    bar = EditPanel()
    qtbot.addWidget(bar)
    bar.show_scene(SWAP)
    return bar


def press(bar, name: str, qtbot):
    buttons = bar.findChildren(QAbstractButton)
    qtbot.mouseClick(next(one for one in buttons if one.accessibleName() == name), LEFT)


def test_a_preview_tells_what_where_and_how_far(preview):
    (row,) = SWAP.choices
    for part in (SWAP.title, "91 frames change", "834", "849", "790", *row.options):
        assert part in words(preview)


def test_a_preview_is_done_left_moved_and_widened(preview, qtbot, heard):
    signals = ("confirmed", "cancelled", "cut_moved", "end_moved", "other_typed", "cut_proposed")
    said = [heard(getattr(preview, name)) for name in signals]
    choices = heard(preview.choice_made)
    for name in (
        "Apply the edit",
        "Cancel the edit",
        "From a frame earlier",
        "to a frame later",
        "9",
        "Swapped at 790 near",
        "this range",
    ):
        press(preview, name, qtbot)
    assert said == [[()], [()], [-1], [1], [9], [1]]
    assert choices == [(0, 1)]


def test_while_the_other_person_is_to_be_picked_nothing_can_be_done_yet(preview):
    preview.show_scene(
        EditPreview("Swap 4 with...", ("Pick the other person",), 834, other=0, ready=False)
    )
    assert "Pick the other person" in words(preview)
    assert not preview._confirm.isEnabled()
    assert preview._frames.isHidden()


def test_without_a_preview_the_bar_is_hidden(preview):
    preview.show_scene(None)
    assert preview.isHidden()


def test_the_other_persons_id_can_be_typed(preview, qtbot, heard):
    typed = heard(preview.other_typed)
    preview.show_scene(EditPreview("Swap 4 with...", (), 834, other=0, ready=False))
    QTest.keyClicks(preview._other, "12x")
    qtbot.keyClick(preview._other, Qt.Key.Key_Return)
    assert typed == [12]


def test_an_edit_without_a_cut_cannot_be_moved(preview):
    preview.show_scene(replace(SWAP, has_cut=False, other=None))
    assert preview._frames.isHidden()
    assert preview._other_line.isHidden()
    assert not preview._confirm.isHidden()


def test_what_the_trails_of_a_preview_mean_is_said_once_there_are_any(preview):
    assert not preview._legend.isHidden()
    preview.show_scene(replace(SWAP, ready=False, other=0))
    assert preview._legend.isHidden()


def test_the_frame_is_said_as_the_begin_only_where_the_edit_begins_there(preview):
    assert "From" in words(preview)
    preview.show_scene(replace(SWAP, begins=False))
    assert "At" in words(preview)
    assert "From" not in words(preview)


def test_an_id_is_given_to_and_swapped_with(preview):
    assert "With" in words(preview)
    preview.show_scene(replace(SWAP, gives=True))
    assert "To" in words(preview)
