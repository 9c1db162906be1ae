"""The room of the review queue: further reasons keep to their lines, the current row is seen."""

from __future__ import annotations

from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QFont, QFontMetricsF

from app.core.scenes.queue_rows import ReviewPerson, ReviewRow
from app.core.widgets import queue_list
from app.core.widgets.queue_list import row_height, shown_time
from app.features.review.panel import ReviewPanel
from app.features.review.scene import ReviewScene

WORDS = "2 and 8 were seen as one for 0.8 s until 00:18; "
ITEMS = tuple(
    ReviewRow(("margin", (1, 2), at), "Close association", (), at, "00:01", WORDS, (), 0.2)
    for at in range(40)
)


def shown(qtbot, scene: ReviewScene) -> ReviewPanel:
    panel = ReviewPanel()
    qtbot.addWidget(panel)
    panel.show_scene(scene)
    panel.resize(330, 380)
    with qtbot.waitExposed(panel):
        panel.show()
    return panel


def test_further_reasons_take_three_lines_however_many_they_are(qtbot, dark):
    scene = ReviewScene(items=ITEMS, current=0, left=40, also=WORDS)
    panel = shown(qtbot, scene)
    list_height = panel._list.height()
    panel.show_scene(replace(scene, also=9 * WORDS))
    assert panel._list.height() == list_height
    assert panel._list.geometry().bottom() < panel._also.geometry().top()
    assert len(panel._also.lines()) == 3
    assert panel._also.lines()[2].endswith("\u2026")
    assert panel._also.toolTip() == 9 * WORDS


def test_until_a_review_item_is_looked_at_its_room_is_for_rows(qtbot, dark):
    panel = shown(qtbot, ReviewScene(items=ITEMS, left=40))
    panel.resize(330, 420)
    qtbot.wait(1)
    rows = panel._list.viewport().height()
    panel.show_scene(ReviewScene(items=ITEMS, current=0, left=40, also=WORDS))
    qtbot.waitUntil(lambda: panel._list.viewport().height() < rows)
    assert panel._also.isVisible()


@pytest.mark.parametrize(
    "names", [("2", "16"), ("2 somebody in a red coat", "16 in a long blue one")]
)
def test_a_narrow_row_names_all_it_is_about(qtbot, dark, monkeypatch, names):
    people = tuple(
        ReviewPerson(n, name, (200, 80, 40)) for n, name in zip((2, 16), names, strict=True)
    )
    item = replace(ITEMS[0], title="Directions swap", people=people, when="00:22.20")
    panel = shown(qtbot, ReviewScene(items=(item,), left=1))
    panel.resize(230, 380)
    drawn = []

    def draw(painter, place, text):
        metrics, mode = painter.fontMetrics(), Qt.TextElideMode.ElideRight
        drawn.append((text, place, metrics.elidedText(text, mode, int(place.width()))))

    monkeypatch.setattr(queue_list, "_draw_elided", draw)
    panel._list.grab()
    (_, first, two), (_, second, sixteen) = (one for one in drawn if one[0][0].isdigit())
    assert (two[0], sixteen[:2]) == ("2", "16")
    assert first.right() < second.left()
    assert second.right() <= panel._list.viewport().width() - 60  # where the time stands


def test_a_title_that_has_room_is_not_cut(qtbot, dark, monkeypatch):
    people = tuple(ReviewPerson(n, str(n), (200, 80, 40)) for n in (2, 16))
    panel = shown(qtbot, ReviewScene(items=(replace(ITEMS[0], people=people),), left=1))
    seen = []

    def draw(painter, place, text):
        mode = Qt.TextElideMode.ElideRight
        seen.append(painter.fontMetrics().elidedText(text, mode, int(place.width())))

    monkeypatch.setattr(queue_list, "_draw_elided", draw)
    panel._list.grab()
    assert seen == ["Close association", "2", "16"]


def test_a_short_name_leaves_its_room_to_a_long_one():
    assert queue_list.shares([10, 90], 60) == [10, 50]
    assert queue_list.shares([80, 90], 60) == [30, 30]
    assert queue_list.shares([20, 30], 60) == [20, 30]


def test_no_row_of_the_queue_is_cut(qtbot, dark):
    panel = shown(qtbot, ReviewScene(items=ITEMS, left=40))
    high = row_height(panel._list.font(), 2)
    for height in range(380, 380 + high, 7):
        panel.resize(330, height)
        qtbot.wait(1)
        assert panel._list.viewport().height() % high == 0
        assert panel._list.viewport().height() >= high


def test_the_current_row_stays_in_sight_as_the_room_changes(qtbot, dark):
    scene = ReviewScene(items=ITEMS, current=30, left=40)
    panel = shown(qtbot, scene)

    def in_sight() -> bool:
        row = panel._list.visualRect(panel._model.index(30))
        return panel._list.viewport().rect().contains(row)

    assert in_sight()
    panel.resize(330, 700)
    assert in_sight()
    panel.resize(330, 380)
    panel.show_scene(replace(scene, also=WORDS, meter="12 decided"))
    qtbot.waitUntil(in_sight)


def test_a_reason_stands_on_two_lines_below_what_and_when(qtbot, dark):
    panel = shown(qtbot, ReviewScene(items=ITEMS, left=40))
    row = panel._list.visualRect(panel._model.index(0)).height()
    assert row >= row_height(panel._list.font(), 2)
    assert panel._list.viewport().height() >= 3 * row


def test_without_a_list_the_panel_is_as_high_as_all_its_words(qtbot, dark):
    panel = shown(qtbot, ReviewScene(items=ITEMS, left=40))
    panel.show_scene(ReviewScene(title="Nothing left", text=5 * WORDS))
    panel.resize(240, 400)
    qtbot.wait(1)
    assert panel._text.height() >= panel._text.heightForWidth(panel._text.width())
    assert panel.maximumHeight() < 400


def test_however_long_the_words_below_are_rows_keep_clear_of_the_buttons(qtbot, dark):
    panel = shown(qtbot, ReviewScene(items=ITEMS, current=0, left=40, also=WORDS))
    panel.set_actions([(QAction("Fix", panel), "Fix")])
    panel.show_scene(replace(panel._scene, meter=3 * WORDS))
    panel.resize(300, panel.minimumSizeHint().height())
    panel.resize(300, panel.minimumSizeHint().height())  # of the width it has by now
    panel.layout().activate()
    assert panel._meter.height() >= panel._meter.heightForWidth(panel._meter.width())
    assert panel._list.geometry().bottom() < panel._tools[0].geometry().top()
    assert panel._tools[0].geometry().bottom() < panel._also.geometry().top()


def test_the_queue_of_another_session_begins_at_its_top(qtbot, dark):
    panel = shown(qtbot, ReviewScene(items=ITEMS, left=40))
    bar = panel._list.verticalScrollBar()
    bar.setValue(bar.maximum() // 2)
    panel.show_scene(ReviewScene())  # nothing is open
    panel.show_scene(ReviewScene(items=tuple(ITEMS[:30]), left=30))
    qtbot.wait(1)
    assert panel._list.verticalScrollBar().value() == 0


def test_the_queue_keeps_its_place_as_an_edit_changes_it(qtbot, dark):
    panel = shown(qtbot, ReviewScene(items=ITEMS, left=40))
    bar = panel._list.verticalScrollBar()
    bar.setValue(9)
    panel.show_scene(ReviewScene(items=tuple(ITEMS[:39]), left=39))
    qtbot.wait(1)
    assert bar.value() == 9


def test_of_a_span_without_room_its_begin_is_told_so_that_kind_and_people_are_whole(qtbot):
    metrics = QFontMetricsF(QFont())
    when = "00:02.33 to 00:04.50"
    whole = metrics.horizontalAdvance(when)
    assert shown_time(metrics, when, whole) == when
    assert shown_time(metrics, when, whole - 1) == "00:02.33\u2026"
    assert shown_time(metrics, "00:02.33", 1.0) == "00:02.33"
