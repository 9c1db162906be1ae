"""The panel of the score."""

from dataclasses import replace
from itertools import product

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from app.core.scenes.score_figures import FIGURES, ScoreRow
from app.features.scoring.panel import ScorePanel
from app.features.scoring.scene import ErrorChoice, ScoreScene
from tracking.scoring import ErrorKind

SCENE = ScoreScene(
    truths=("truth.txt beside the recording", "Choose a file..."),
    truth=0,
    results=("Corrected tracks", "Run 0: flow"),
    result=0,
    on_floor=False,
    threshold=0.5,
    rows=(
        ScoreRow("HOTA", "hint", "0.670", "0.700", "\u25b2 +0.010", 1),
        ScoreRow("Misses", "hint", "58", "3", "\u25b2 +2", -1),
    ),
    whole="0 to 299",
    visible="100 to 199",
    moved="Last edit: Delete track 3",
    errors=tuple(ErrorChoice(kind, kind.name, 4, True) for kind in ErrorKind),
)

MARGINS_PX = 20
"""Within a cell: else its words end in an ellipsis."""


@pytest.fixture
def panel(qtbot, theme):
    widget = ScorePanel()
    qtbot.addWidget(widget)
    widget.resize(560, 480)
    widget.show_scene(SCENE)
    return widget


def test_what_is_better_is_green_and_what_is_worse_red(panel, theme):
    better, worse = panel.table.item(0, 3), panel.table.item(1, 3)
    assert better.foreground().color() == theme.good
    assert worse.font().bold()
    assert not better.font().bold()
    assert worse.toolTip().startswith("worse")
    assert worse.foreground().color() == theme.danger
    assert better.data(Qt.ItemDataRole.AccessibleTextRole) == "\u25b2 +0.010 better"


@pytest.mark.parametrize(("width", "height"), [(690, 225), (540, 225), (450, 274)])
def test_at_the_size_it_has_on_a_small_screen_all_eleven_figures_are_in_sight(
    panel, qtbot, width, height
):
    names = [one.name for one in FIGURES]
    rows = tuple(
        replace(SCENE.rows[0], name=one.name, short=one.short, whole="100.0%") for one in FIGURES
    )
    panel.show_scene(replace(SCENE, rows=rows, moved=""))
    panel.resize(width, height)
    with qtbot.waitExposed(panel):
        panel.show()
    table, seen = panel.table, []
    for line, column in product(range(table.rowCount()), range(0, table.columnCount(), 4)):
        item, cell = table.item(line, column), table.visualRect(table.model().index(line, column))
        if item is not None:
            seen.append(item.toolTip().split("\n")[0])
            room = table.viewport().rect()
            assert cell.bottom() <= room.bottom()
            assert cell.right() <= room.right()
            assert cell.width() >= table.fontMetrics().horizontalAdvance(item.text()) + MARGINS_PX
    assert sorted(seen) == sorted(names)
    assert {"People kept", "Position error (median)"} <= set(names[:5])


def test_in_a_narrow_panel_columns_go_before_names_are_cut(panel, qtbot):
    rows = tuple(
        replace(SCENE.rows[0], name=one.name, short=one.short, whole="100.0%") for one in FIGURES
    )
    panel.show_scene(replace(SCENE, rows=rows, moved=""))
    panel.resize(330, 520)
    with qtbot.waitExposed(panel):
        panel.show()
    table = panel.table
    assert table.groups == 1
    for line, column in product(range(table.rowCount()), range(0, table.columnCount(), 4)):
        item = table.item(line, column)
        if item is not None:
            wide = table.fontMetrics().horizontalAdvance(item.text()) + MARGINS_PX
            assert table.columnWidth(column) >= wide
            assert not table.isColumnHidden(column + 1)


def test_all_frames_and_those_shown_stand_beside_each_other(panel):
    assert [panel.table.item(0, column).text() for column in (1, 2)] == ["0.670", "0.700"]
    assert panel.table.horizontalHeaderItem(2).toolTip() == "frames 100 to 199"


def test_choices_are_told_and_showing_them_is_no_choice(panel, heard):
    said = [heard(signal) for signal in (panel.threshold_chosen, panel.floor_chosen)]
    kinds = heard(panel.kind_shown)
    panel.show_scene(replace(SCENE, on_floor=True, threshold=0.8))
    assert said == [[], []]
    assert panel._threshold.suffix() == " m"
    panel._threshold.setValue(1.2)
    panel._way.activated.emit(0)
    panel._kinds[ErrorKind.MISS].click()
    assert said == [[1.2], [False]]
    assert kinds == [(ErrorKind.MISS, False)]


def test_while_the_first_score_is_worked_out_the_figures_have_their_places(panel):
    panel.show_scene(replace(SCENE, rows=tuple(map(_empty, FIGURES)), doing=""))
    wanted = panel.sizeHint()
    panel.show_scene(replace(SCENE, rows=(), doing="Scoring..."))
    assert not panel.table.isHidden()
    assert not panel._report.isEnabled()
    assert panel.table.item(0, 0).text() == "HOTA"
    assert panel.sizeHint() == wanted


def _empty(figure):
    return ScoreRow(figure.name, figure.hint, "", "", short=figure.short)


def test_without_a_truth_it_is_said_what_to_do(panel):
    panel.show_scene(replace(SCENE, rows=(), truth=-1, message="choose a file", moved=""))
    assert panel._message.text() == "choose a file"
    assert panel.table.isHidden()
    assert panel._moved.isHidden()


def test_without_a_scene_it_is_hidden(panel):
    panel.show_scene(None)
    assert panel.isHidden()


def test_what_has_no_room_in_a_list_ends_in_an_ellipsis_and_the_tooltip_says_it_all(panel):
    panel._truth.setFixedWidth(120)
    shown = panel._truth.shown_text()
    assert shown.startswith("truth")
    assert shown.endswith("\u2026")
    assert panel._truth.toolTip() == "Ground truth\ntruth.txt beside the recording"


@pytest.mark.parametrize("width", [560, 900, 1400])
def test_the_truth_is_named_whole_where_there_is_room(panel, qtbot, width):
    panel.resize(width, 480)
    panel.show()
    qtbot.waitUntil(panel.isVisible)
    assert panel._truth.shown_text() == "truth.txt beside the recording"


def test_a_limit_that_is_being_typed_stays_while_a_score_comes_in(panel, qtbot):
    field, chosen = panel._threshold, []
    panel.threshold_chosen.connect(chosen.append)
    with qtbot.waitActive(panel):
        panel.show()
        panel.activateWindow()
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, "0.")
    panel.show_scene(replace(SCENE, whole="0 to 99"))
    QTest.keyClicks(field, "8")
    QTest.keyClick(field, Qt.Key.Key_Return)
    assert chosen == [0.8]
