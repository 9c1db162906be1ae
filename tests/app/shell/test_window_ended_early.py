"""A tracker that cannot go on ends in a session of what it found until then."""

import pytest

from app.core.tracking_process import TrackerProcess
from tracking.errors import TrackwrightError


@pytest.fixture
def ends(monkeypatch):
    """Every tracker dies after some of its results have come."""
    batches = TrackerProcess.batches

    def some(process):
        came = batches(process)
        yield next(batch for batch in came if batch)
        came.close()
        raise TrackwrightError("the tracker ended by itself", "track a shorter range")

    monkeypatch.setattr(TrackerProcess, "batches", some)


@pytest.fixture
def opened(window, qtbot, tiny_recording):
    window.files.open_path(tiny_recording)
    qtbot.waitUntil(
        lambda: window.controller is not None and window.controller.playback.frame is not None
    )
    return window


def _tracked(window):
    return window.files.session is not None and not window.work.busy


@pytest.mark.usefixtures("ends")
def test_what_was_tracked_before_the_tracker_died_becomes_a_session(opened, qtbot):
    opened.controller.tracking.track("stereo-colour")
    qtbot.waitUntil(lambda: _tracked(opened))
    run = opened.files.session.runs[0]
    first, end = run.frames
    early = f"stereo-colour ended after {end} of 80 frames: the tracker ended by itself"
    assert first == 0 < end < 80
    assert early in opened.notice.text
    assert "The result is on disk" in opened.notice.text
    assert [note.startswith(early) for note in run.notes] == [True]
    assert not opened.controller.live.running
