from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from drawn_scenes import RED, lane, timeline
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QPoint, QPointF, QRect, Qt
from PySide6.QtGui import QPixmap

from app.core.i18n import time_text
from app.core.plots.axis import TimeAxis, ticks
from app.features.timeline.overview_picture import busiest
from app.features.timeline.panel import TimelineView
from app.features.timeline.ruler import PLAYHEAD_HEIGHT

LEFT, MIDDLE = Qt.MouseButton.LeftButton, Qt.MouseButton.MiddleButton
AXIS = TimeAxis(100.0, 800.0, 0.0, 1000.0, 1000)


@pytest.fixture
def view(qtbot, theme):
    widget = TimelineView()
    qtbot.addWidget(widget)
    widget.resize(900, 320)
    widget.show_scene(timeline(lane(4), lane(7), lane(9)))
    widget.grab()
    return widget


def lane_point(view, row: int, frame: float) -> QPoint:
    area = view.area
    y = area.ruler_height + (row + 0.5) * area.lane_height - area.scroll_bar.value()
    return QPointF(area.axis.x_of(frame), y).toPoint()


def test_a_click_on_the_ruler_seeks(view, qtbot):
    with qtbot.waitSignal(view.frame_sought) as sought:
        qtbot.mouseClick(view.area, LEFT, pos=QPoint(round(view.area.axis.x_of(500.5)), 5))
    assert sought.args == [pytest.approx(500, abs=2)]


def test_the_playhead_hides_no_number_of_the_ruler(view, drawn):
    numbers = QRect(0, 0, view.width(), round(view.area.ruler_height - PLAYHEAD_HEIGHT))
    with_handle = drawn(view).copy(numbers)
    view.show_scene(timeline(lane(4), lane(7), lane(9), frame=500))
    assert drawn(view).copy(numbers) == with_handle


def test_scrolling_the_lanes_leaves_the_ruler_as_it_is(view, drawn):
    view.show_scene(timeline(*(lane(track) for track in range(1, 40))))
    ruler = QRect(0, 0, view.width(), round(view.area.ruler_height) - 1)
    at_the_top = drawn(view).copy(ruler)
    view.area.lanes.scroll(2.5)
    assert view.area.scroll_bar.value() > 0
    assert drawn(view).copy(ruler) == at_the_top


def test_dragging_seeks_all_the_way_and_stays_inside(view, qtbot):
    sought = []
    view.frame_sought.connect(sought.append)
    y = 5
    qtbot.mousePress(view.area, LEFT, pos=QPoint(300, y))
    qtbot.mouseMove(view.area, QPoint(500, y))
    qtbot.mouseMove(view.area, QPoint(5000, y))
    qtbot.mouseRelease(view.area, LEFT, pos=QPoint(5000, y))
    assert sought[0] < sought[1] < sought[2] == 999


def test_a_click_on_a_lane_picks_its_track_and_seeks(view, qtbot, heard):
    picked, sought = heard(view.track_picked), heard(view.frame_sought)
    qtbot.mouseClick(view.area, LEFT, pos=lane_point(view, 1, 250))
    assert picked == [7]
    assert sought == [pytest.approx(250, abs=2)]


def test_a_click_on_a_name_picks_without_seeking(view, qtbot):
    with qtbot.assertNotEmitted(view.frame_sought), qtbot.waitSignal(view.track_picked) as picked:
        qtbot.mouseClick(view.area, LEFT, pos=QPoint(20, lane_point(view, 2, 0).y()))
    assert picked.args == [9]


def test_a_click_below_the_lanes_picks_nobody(view, qtbot):
    with qtbot.waitSignal(view.track_picked) as picked:
        qtbot.mouseClick(view.area, LEFT, pos=lane_point(view, 5, 10))
    assert picked.args == [0]


def test_the_wheel_zooms_time_and_keeps_the_frame_under_the_cursor(view, wheel):
    at = lane_point(view, 0, 400)
    before = view.area.axis.frame_at(at.x())
    wheel(view.area, QPointF(at), 6)
    assert view.area.axis.frames < 400
    assert view.area.axis.frame_at(at.x()) == pytest.approx(before, abs=1)


def test_the_middle_button_pans(view, wheel, qtbot):
    wheel(view.area, QPointF(lane_point(view, 0, 500)), 6)
    start = view.area.axis.start
    at = lane_point(view, 0, view.area.axis.start + 100)
    qtbot.mousePress(view.area, MIDDLE, pos=at)
    qtbot.mouseMove(view.area, at - QPoint(40, 0))
    qtbot.mouseRelease(view.area, MIDDLE, pos=at - QPoint(40, 0))
    assert view.area.axis.start > start


def test_playing_out_of_sight_turns_the_page(view, wheel):
    wheel(view.area, QPointF(lane_point(view, 0, 10)), 8)
    lanes = view.area._scene.lanes
    view.show_scene(timeline(*lanes, frame=900))
    axis = view.area.axis
    assert axis.start <= 900 < axis.start + axis.frames


def test_of_a_thousand_lanes_only_those_in_sight_are_drawn(view):
    view.show_scene(timeline(*(lane(track) for track in range(1, 1001))))
    view.grab()
    fitting = (view.area.height() - view.area.ruler_height) / view.area.lane_height
    assert view.area.lanes_drawn <= fitting + 2


def test_moving_the_playhead_draws_no_lane(view):
    scene = timeline(lane(4), lane(7))
    view.show_scene(scene)
    view.grab()
    view.area.lanes_drawn = 0
    view.show_scene(replace(scene, frame=300))
    view.grab()
    assert view.area.lanes_drawn == 0


def test_a_newly_selected_lane_is_scrolled_to(view):
    lanes = [lane(track, selected=track == 900) for track in range(1, 1001)]
    view.show_scene(timeline(*lanes))
    view.grab()
    assert view.area.lane_at(QPointF(lane_point(view, 899, 10))).track == 900
    assert view.area.ruler_height <= lane_point(view, 899, 10).y() <= view.area.height()


def test_the_lanes_of_all_who_are_selected_are_in_sight_a_little_lower_where_need_be(view):
    room = view.area.height() - view.area.ruler_height
    apart, usual = int(room // view.area.lane_height) + 1, view.area.lane_height
    lanes = [lane(n, selected=n in (5, 4 + apart)) for n in range(1, 60)]
    view.show_scene(timeline(*lanes))
    first, last = lane_point(view, 4, 10), lane_point(view, 3 + apart, 10)
    assert view.area.lane_at(QPointF(first)).track == 5
    assert view.area.lane_at(QPointF(last)).track == 4 + apart
    assert 0.7 * usual <= view.area.lane_height < usual
    view.show_scene(timeline(*(lane(n, selected=n == 5) for n in range(1, 60))))
    assert view.area.lane_height == usual


def test_while_playing_the_people_who_are_there_come_into_sight(view):
    lanes = tuple(lane(track, (10 * track, 10 * track + 10, 0)) for track in range(1, 91))
    view.show_scene(timeline(*lanes))
    view.show_scene(replace(timeline(*lanes, frame=705), lanes=view.area._scene.lanes))
    rows = range(*view.area.lanes.in_sight)
    assert 69 in rows


def test_lanes_are_not_scrolled_away_under_the_mouse(view, qtbot):
    lanes = tuple(lane(track, (10 * track, 10 * track + 10, 0)) for track in range(1, 91))
    view.show_scene(timeline(*lanes))
    qtbot.mousePress(view.area, LEFT, pos=lane_point(view, 2, 705))
    view.show_scene(timeline(*lanes, frame=705))
    assert view.area.scroll_bar.value() == 0


def test_measured_spans_are_solid_and_predicted_ones_are_not(view, drawn, theme, near):
    view.show_scene(timeline(lane(1, (0, 500, 0), (500, 1000, 1))))
    shot = drawn(view.area)
    colour = theme.track(RED)

    def share(first: int, last: int) -> float:
        at = [lane_point(view, 0, frame) for frame in range(first, last, 2)]
        return float(np.mean([near(shot.pixelColor(one), colour) for one in at]))

    assert share(20, 480) > 0.95
    assert share(520, 980) < 0.6


def test_the_playhead_stands_at_its_frame(view, drawn, theme, inked):
    view.show_scene(timeline(lane(1, (900, 1000, 0)), frame=500))
    shot = drawn(view.area)
    assert inked(shot, lane_point(view, 1, 500.5), theme.accent)
    assert not inked(shot, lane_point(view, 1, 520), theme.accent)


def test_the_cut_of_a_preview_can_be_dragged(view, qtbot):
    view.show_scene(timeline(lane(4), cut=400))
    at = lane_point(view, 0, 400)
    moved = []
    view.cut_moved.connect(moved.append)
    with qtbot.assertNotEmitted(view.frame_sought):
        qtbot.mousePress(view.area, LEFT, pos=at)
        qtbot.mouseMove(view.area, lane_point(view, 0, 450))
        qtbot.mouseRelease(view.area, LEFT, pos=lane_point(view, 0, 450))
    assert moved[-1] == pytest.approx(450, abs=2)


def test_a_click_on_the_overview_seeks_in_the_whole_recording(view, wheel, qtbot):
    wheel(view.area, QPointF(lane_point(view, 0, 100)), 10)
    with qtbot.waitSignal(view.frame_sought) as sought:
        right = round(view.area.axis.left + view.area.axis.width) - 1
        qtbot.mouseClick(view.overview, LEFT, pos=QPoint(right, 10))
    assert sought.args[0] > 990


def test_without_tracks_the_timeline_says_how_to_get_some(view, drawn):
    before = drawn(view)
    view.show_scene(timeline())
    assert drawn(view) != before


@given(st.floats(100, 900), st.floats(0.1, 10), st.floats(0, 900), st.floats(5, 1000))
def test_zooming_never_leaves_the_recording(x, factor, start, frames):
    axis = TimeAxis(100.0, 800.0, start, frames, 1000).zoomed(x, factor)
    assert axis.start >= 0
    assert axis.start + axis.frames <= 1000 + 1e-6


@given(st.integers(0, 999))
def test_a_frame_is_found_where_it_is_drawn(frame):
    assert AXIS.frame_at(AXIS.x_of(frame + 0.5)) == frame


def test_ticks_stand_at_round_times_and_do_not_crowd():
    shown = list(ticks(AXIS, 20.0, 80.0))
    assert shown[:3] == [(0, "00:00"), (100, "00:05"), (200, "00:10")]


def test_ticks_tell_parts_of_seconds_where_seconds_are_far_apart():
    close = TimeAxis(0.0, 800.0, 40.0, 20.0, 1000)
    shown = list(ticks(close, 20.0, 60.0))
    assert shown[:3] == [(40, "00:02.0"), (42, "00:02.1"), (44, "00:02.2")]
    uneven = TimeAxis(0.0, 800.0, 0.0, 40.0, 1000)
    assert list(ticks(uneven, 29.97, 120.0))[:4:3] == [(0, "00:00.00"), (30, "00:01.00")]


def test_the_ticks_of_a_ruler_have_one_number_of_decimals_and_tell_the_times_of_their_frames():
    shown = list(ticks(TimeAxis(0.0, 800.0, 0.0, 60.0, 1000), 25.167, 100.0))
    assert [text for _, text in shown[:4]] == ["00:00.00", "00:00.40", "00:00.79", "00:01.19"]
    assert all(text == time_text(frame / 25.167) for frame, text in shown)


def test_long_recordings_are_ticked_in_hours():
    long = TimeAxis(0.0, 800.0, 0.0, 20.0 * 7200, 20 * 7200)
    assert (20 * 3600, "1:00:00") in list(ticks(long, 20.0, 60.0))


def test_the_overview_keeps_the_busiest_frame_of_each_column():
    activity = np.array([0, 9, 0, 0, 3, 0], np.uint16)
    assert busiest(activity, 2).tolist() == [9, 3]
    assert busiest(activity, 12).max() == 9
    assert busiest(np.zeros(0, np.uint16), 4).tolist() == [0, 0, 0, 0]


def test_the_overview_shows_every_stretch_that_is_at_hand(view):
    view.show_scene(replace(timeline(lane(4)), loaded=((0, 200), (600, 700))))
    strip = view.overview.grab().toImage()
    axis = view.overview._axis()
    inks = [strip.pixelColor(round(axis.x_of(frame)), 4) for frame in (100, 400, 650, 900)]
    assert inks[0] == inks[2] != inks[1] == inks[3]


def test_only_the_playhead_is_painted_while_nothing_else_changes(view):
    painted = []
    view.area._draw_still = lambda *_: painted.append("all") or QPixmap()
    scene = view.area._scene
    view.show_scene(replace(scene, frame=scene.frame + 1))
    view.area.grab()
    assert painted == []
