import time
from types import SimpleNamespace

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from app.core.playback.clock import LONGEST_STALL_S
from app.core.playback.playback import Playback
from tracking.recording import open_recording


@pytest.fixture
def playback(qtbot, tiny_recording, no_threads_left):
    with open_recording(tiny_recording) as recording:
        playback = Playback(recording, None)
        yield playback
        playback.close()


def test_it_tells_which_frames_are_at_hand(playback, qtbot):
    playback.go(10)
    qtbot.waitUntil(lambda: any(start <= 30 < stop for start, stop in playback.loaded))
    assert all(start < stop for start, stop in playback.loaded)


def test_it_plays_as_many_frames_as_are_asked_for_in_the_time_that_passed(playback, monkeypatch):
    now_s = [50.0]
    clock = SimpleNamespace(perf_counter=lambda: now_s[0])
    monkeypatch.setattr("app.core.playback.playback.time", clock)
    playback.set_speed(4.0)
    playback.toggle()
    for passed_s in (0.25, 0.1, 0.4):
        now_s[0] += passed_s
        playback._tick()
    assert playback.clock.frame == int(0.75 * 4 * playback.clock.fps)


def test_it_plays_as_fast_as_it_is_asked_to(playback, qtbot):
    playback.set_speed(4.0)
    began_s, moments_s = time.monotonic(), list[float]()
    playback.toggle()
    playback.moved.connect(lambda: moments_s.append(time.monotonic()))
    qtbot.waitUntil(lambda: playback.clock.frame >= 40)
    frame, rate = playback.clock.frame, 4 * playback.clock.fps
    assert frame <= rate * (time.monotonic() - began_s) + 1
    # A busy machine may stand still between two ticks: playing goes on where it was.
    passed_s = np.minimum(np.diff(moments_s[:-1]), LONGEST_STALL_S).sum()
    assert frame >= rate * passed_s - 2


def test_who_goes_on_and_back_at_once_sees_the_frame_they_went_back_to(
    playback, qtbot, monkeypatch
):
    playback.go(10)
    qtbot.waitUntil(lambda: playback.frame is not None)
    monkeypatch.setattr(playback._reader, "get_cached", lambda _: None)
    playback.step(30)
    playback.step(-30)
    answered = []
    playback._reader.ready.connect(lambda _, frame: answered.append(frame.number))
    qtbot.waitUntil(lambda: bool(answered))
    qtbot.wait(1)
    assert playback.number == playback.clock.frame == 10


class SlowRecording:
    """The recording as a machine reads it that is a third as fast as the footage."""

    def __init__(self, recording, read_s):
        self._recording, self._read_s, self.reads = recording, read_s, []

    def __getattr__(self, name):
        return getattr(self._recording, name)

    def read(self, *given):
        self.reads.append(given[0])
        time.sleep(self._read_s)
        return self._recording.read(*given)


def test_on_a_slow_machine_frames_are_dropped_and_never_the_clock(
    tiny_recording, qtbot, monkeypatch, no_threads_left
):
    monkeypatch.setattr("app.core.playback.frames.LagSearch.start", lambda *_: None)
    now_s = [50.0]
    clock = SimpleNamespace(perf_counter=lambda: now_s[0])
    monkeypatch.setattr("app.core.playback.playback.time", clock)
    with open_recording(tiny_recording) as recording:
        slow = SlowRecording(recording, 0.08)  # 32 frames a second are due
        playback = Playback(slow, None)
        playback.set_speed(4.0)
        shown, waiting = [], []
        playback.shown.connect(lambda: shown.append((playback.number, playback.clock.frame)))
        playback._timer.stop()
        playback.clock.play()
        for tick in range(1, 61):  # 1.8 s by the clock of the wall
            now_s[0] += 0.03
            playback._ticked_s = now_s[0] - 0.03
            playback._tick()
            assert playback.clock.frame == min(int(tick * 0.03 * 32 + 1e-6), 79)
            qtbot.wait(30)
            waiting.append(len(slow.reads))
        playback.close()
    numbers = [number for number, _ in shown]
    assert numbers == sorted(numbers)
    assert 5 <= len(numbers) <= 35  # of 57 that were due
    assert max(due - number for number, due in shown) <= 12  # no queue of frames builds up
    assert len(slow.reads) <= 40


@pytest.fixture
def looping(controller):
    """The recording at rest at frame 40."""
    controller.playback.go(40)
    return controller.playback


def test_a_range_is_played_again_and_again_until_the_key_is_pressed_once_more(
    window, controller, looping, press, qtbot
):
    controller.document.correcting.marked = (40, 44)
    window.run_command("play.loop")
    assert looping.clock.loop == (40, 44)
    assert looping.clock.playing
    seen = set()
    looping.moved.connect(lambda: seen.add(looping.clock.frame))
    qtbot.waitUntil(lambda: seen >= {40, 41, 42, 43})
    qtbot.wait(300)
    assert seen <= {40, 41, 42, 43}
    assert "loop" in window.workspace.transport._speed.text()
    window.run_command("play.loop")
    assert looping.clock.loop is None
    assert "loop" not in window.workspace.transport._speed.text()
    looping.pause()


def test_without_a_stretch_nothing_loops_and_it_is_said_why(window, controller, looping):
    window.bring_up_to_date()
    controller.reviewing.queue.choose(None)
    assert "set a range" in window.registry.item("play.loop").why_not


def test_slow_motion_begins_before_the_event_and_shows_its_speed(window, controller, looping):
    window.run_command("play.slow")
    clock = looping.clock
    assert clock.event == 40
    assert clock.frame == 40 - 12  # a second and a half at 8 frames a second
    clock.seek(40)
    controller.draw_playhead()
    assert window.workspace.transport._speed.text().startswith("0.25")
    window.run_command("play.slow")
    assert clock.event is None
    looping.pause()


def test_the_mouse_over_the_overview_shows_the_picture_there(window, controller, looping, qtbot):
    overview = window.workspace.timeline.overview
    axis = overview._axis()
    QTest.mouseMove(overview, QPoint(round(axis.x_of(60.5)), overview.height() // 2))
    qtbot.waitUntil(lambda: overview.thumbnail.isVisible())
    assert "frame 60" in overview.thumbnail._words.text()
    assert looping.clock.frame == 40  # nothing but navigation moves the playhead
    top = overview.mapTo(window, QPoint(0, 0)).y()
    assert overview.thumbnail.geometry().bottom() < top
    QApplication.sendEvent(overview, QEvent(QEvent.Type.Leave))
    assert overview.thumbnail.isHidden()
    window.files.close()
