import time
from types import SimpleNamespace

import numpy as np
import pytest

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
