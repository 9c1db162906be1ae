"""The border of the timeline: seen, told of, and moved with the mouse."""

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QSplitter, QWidget

from app.core.widgets.gripped_splitter import GrippedSplitter


@pytest.fixture
def splitter(qtbot) -> GrippedSplitter:
    splitter = GrippedSplitter(Qt.Orientation.Vertical, "Drag it", None)
    qtbot.addWidget(splitter)
    for _ in range(2):
        splitter.addWidget(QWidget())
    splitter.resize(300, 200)
    splitter.show()
    return splitter


def test_the_border_is_high_enough_to_be_hit_and_says_what_it_is_for(splitter):
    border = splitter.handle(1)
    assert border.height() >= 6
    assert border.toolTip() == border.accessibleName() == "Drag it"


def test_its_grip_is_seen_in_the_middle(splitter):
    border = splitter.handle(1)
    picture = border.grab().toImage()
    row = [picture.pixel(x, picture.height() // 2) for x in range(picture.width())]
    others = [x for x, colour in enumerate(row) if colour != row[5]]
    assert others
    assert 100 < min(others) < picture.width() // 2 < max(others) < 200


def test_dragging_it_makes_the_part_below_higher(splitter, qtbot):
    border, below = splitter.handle(1), splitter.widget(1)
    before, at = below.height(), border.rect().center()
    qtbot.mousePress(border, Qt.MouseButton.LeftButton, pos=at)
    qtbot.mouseMove(border, at - QPoint(0, 40))
    qtbot.mouseRelease(border, Qt.MouseButton.LeftButton, pos=at - QPoint(0, 40))
    assert below.height() > before


def test_a_layout_kept_by_an_older_program_leaves_the_border_as_high(splitter, qtbot):
    older = QSplitter(Qt.Orientation.Vertical)
    qtbot.addWidget(older)
    older.setHandleWidth(1)
    for _ in range(2):
        older.addWidget(QWidget())
    assert splitter.restoreState(older.saveState())
    assert splitter.handle(1).height() >= 6
