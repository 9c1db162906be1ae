from __future__ import annotations

import pytest
from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtWidgets import QLabel, QToolButton

from app.core.scenes import TransportScene
from app.core.widgets.progress_strip import ProgressStrip
from app.features.pictures.camera_switch import CameraSwitch
from app.features.playback.transport import TransportBar, clock_text

LEFT = Qt.MouseButton.LeftButton


def scene(frame: int = 834, playing: bool = False, speed: float = 1.0, status: str = "tracked"):
    return TransportScene(playing, speed, frame, 3000, frame / 20, "stereo-direction", status)


@pytest.fixture
def bar(qtbot, dark):
    widget = TransportBar()
    qtbot.addWidget(widget)
    widget.show_scene(scene())
    return widget


class LayoutRequests(QObject):
    """Counts how often a widget is laid out anew."""

    def __init__(self, widget) -> None:
        super().__init__(widget)
        self.seen = 0
        widget.installEventFilter(self)

    def eventFilter(self, _watched, event) -> bool:  # noqa: N802 - Qt's name
        self.seen += event.type() == QEvent.Type.LayoutRequest
        return False


def button(widget, name: str) -> QToolButton:
    return next(one for one in widget.findChildren(QToolButton) if one.accessibleName() == name)


def words(widget) -> str:
    return " ".join(label.text() for label in widget.findChildren(QLabel))


def test_it_tells_frame_count_and_time(bar):
    assert bar._frame.text() == "834"
    assert "/ 3000" in words(bar)
    assert "00:41.70" in words(bar)


def test_numbers_that_run_lay_nothing_out_anew(bar, qtbot):
    with qtbot.waitExposed(bar):
        bar.show()
    qtbot.wait(1)  # laid out as wide as it is shown
    counted = LayoutRequests(bar)
    for frame in range(835, 845):
        bar.show_scene(scene(frame, playing=False))
        qtbot.wait(1)
    assert counted.seen == 0
    assert "00:42.20" in words(bar)


def test_the_time_has_room_for_hours(bar):
    bar.show_scene(TransportScene(False, 1.0, 90_000, 100_000, 4500.0, "", ""))
    label = next(one for one in bar.findChildren(QLabel) if one.text() == "1:15:00.00")
    assert label.width() >= label.sizeHint().width()


def test_play_becomes_pause_while_playing(bar, qtbot):
    with qtbot.waitSignal(bar.play_toggled):
        qtbot.mouseClick(button(bar, "Play"), LEFT)
    bar.show_scene(scene(playing=True))
    assert button(bar, "Pause")


@pytest.mark.parametrize(("name", "frame"), [("First frame", 0), ("Last frame", 2999)])
def test_the_ends_are_one_click_away(bar, qtbot, name, frame):
    with qtbot.waitSignal(bar.frame_sought) as sought:
        qtbot.mouseClick(button(bar, name), LEFT)
    assert sought.args == [frame]


@pytest.mark.parametrize(("name", "step"), [("Previous frame", -1), ("Next frame", 1)])
def test_frames_are_stepped_through(bar, qtbot, name, step):
    with qtbot.waitSignal(bar.stepped) as stepped:
        qtbot.mouseClick(button(bar, name), LEFT)
    assert stepped.args == [step]


def test_a_typed_frame_is_gone_to_and_kept_inside_the_recording(bar, qtbot, heard):
    sought = heard(bar.frame_sought)
    for typed in ("120", "99999"):
        bar._frame.setText(typed)
        qtbot.keyClick(bar._frame, Qt.Key.Key_Return)
    assert sought == [120, 2999]


def test_escape_leaves_the_frame_as_it_was(bar, qtbot, heard):
    sought = heard(bar.frame_sought)
    bar._frame.setText("12")
    qtbot.keyClick(bar._frame, Qt.Key.Key_Escape)
    assert bar._frame.text() == "834"
    assert sought == []


def test_the_speed_menu_offers_and_shows_speeds(bar, heard):
    chosen = heard(bar.speed_chosen)
    button(bar, "Speed: 1×").menu().actions()[0].trigger()
    assert chosen == [0.1]
    bar.show_scene(scene(speed=4.0))
    assert button(bar, "Speed: 4×").text() == "4×"


def test_numbers_do_not_move_while_playing(bar):
    bar.resize(1200, 40)
    bar.grab()
    before = bar._time.geometry()
    bar.show_scene(scene(frame=2999))
    bar.grab()
    assert bar._time.geometry() == before


@pytest.mark.parametrize(
    ("time_s", "text"),
    [(0, "00:00.00"), (41.7, "00:41.70"), (59.999, "01:00.00"), (3723.5, "1:02:03.50")],
)
def test_times_are_written_as_on_a_clock(time_s, text):
    assert clock_text(time_s) == text


def test_every_button_has_a_name(bar):
    assert all(one.accessibleName() for one in bar.findChildren(QToolButton))


def test_the_camera_switch_tells_the_cameras_chosen(qtbot, dark, heard):
    switch = CameraSwitch()
    qtbot.addWidget(switch)
    chosen = heard(switch.mode_chosen)
    qtbot.mouseClick(button(switch, "Show: Both"), LEFT)
    assert chosen == ["both"]


def test_a_recording_of_one_camera_has_only_one_camera_to_show(qtbot, dark):
    switch = CameraSwitch()
    qtbot.addWidget(switch)
    switch.show_scene("left", stereo=False)
    assert button(switch, "Show: Left").isEnabled()
    assert not button(switch, "Show: Anaglyph").isEnabled()


def test_progress_tells_what_runs_and_how_long_still(qtbot, dark):
    strip = ProgressStrip()
    qtbot.addWidget(strip)
    assert strip.isHidden()
    strip.show_scene("Tracking", 0.62, 74)
    assert not strip.isHidden()
    assert "Tracking" in words(strip)
    assert "1 min 14 s left" in words(strip)
    strip.finish()
    assert strip.isHidden()


def test_work_is_cancelled_once(qtbot, dark, heard):
    strip = ProgressStrip()
    qtbot.addWidget(strip)
    strip.show_scene("Tracking", None)
    cancelled = heard(strip.cancelled)
    qtbot.mouseClick(strip._cancel, LEFT)
    qtbot.mouseClick(strip._cancel, LEFT)
    assert len(cancelled) == 1


def test_a_narrow_line_goes_without_the_state_of_the_tracker(bar, qtbot):
    bar.show_scene(scene(1, playing=False))
    with qtbot.waitExposed(bar):
        bar.show()
    bar.resize(1400, bar.height())
    assert bar._tracker.isVisible()
    bar.resize(bar.minimumSizeHint().width(), bar.height())
    assert not bar._tracker.isVisible()
    bar.resize(1400, bar.height())
    assert bar._tracker.isVisible()
