"""A tracker that cannot go on ends in a session of what it found until then."""

import pytest

from app.core.tracking_process import TrackerProcess
from app.features.runs.track_dialog import TrackDialog
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


def test_after_a_failure_the_dialog_is_filled_in_and_the_next_run_takes_the_message_back(
    opened, qtbot, monkeypatch
):
    def fails(_process):
        raise TrackwrightError("no file of detections")
        yield

    batches = TrackerProcess.batches
    monkeypatch.setattr(TrackerProcess, "batches", fails)
    opened.controller.tracking.track("three-part", seed=5, frames=(3, 9))
    qtbot.waitUntil(lambda: "no file of detections" in opened.notice.text)
    monkeypatch.setattr(TrackerProcess, "batches", batches)
    opened.run_command("tracks.track")
    dialog = opened.findChild(TrackDialog)
    name, _, seed, frames = dialog.answer()
    assert (name, seed, frames) == ("three-part", 5, (3, 9))
    dialog.accept()
    assert opened.notice.text == ""
    assert opened.controller.tracking.failed_order is None


def test_the_legend_on_the_floor_is_in_the_view_menu_and_w_names_both_of_its_uses(opened):
    assert opened.registry.item("view.floor_legend").menu == "View"
    assert opened.registry.item("tracks.draw").title == "Draw or move a box"
