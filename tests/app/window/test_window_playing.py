import numpy as np
import pytest

from app.presenters.playing.clock import LONGEST_STALL_S
from app.views.playing.playback import Playback
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


def test_it_plays_as_fast_as_it_is_asked_to(playback, qtbot):
    moments = []
    playback.go(0)
    playback.set_speed(4.0)
    playback.toggle()
    moments.append((playback._ticked_s, 0))
    playback.moved.connect(lambda: moments.append((playback._ticked_s, playback.clock.frame)))
    qtbot.waitUntil(lambda: playback.clock.frame >= 40)
    times_s = [moment[0] for moment in moments if moment[1] <= 40]
    # A busy machine may stand still between two ticks: playing goes on where it was.
    passed_s = np.minimum(np.diff(times_s), LONGEST_STALL_S).sum()
    assert max(moment[1] for moment in moments if moment[1] <= 40) == pytest.approx(
        passed_s * 4 * playback.clock.fps, abs=2.1
    )


def test_who_goes_on_and_back_at_once_sees_the_frame_they_went_back_to(
    playback, qtbot, monkeypatch
):
    playback.go(10)
    qtbot.waitUntil(lambda: playback.frame is not None)
    monkeypatch.setattr(playback._reader, "cached", lambda _: None)
    playback.step(30)
    playback.step(-30)
    answered = []
    playback._reader.ready.connect(lambda _, frame: answered.append(frame.number))
    qtbot.waitUntil(lambda: bool(answered))
    qtbot.wait(1)
    assert playback.number == playback.clock.frame == 10
