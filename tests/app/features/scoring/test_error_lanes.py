"""The lanes of errors below those of people."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QFont, QFontMetricsF
from PySide6.QtTest import QTest

from app.core.drawing.error_signs import error_colour
from app.core.plots.axis import TimeAxis
from app.core.scenes.error_events import ErrorEvents
from app.core.scenes.ground_truth import ErrorLane, ErrorLanes
from app.features.timeline.error_lanes import ErrorLanesView, _fitting
from tests.pace import spent
from tracking.scoring import ErrorKind

FRAMES = 10_000
AXIS = TimeAxis(100.0, 800.0, 0.0, 1000.0, 1000)


def events(kind: ErrorKind, *ranges: tuple[int, int]) -> ErrorEvents:
    start, end = np.array(ranges, np.int64).reshape(-1, 2).T
    count, some = len(start), np.arange(len(start)) + 5
    kinds = np.full(count, kind, np.uint8)
    nobody = np.zeros(count, np.int64)
    if kind is ErrorKind.MISS:
        return ErrorEvents(kinds, start, end, some, nobody, nobody)
    return ErrorEvents(kinds, start, end, some, some + 10, some + 20)


def lane(kind: ErrorKind, name: str, *ranges: tuple[int, int]) -> ErrorLane:
    density = np.zeros(1000, np.uint16)
    for first, end in ranges:
        density[first:end] += 1
    return ErrorLane(kind, name, int(density.sum()), density, events(kind, *ranges))


@pytest.fixture
def view(qtbot, theme):
    widget = ErrorLanesView()
    qtbot.addWidget(widget)
    widget.show_axis(AXIS)
    switches = lane(ErrorKind.SWITCH, "Switches", (200, 201), (600, 601))
    misses = lane(ErrorKind.MISS, "Misses", (100, 400), (500, 501))
    widget.show_scene(ErrorLanes((switches, misses), 20.0))
    widget.resize(900, widget.sizeHint().height())
    return widget


def at(view, row: int, frame: float) -> QPoint:
    y = 3 + (row + 0.5) * view.lane_height
    return QPointF(AXIS.x_of(frame), y).toPoint()


def test_a_stretch_of_misses_is_one_bar_and_a_single_one_is_seen(view, drawn, near, theme):
    shot, colour = drawn(view), error_colour(ErrorKind.MISS, theme)
    for frame in (110, 250, 390, 500.5):
        assert near(shot.pixelColor(at(view, 1, frame)), colour) or frame == 500.5
        assert shot.pixelColor(at(view, 1, frame)) != theme.sunken
    assert shot.pixelColor(at(view, 1, 450)) == theme.sunken


def test_a_switch_is_a_sign_of_its_own_colour(view, drawn, inked, theme):
    shot = drawn(view)
    assert inked(shot, at(view, 0, 200.5), error_colour(ErrorKind.SWITCH, theme))
    assert shot.pixelColor(at(view, 0, 300)) == theme.sunken


def test_a_click_on_an_error_tells_its_frame_and_whom_it_is_about(view, heard):
    sought, frames = heard(view.event_sought), heard(view.frame_sought)
    QTest.mouseClick(view, Qt.MouseButton.LeftButton, pos=at(view, 0, 603))
    assert sought == [(600, [16, 26])]
    QTest.mouseClick(view, Qt.MouseButton.LeftButton, pos=at(view, 1, 250))
    assert sought[-1] == (AXIS.frame_at(at(view, 1, 250).x()), [])
    QTest.mouseClick(view, Qt.MouseButton.LeftButton, pos=at(view, 1, 450))
    assert frames == [AXIS.frame_at(at(view, 1, 450).x())]


def test_what_an_error_is_stands_in_the_tooltip(view):
    words = view.words_at(QPointF(at(view, 0, 200.5)))
    assert "person 5 changes from track 25 to 15" in words
    assert "person 5 is missed in frames 100 to 399" in view.words_at(QPointF(at(view, 1, 250)))
    assert view.words_at(QPointF(20, 5)).startswith("Switches: 2 in 2 places")


def test_errors_a_second_are_told_of_the_frames_that_are_shown(view):
    place = QPointF(10, at(view, 1, 0).y())
    misses = view._scene.lanes[1]
    seconds = len(misses.density) / 20.0
    assert f"{misses.density.sum() / seconds:.2f} a second" in view.words_at(place)
    view.show_axis(replace(AXIS, start=100.0, frames=200.0))
    assert "20.00 a second" in view.words_at(place)  # one person is missed in each frame


def test_without_errors_there_are_no_lanes(view):
    view.show_scene(None)
    assert view.isHidden()


def test_the_playhead_moves_over_a_picture_that_stays(view):
    view.grab()
    before = view._still._drawn
    view.show_playhead(300)
    view.grab()
    assert view._still._drawn is before


def test_ten_thousand_stretches_are_drawn_in_a_moment(qtbot, dark):
    widget = ErrorLanesView()
    qtbot.addWidget(widget)
    starts = np.arange(0, 2 * FRAMES, 2)
    density = np.zeros(2 * FRAMES, np.uint16)
    density[starts] = 20
    crowd = events(ErrorKind.SWITCH, *((start, start + 1) for start in starts.tolist()))
    lanes = (ErrorLane(kind, kind.name, 10, density, crowd) for kind in ErrorKind)
    widget.show_scene(ErrorLanes(tuple(lanes), 20.0))
    widget.show_axis(TimeAxis(100.0, 800.0, 0.0, 2.0 * FRAMES, 2 * FRAMES))
    widget.resize(900, widget.sizeHint().height())
    widget.grab()
    with spent() as time:
        widget.show_axis(TimeAxis(100.0, 800.0, 5.0, 1.9 * FRAMES, 2 * FRAMES))
        widget.grab()
    assert time.paces < 15


@pytest.mark.usefixtures("qtbot")
def test_a_long_name_of_a_lane_is_written_smaller_before_it_is_cut():
    font = QFont()
    room = 0.8 * QFontMetricsF(font).horizontalAdvance("Fragmentations")
    small = QFontMetricsF(_fitting(font, "Fragmentations", room))
    assert small.horizontalAdvance("Fragmentations") <= room
    assert _fitting(font, "Misses", room) == font
