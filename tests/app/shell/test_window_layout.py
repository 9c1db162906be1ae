"""How the room of an ordinary screen is shared."""

import pytest
from opened_session import laid_out, open_with_anna
from PySide6.QtWidgets import QApplication

from app.core.scenes.queue_rows import ReviewRow
from app.features.history.panel import HistoryPanel
from app.features.review import review_search
from app.features.review.scene import ReviewScene
from app.features.scoring.controller import ScoreController
from app.features.scoring.panel import ScorePanel
from app.features.timeline.rows import Arrangement, LaneHeight, LaneOrder
from app.shell.main_window import MainWindow
from tracking.review import ReviewFinding


@pytest.fixture
def window_on_a_laptop(window, qtbot, tiny_session, monkeypatch):
    """Nothing is flagged: what is found, and when, would share the room in other ways."""
    monkeypatch.setattr(review_search.ReviewItemFinder, "find", lambda *_, **__: ReviewFinding())
    window.resize(1440, 900)
    window.files.open_path(tiny_session)
    qtbot.waitUntil(
        lambda: window.controller is not None and window.controller.playback.frame is not None
    )
    controller = window.controller
    controller.editing.pick(controller.document.tracks.ids[0])
    for number in range(8):
        controller.editing.rename(controller.document.selection.track, f"name {number}")
    qtbot.waitUntil(lambda: not controller.reviewing.busy)
    window.grab()  # lays it out
    return window


def test_five_edits_of_the_history_are_in_sight(window_on_a_laptop):
    rows = window_on_a_laptop.workspace.of(HistoryPanel)._list
    assert rows.viewport().height() >= 5 * rows.visualRect(rows.model().index(0, 0)).height()
    fifth = rows.visualRect(rows.model().index(4, 0)).bottomLeft()
    place = rows.viewport().mapTo(window_on_a_laptop, fifth)
    line = window_on_a_laptop.workspace.transport
    assert place.y() <= line.mapTo(window_on_a_laptop, line.rect().topLeft()).y()


def test_four_edits_and_the_whole_card_are_in_sight_beside_a_review_item(window_on_a_laptop, qtbot):
    window, space = window_on_a_laptop, window_on_a_laptop.workspace
    window.resize(1400, 900)
    item = ReviewRow(("margin", (1, 2), 9), "Paths cross", (), 9, "00:01", "close", (), 0.2)
    space.review.show_scene(ReviewScene((item,) * 9, current=0, left=9, also="Watch it. " * 30))
    history = space.of(HistoryPanel)
    qtbot.waitUntil(lambda: history.visibleRegion().boundingRect() == history.rect())
    rows = history._list
    assert rows.viewport().height() >= 4 * rows.visualRect(rows.model().index(0, 0)).height()


def test_a_score_has_room_for_its_words_and_all_its_figures(window_on_a_laptop, qtbot):
    window = window_on_a_laptop
    window.resize(1400, 900)
    window.run_command("view.score")
    panel = window.workspace.of(ScorePanel)
    qtbot.waitUntil(lambda: window.controller.of(ScoreController).known)
    window.controller.draw()
    window.grab()
    table, chosen = panel.table, panel._truth
    qtbot.waitUntil(lambda: panel.visibleRegion().boundingRect() == panel.rect())
    qtbot.waitUntil(lambda: table.horizontalScrollBar().maximum() == 0)
    assert table.verticalScrollBar().maximum() == 0
    assert chosen.fontMetrics().horizontalAdvance(chosen.currentText()) < chosen.width()


def test_the_panel_without_review_items_takes_its_few_words_and_no_more(window_on_a_laptop):
    panel = window_on_a_laptop.workspace.review
    assert panel.height() < 5 * panel.fontMetrics().height() + 32


def test_what_can_be_done_to_a_track_is_in_sight_however_long_the_history_is(
    window_on_a_laptop,
):
    card = window_on_a_laptop.workspace.card
    for tool in card._tools:
        assert not tool.visibleRegion().isEmpty()
        assert tool.visibleRegion().boundingRect() == tool.rect()


def test_labelling_on_a_low_screen_makes_the_window_no_higher(window_on_a_laptop, qtbot):
    window = window_on_a_laptop
    window.resize(800, 500)
    before = window.minimumSizeHint()
    window.run_command("labels.parts")
    qtbot.waitUntil(window.workspace.labelling.isVisible)
    qtbot.wait(50)
    assert window.height() == 500
    assert window.minimumSizeHint().height() <= before.height()


def test_six_lanes_are_in_sight(window_on_a_laptop):
    area = window_on_a_laptop.workspace.timeline.area
    assert area.height() - area.ruler_height >= 6 * area.lane_height


def test_the_order_and_height_of_lanes_are_remembered_for_the_next_start(window, qtbot, remembered):
    controls = window.workspace.timeline.area.controls
    controls.arrange(Arrangement(LaneOrder.NUMBER, True, LaneHeight.HIGH))
    window.workspace.remember(remembered)
    again = MainWindow(remembered)
    arrangement = again.workspace.timeline.area.controls.arrangement
    again.close()
    again.deleteLater()
    assert arrangement == Arrangement(LaneOrder.NUMBER, False, LaneHeight.HIGH)


def test_lanes_remembered_in_a_way_that_is_unknown_stand_as_ever(window, remembered):
    remembered.set_text("timeline/height", "GIGANTIC")
    controls = window.workspace.timeline.area.controls
    controls.restore(remembered)
    assert controls.arrangement == Arrangement()


def test_f6_walks_the_parts_with_a_ring_around_the_one_that_has_the_keyboard(window_on_a_laptop):
    window = window_on_a_laptop
    space = window.workspace
    window.activateWindow()
    space.timeline.setFocus()
    walked = []
    for _ in range(8):
        window.run_command("view.next_pane")
        pane = space._ring.pane
        walked.append(pane)
        now = QApplication.focusWidget()
        assert now is pane or pane.isAncestorOf(now)
        assert space._ring.isVisible()
        assert space._ring.size().height() <= pane.height()
    side = [space.review, space.card, space.of(HistoryPanel)]
    below = [space.transport_line, space.timeline]
    assert walked == [space.left, space.right, space.overhead, *side, *below]
    window.run_command("view.previous_pane")
    assert space._ring.pane is space.transport_line
    space.left.setFocus()
    assert space._ring.isHidden()


def test_f6_shows_where_the_keyboard_is(window_on_a_laptop):
    window = window_on_a_laptop
    window.activateWindow()
    window.workspace.timeline.setFocus()
    before = window.grab().toImage()
    window.run_command("view.next_pane")
    assert window.grab().toImage() != before


def test_panels_stay_open_or_closed_in_the_next_recording(
    window, qtbot, tiny_session, tiny_recording
):
    open_with_anna(window, qtbot, tiny_session)
    window.run_command("view.layout_engineer")
    assert window.workspace.panels["score"].isVisible()
    window.files.open_path(tiny_recording)
    qtbot.waitUntil(lambda: window.controller.playback.frame is not None)
    laid_out(qtbot)
    assert window.workspace.panels["score"].isVisible()
    window.run_command("view.score")
    assert not window.workspace.panels["score"].isVisible()
    window.files.open_path(tiny_session)
    qtbot.waitUntil(lambda: window.controller.playback.frame is not None)
    laid_out(qtbot)
    assert not window.workspace.panels["score"].isVisible()
