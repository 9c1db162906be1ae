"""A tracker that is quicker than the window."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from patient import PATIENCE_MS, PATIENCE_S
from PySide6.QtCore import QObject
from pytestqt.qtbot import QtBot

from app.core.tracking_process import TrackerProcess
from app.features.runs import live_tracker as live
from app.features.runs.live_tracker import LiveTracker
from app.features.runs.run_summary import RunSummary
from tracking.errors import RecordingError
from tracking.pipeline import track
from tracking.recording import Recording, open_recording
from tracking.trackers import StepResult

FRAMES, AHEAD = (30, 45), 4


@pytest.fixture(scope="module")
def recording(tiny_recording: Path) -> Iterator[Recording]:
    with open_recording(tiny_recording) as opened:
        yield opened


@pytest.fixture(scope="module")
def steps(recording: Recording) -> list[StepResult]:
    with track(recording, frames=FRAMES) as tracking:
        return list(tracking)


@pytest.fixture
def tracker(
    recording: Recording, steps: list[StepResult], monkeypatch: pytest.MonkeyPatch
) -> Iterator[LiveTracker]:
    monkeypatch.setattr(live, "_MOST_AHEAD", AHEAD)
    monkeypatch.setattr(TrackerProcess, "batches", lambda _: ((step,) for step in steps))
    owner = QObject()
    made = LiveTracker(recording, "stereo-direction", None, 0, owner, FRAMES)
    yield made
    if any(thread.name == "live tracker" for thread in threading.enumerate()):
        made.close()


def comes_to(wanted: int, count: Callable[[], int]) -> bool:
    """Whether a number comes to what is wanted, however busy the machine is, and stays there."""
    ends_s = time.monotonic() + PATIENCE_S
    while count() < wanted and time.monotonic() < ends_s:
        time.sleep(0.01)
    time.sleep(0.1)
    return count() == wanted


def test_it_waits_for_a_window_that_is_busy_and_goes_on_when_that_has_time(
    tracker: LiveTracker, qtbot: QtBot
):
    with qtbot.waitSignal(tracker.finished) as finished:
        tracker.start()
        assert comes_to(FRAMES[0] + AHEAD, lambda: tracker.kept.frames[1])
    assert tracker.kept.frames == finished.args[0].frames == FRAMES


def test_it_ends_while_it_waits_for_the_window(tracker: LiveTracker):
    tracker.start()
    assert comes_to(FRAMES[0] + AHEAD, lambda: tracker.kept.frames[1])
    tracker.close()
    assert all(thread.name != "live tracker" for thread in threading.enumerate())


def test_a_run_that_ended_early_is_kept_with_its_reason_where_nothing_can_be_told_of_it(
    tracker: LiveTracker, steps: list[StepResult], qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
):
    def ends_early(_: object) -> Iterator[tuple[StepResult, ...]]:
        yield tuple(steps[:5])
        raise RecordingError("left.mp4 breaks off")

    def fails(*_: object) -> RunSummary:
        raise ValueError("nothing can be compared")

    monkeypatch.setattr(TrackerProcess, "batches", ends_early)
    monkeypatch.setattr(live.RunSummary, "of", fails)
    with qtbot.waitSignal(tracker.finished, timeout=PATIENCE_MS) as finished:
        tracker.start()
    (run,) = finished.args
    assert run.frames == (FRAMES[0], FRAMES[0] + 5)
    assert run.notes == ("stereo-direction ended after 5 of 15 frames: left.mp4 breaks off.",)
    assert tracker.run_summary is not None
    assert tracker.run_summary.why == "left.mp4 breaks off"
