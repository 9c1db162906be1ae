"""What `track` tells on the way: notes that are no errors."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from command_line import Trackwright

from tracking.recording import Recording


def test_track_notes_where_the_recording_is_outside_the_sessions_folder(
    trackwright: Trackwright, recording: Path, tmp_path: Path
) -> None:
    (tmp_path / "apart").mkdir()
    notes = []
    for out in (tmp_path / "apart" / "s.h5", tmp_path / "s.h5"):
        status, _, err = trackwright("track", recording, "-o", out, "--frames", "0:2")
        assert status == 0
        notes.append([line for line in err.splitlines() if "s.h5" in line])
    assert notes[0] == [
        "note: on another computer: trackwright open s.h5 --recording PATH (the recording is in "
        "another folder)"
    ]
    assert notes[1] == []


@pytest.mark.parametrize(
    ("tracker", "much"), [("stereo-direction", "nearly all"), ("spheroid", "half")]
)
def test_who_finds_nobody_is_told_what_is_taken_for_background(
    trackwright: Trackwright, recording: Path, tmp_path: Path, tracker: str, much: str
) -> None:
    words = ("-o", tmp_path / "s.h5", "--tracker", tracker, "--frames", "0:1")
    status, _, err = trackwright("track", recording, *words)
    assert status == 0
    assert f"nobody was found; what stands still for {much} of the footage is taken" in err


def test_an_oddity_of_the_recording_is_no_reason_why_nobody_was_found(
    trackwright: Trackwright, recording: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    at_first = iter(((), ()))
    met_later = property(lambda _: next(at_first, ("one frame is broken",)))
    monkeypatch.setattr(Recording, "notes", met_later)
    words = ("-o", tmp_path / "s.h5", "--tracker", "spheroid", "--frames", "0:1")
    status, _, err = trackwright("track", recording, *words)
    assert status == 0
    assert "one frame is broken" in err
    assert "nobody was found" in err


def test_track_tells_what_is_odd_on_the_way(
    trackwright: Trackwright, recording: Path, tmp_path: Path
) -> None:
    left, right = recording / "left.mp4", recording / "right.mp4"
    words = ["--left", right, "--right", left, "--calibration", recording / "calibration.yaml"]
    words += ["--height", "6.4", "--tilt", "60", "-o", tmp_path / "s.h5"]
    status, _, err = trackwright("track", *words)
    assert status == 0
    told = "right: no distance for what moves: are the cameras swapped?"
    assert f"note: {told}\n" in err
    facts = json.loads(trackwright("info", tmp_path / "s.h5", "--json")[1])
    assert told in facts["runs"][0]["notes"]


def test_a_wrong_height_is_told_once_and_not_as_swapped_cameras_or_learnt_background(
    trackwright: Trackwright, footage: Path, tmp_path: Path
) -> None:
    words = ["track", footage, "--height", "24", "-o", tmp_path / "s.h5", "--frames", "0:40"]
    status, _, err = trackwright(*words)
    assert status == 0
    assert err.count("height 24 m and tilt 60 degrees do not suit the scene") == 1
    assert "swapped" not in err
    assert "background" not in err.removeprefix("learning the background ...")


def test_two_cameras_without_calibration_say_what_is_not_used(
    trackwright: Trackwright, footage: Path, tmp_path: Path
) -> None:
    cameras = ["--left", footage / "left.mp4", "--right", footage / "right.mp4"]
    asked = ["track", "-o", tmp_path / "s.h5", "--frames", "0:2", *cameras]
    err = trackwright(*asked, "--height", "6.4", "--tilt", "60")[2]
    assert (
        "note: no calibration: three-part tracks people with the left camera; the right camera, "
        "height and tilt are not used\n"
    ) in err
    assert "left camera; the right camera is not used\n" in trackwright(*asked)[2]
    calibrated = trackwright(*asked, "--calibration", footage / "calibration.yaml")[2]
    assert "note: no height and tilt of the camera: three-part tracks" in calibrated
    named = trackwright(*asked, "--tracker", "three-part")[2]
    assert "not used" not in named
