from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from drawn_scenes import lane, timeline
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QContextMenuEvent
from PySide6.QtWidgets import QApplication

from app.core.plots.axis import TimeAxis
from app.core.scenes import MarkKind, TimelineMark
from app.features.timeline.panel import TimelineView
from app.features.timeline.rows import Arrangement, LaneHeight, LaneOrder, LaneRows

LEFT = Qt.MouseButton.LeftButton
SHIFT, CTRL = Qt.KeyboardModifier.ShiftModifier, Qt.KeyboardModifier.ControlModifier
SWAP = TimelineMark(MarkKind.SWAP, 500, 7, "Swap 4 and 7")
LANES = (
    lane(9, (0, 100, 0)),
    lane(4, (50, 400, 0), (450, 600, 1), selected=True, reviewed=((300, 350),)),
    lane(7, (200, 700, 2), marks=(SWAP,), keyframes=np.array([200, 699])),
)


@pytest.fixture
def view(qtbot, theme):
    widget = TimelineView()
    qtbot.addWidget(widget)
    widget.resize(900, 320)
    widget.show_scene(timeline(*LANES, frame=300, review_items=(replace(SWAP, frame=800),)))
    widget.grab()
    return widget


def point(view, row: int, frame: float) -> QPoint:
    area = view.area
    y = area.ruler_height + (row + 0.5) * area.lane_height - area.scroll_bar.value()
    return QPointF(area.axis.x_of(frame), y).toPoint()


def shown(view) -> list[int]:
    rows = view.area._rows
    return [rows.lane(row).track for row in range(len(rows))]


def window(view) -> tuple[float, float]:
    axis = view.area.axis
    return axis.start, axis.start + axis.frames


def test_zooming_by_key_keeps_the_playhead_where_it_is(view):
    before = view.area.axis.x_of(300.5)
    view.area.stretch.zoom(4.0)
    assert view.area.axis.frames == pytest.approx(250)
    assert view.area.axis.x_of(300.5) == pytest.approx(before, abs=1)


def test_of_a_recording_tracked_in_part_that_part_is_shown_first(qtbot, theme):
    widget = TimelineView()
    qtbot.addWidget(widget)
    widget.show_scene(timeline(*LANES, tracked=(100, 300)))
    start, end = window(widget)
    assert 90 <= start <= 100
    assert 300 <= end <= 310


def test_the_selected_track_fills_the_width(view):
    view.area.stretch.show_selected()
    start, end = window(view)
    assert 0 <= start < 50
    assert 600 < end < 660


def test_a_second_around_the_playhead_is_shown(view):
    view.area.stretch.show_second()
    start, end = window(view)
    assert start <= 290.5
    assert end >= 310.5
    assert end - start < 45


def test_a_double_click_shows_the_track_then_a_second_of_it_and_on_the_ruler_all(view, qtbot):
    qtbot.mouseDClick(view.area, LEFT, pos=point(view, 2, 500))
    start, end = window(view)
    assert 150 < start < 200
    assert 700 < end < 750
    qtbot.mouseRelease(view.area, LEFT)
    qtbot.mouseDClick(view.area, LEFT, pos=point(view, 2, 500))
    assert view.area.axis.frames < 45
    qtbot.mouseDClick(view.area, LEFT, pos=QPoint(400, 5))
    assert window(view) == (0, 1000)


def test_the_scroll_bar_below_moves_in_time_and_is_there_while_zoomed(view):
    assert view.area.time_bar.isHidden()
    view.area.stretch.zoom(4.0)
    assert not view.area.time_bar.isHidden()
    view.area.time_bar.setValue(600)
    assert view.area.axis.start == pytest.approx(600)


def test_ctrl_and_drag_pans(view, qtbot, heard):
    view.area.stretch.zoom(4.0)
    start, sought = view.area.axis.start, heard(view.frame_sought)
    at = point(view, 0, start + 100)
    qtbot.mousePress(view.area, LEFT, CTRL, at)
    qtbot.mouseMove(view.area, at - QPoint(50, 0))
    qtbot.mouseRelease(view.area, LEFT, CTRL, at - QPoint(50, 0))
    assert view.area.axis.start > start
    assert sought == []


def test_shift_and_click_picks_one_more_and_the_right_button_asks_for_a_menu(view, qtbot, heard):
    picked, added = heard(view.track_picked), heard(view.track_added)
    qtbot.mouseClick(view.area, LEFT, SHIFT, point(view, 2, 300))
    with qtbot.waitSignal(view.menu_asked) as asked:
        at, by_mouse = point(view, 1, 300), QContextMenuEvent.Reason.Mouse
        QApplication.sendEvent(view.area, QContextMenuEvent(by_mouse, at, at))
    assert (picked, added) == ([], [7])
    assert asked.args[0] == 4


def test_lanes_are_sorted_by_first_frame_or_by_number(view):
    assert shown(view) == [9, 4, 7]
    view.area.controls.arrange(Arrangement(LaneOrder.NUMBER))
    assert shown(view) == [4, 7, 9]


def test_only_tracks_with_rows_in_the_frames_shown_and_the_selected_one_are_left(view):
    view.area.controls.arrange(Arrangement(in_view_only=True))
    view.area.stretch.show(view.area.axis.fitting(610, 690))
    assert shown(view) == [4, 7]
    view.area.stretch.show_all()
    assert shown(view) == [9, 4, 7]


def test_a_track_is_not_in_view_in_its_own_gap(view):
    unselected = [replace(one, selected=False) for one in LANES]
    view.show_scene(timeline(*unselected, frame=300))
    view.area.controls.arrange(Arrangement(in_view_only=True))
    view.area.stretch.show(view.area.axis.around(425, 25))
    assert shown(view) == [7]


def test_the_menu_changes_the_height_of_lanes(view):
    heights = []
    for height in LaneHeight:
        view.area.controls.arrange(Arrangement(height=height))
        heights.append(view.area.lane_height)
    assert heights == sorted(set(heights))


def test_the_menu_s_entries_say_what_is_chosen(view):
    texts = {action.text(): action for action in view.area.controls.menu.actions()}
    texts["By number"].trigger()
    texts["Only tracks in the frames shown"].trigger()
    assert view.area.controls.arrangement == Arrangement(LaneOrder.NUMBER, in_view_only=True)
    assert texts["By number"].isChecked()
    assert not texts["By first frame"].isChecked()


@pytest.mark.parametrize(
    ("row", "frame", "said"),
    [
        (1, 325, ("4", "frame 325, 00:16.25", "measured", "reviewed")),
        (1, 425, ("4", "gap")),
        (1, 500, ("4", "predicted")),
        (1, 800, ("4", "not there")),
        (2, 400, ("7", "interpolated")),
        (2, 200, ("7", "keyframe")),
        (2, 500, ("7", "Swap 4 and 7")),
    ],
)
def test_hovering_tells_what_is_there(view, row, frame, said):
    words = view.area.words_at(QPointF(view.area.axis.x_of(frame + 0.5), point(view, row, 0).y()))
    assert all(one in words for one in said), words


def test_hovering_over_a_name_tells_the_track_s_life(view):
    words = view.area.words_at(QPointF(20, point(view, 1, 0).y()))
    assert words.splitlines() == ["4", "frames 50 to 599"]


def test_hovering_over_the_overview_tells_frame_time_and_people(view):
    axis = view.overview._axis()
    words = view.overview.words_at(axis.x_of(300.5))
    assert "frame 300, 00:15.00" in words
    assert "people: 1" in words


def test_the_wheel_on_the_overview_zooms_and_ctrl_moves_what_the_lanes_show(view, wheel, qtbot):
    wheel(view.overview, QPointF(400, 10), 4)
    assert view.area.axis.frames < 500
    with qtbot.assertNotEmitted(view.frame_sought):
        x = round(view.overview._axis().x_of(700))
        qtbot.mouseClick(view.overview, LEFT, CTRL, QPoint(x, 10))
    start, end = window(view)
    assert (start + end) / 2 == pytest.approx(700, abs=3)


def test_review_items_and_reviewed_parts_are_seen_in_the_overview(view, drawn, theme, inked):
    strip, axis = drawn(view.overview), view.overview._axis()
    assert inked(strip, QPointF(axis.x_of(800.5), 10).toPoint(), theme.warning)
    before = strip.pixelColor(round(axis.x_of(700)), 9)
    view.show_scene(replace(view.area._scene, reviewed=((600, 750),)))
    assert drawn(view.overview).pixelColor(round(axis.x_of(700)), 9) != before


def test_the_marks_of_a_lane_are_drawn_where_they_are(view, drawn, theme, inked):
    shot = drawn(view.area)
    assert inked(shot, point(view, 2, 500), theme.text)
    assert not inked(shot, point(view, 2, 450), theme.text)


def test_only_tracks_in_view_may_be_asked_for_while_there_is_none(qtbot):
    rows = LaneRows()
    rows.take(())
    rows.arrange(Arrangement(in_view_only=True), TimeAxis(0.0, 1.0, 0.0, 1.0, 0))
    assert len(rows) == 0
