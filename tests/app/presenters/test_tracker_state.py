"""What the window says of tracking while no tracker is at work."""

from pathlib import Path

import pytest

from app.presenters.runs.tracker_state import TrackerWords
from tracking.recording import Recording, open_recording
from tracking.session import Session
from tracking.tracks import Run


@pytest.fixture
def recording(tiny_recording: Path):
    with open_recording(tiny_recording) as opened:
        yield opened


def test_a_session_that_began_as_a_run_says_whose(recording: Recording, tiny_run: Run):
    said = TrackerWords(recording).resting(Session.create(recording, [tiny_run]))
    assert (said.name, said.status) == (tiny_run.tracker, "tracked")


def test_a_session_labelled_by_hand_is_not_called_tracked(recording: Recording):
    said = TrackerWords(recording).resting(Session.create(recording))
    assert (said.name, said.status) == ("", "labelled by hand")
    assert "Draw a person" in said.no_lanes


def test_without_a_session_playing_tracks(recording: Recording):
    words = TrackerWords(recording)
    assert words.resting(None).name == words.best != ""
    assert words.resting(None).status == "play to track"
