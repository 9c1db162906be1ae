"""Small pictures for the overview."""

from __future__ import annotations

import threading
import time

import numpy as np
import pytest

from app.core.playback import thumbnails
from app.core.playback.thumbnails import Thumbnails
from tracking.recording import open_recording


class Counted:
    """A recording that counts what is read of it, and by which thread."""

    def __init__(self, recording, frame_count=None, read_s=0.0):
        self._recording, self.reads, self._read_s = recording, [], read_s
        self.frame_count = frame_count or recording.frame_count

    def frames(self, start, stop):  # noqa: ARG002 - as recordings have it
        self.reads.append((start, threading.current_thread().name))
        time.sleep(self._read_s)
        last = self._recording.frame_count - 1
        yield from self._recording.frames(min(start, last), min(start, last) + 1)


@pytest.fixture
def recording(tiny_recording, no_threads_left):
    with open_recording(tiny_recording) as recording:
        yield recording


def test_a_thumbnail_is_read_once_off_the_gui_thread_and_kept(qtbot, recording):
    counted = Counted(recording)
    small = Thumbnails(counted, None)
    with qtbot.waitSignal(small.ready) as told:
        assert small.get(40) is None
    frame, image = told.args
    assert frame == 40
    assert (image.width(), image.height()) == (176, 132)
    assert small.get(40) is image
    assert counted.reads == [(40, "thumbnails")]
    picture = recording.read(40).left
    colour = image.pixelColor(88, 66)
    around = picture[118:123, 158:163].reshape(-1, 3).mean(axis=0)
    assert np.abs(np.array([colour.blue(), colour.green(), colour.red()]) - around).max() < 60
    small.close()


def test_of_many_that_the_mouse_passes_only_the_last_is_read(qtbot, recording):
    counted = Counted(recording, read_s=0.1)
    small = Thumbnails(counted, None)
    small.get(0)
    qtbot.waitUntil(lambda: len(counted.reads) == 1)
    with qtbot.waitSignal(small.ready) as told:
        for frame in range(1, 60):
            small.get(frame)
    assert told.args[0] == 59
    assert len(counted.reads) <= 3
    small.close()


def test_of_a_long_recording_frames_close_together_share_one(qtbot, recording, monkeypatch):
    monkeypatch.setattr(thumbnails, "MOST_KEPT", 8)
    counted = Counted(recording, frame_count=8000)
    small = Thumbnails(counted, None)
    for frame in range(0, 8000, 250):
        if small.get(frame) is None:
            with qtbot.waitSignal(small.ready):
                small.get(frame)
    assert len(counted.reads) == 8
    assert len(small._kept) == 8
    small.close()


def test_a_frame_that_cannot_be_read_has_none(qtbot, recording):
    class Broken(Counted):
        def frames(self, start, stop):
            return recording.frames(start, stop + 10_000)

    small = Thumbnails(Broken(recording), None)
    with qtbot.waitSignal(small.ready) as told:
        small.get(3)
    assert told.args[1].isNull()
    small.close()
