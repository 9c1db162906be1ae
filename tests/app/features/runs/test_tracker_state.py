"""What the window says of tracking while no tracker is running."""

from dataclasses import replace
from pathlib import Path

import pytest

from app.features.runs.tracker_state import TrackerWords
from tracking.recording import Recording, open_recording
from tracking.session import Session
from tracking.tracks import Run


@pytest.fixture
def recording(tiny_recording: Path):
    with open_recording(tiny_recording) as opened:
        yield opened


def test_a_session_that_began_as_a_run_says_whose(recording: Recording, tiny_run: Run):
    said = TrackerWords(recording).describe_rest(Session.create(recording, [tiny_run]))
    assert (said.name, said.status) == (tiny_run.tracker, "tracked")


def test_a_session_labelled_by_hand_is_not_called_tracked(recording: Recording):
    said = TrackerWords(recording).describe_rest(Session.create(recording))
    assert (said.name, said.status) == ("", "labelled by hand")
    assert "Draw a person" in said.no_lanes


def test_without_a_session_playing_tracks(recording: Recording):
    words = TrackerWords(recording)
    assert words.describe_rest(None).name == words.best != ""
    assert words.describe_rest(None).status == "play to track"


def test_tracking_again_proposes_the_tracker_of_the_corrected_tracks(
    recording: Recording, tiny_run: Run
):
    words = TrackerWords(recording)
    run = replace(tiny_run, tracker="three-part-joint")
    session = Session.create(recording, [run])
    assert words.best != "three-part-joint"
    assert words.propose_tracker(session, in_parts=False) == "three-part-joint"
    assert words.propose_tracker(session, in_parts=True) == "three-part-joint"
    assert words.propose_tracker(None, in_parts=False) == words.best


def test_once_a_detector_is_chosen_a_tracker_that_uses_it_is_proposed(
    recording: Recording, tiny_run: Run
):
    session = Session.create(recording, [replace(tiny_run, tracker="stereo-direction")])
    words = TrackerWords(recording)
    assert words.propose_tracker(session, in_parts=False) == "stereo-direction"
    assert words.propose_tracker(session, in_parts=True) == "three-part"


def test_why_nothing_can_track_ends_in_one_full_stop(recording: Recording):
    words = TrackerWords(recording)
    words.best, words.why_not = "", "give the recording a calibration."
    assert words.describe_rest(None).no_lanes == "No tracks: give the recording a calibration."
