from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tracking.errors import SettingsError
from tracking.pipeline import set_up, track
from tracking.recording import OpenOptions, Recording, open_recording
from tracking.synthesis import render_recording
from tracking.trackers import TRACKERS, parse_settings

FAST = {"particles": "100"}


@pytest.fixture(scope="module")
def lobby(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("set_up") / "lobby"
    render_recording(folder, "lobby", 3.0, 3, 5, size=(320, 240), fps=10.0)
    return folder


def told(recording: Recording, tracker: str = "stereo-direction") -> tuple[str, ...]:
    settings = parse_settings(TRACKERS[tracker], FAST)
    with track(recording, tracker, settings, frames=(0, 2)) as tracking:
        list(tracking)
        return tracking.notes


def cameras_of(lobby: Path, left: str, right: str) -> OpenOptions:
    """The same set-up with other cameras."""
    with open_recording(lobby) as recording:
        ground = recording.ground
    return OpenOptions(
        left=lobby / left,
        right=lobby / right,
        calibration=(lobby / "calibration.yaml",),
        height_m=ground.height_m,
        tilt_deg=ground.tilt_deg,
    )


@pytest.mark.parametrize("scene", ["lobby", "plaza", "ceiling", "indoor", "outdoor"])
def test_a_set_up_that_is_right_gives_no_note(scene: str, tmp_path: Path):
    folder = tmp_path / scene
    render_recording(folder, scene, 1.0, 2, 7, size=(320, 240), fps=10.0)
    with open_recording(folder) as recording:
        assert told(recording) == ()


@pytest.mark.parametrize(
    ("height", "tilt"), [(24.0, None), (1.2, None), (None, 5.0), (None, 10.0), (None, 50.0)]
)
def test_a_wrong_height_or_tilt_is_told_as_that_with_what_would_be_right(
    lobby: Path, height: float | None, tilt: float | None
):
    with open_recording(lobby) as recording:
        right = recording.ground
    with open_recording(lobby, OpenOptions(height_m=height, tilt_deg=tilt)) as wrong:
        (note,) = told(wrong)
    assert f"height {height or right.height_m:.3g} m and tilt {tilt or right.tilt_deg:.3g}" in note
    suits = note.partition("do not suit the scene, height ")[2].split()
    assert float(suits[0]) == pytest.approx(right.height_m, rel=0.1)
    assert float(suits[4]) == pytest.approx(right.tilt_deg, abs=4)
    assert "swapped" not in note


def test_swapped_cameras_are_told_as_that_and_not_as_a_wrong_floor(lobby: Path):
    with open_recording(lobby, cameras_of(lobby, "right.mp4", "left.mp4")) as swapped:
        (note,) = told(swapped)
    assert "are the cameras swapped?" in note


def test_the_same_pictures_for_both_cameras_are_told_as_that(lobby: Path):
    with open_recording(lobby, cameras_of(lobby, "left.mp4", "left.mp4")) as same:
        (note,) = told(same)
    assert "both cameras show the same images" in note


@pytest.mark.parametrize(("apart_px", "same"), [(10, False), (0, True)])
def test_a_lamp_at_night_tells_whether_cameras_differ(
    lobby: Path, monkeypatch: pytest.MonkeyPatch, apart_px: int, same: bool
):
    left, right = np.zeros((2, 240, 320, 3), np.uint8)
    left[100:110, 150:160] = 200
    right[100:110, 150 - apart_px : 160 - apart_px] = 200
    monkeypatch.setattr(
        set_up, "measure_scene", lambda *_: set_up.SceneDistances(*np.zeros((2, 0, 2)), 1.0)
    )
    with open_recording(lobby) as recording:
        frame = replace(recording.read(0), left=left, right=right)
        assert ("show the same images" in set_up.doubt_of(recording, [frame])) is same


@pytest.mark.parametrize(("nearest", "farthest"), [("20", "2"), ("5", "5")])
def test_a_nearest_distance_that_is_not_below_the_farthest_is_refused(
    lobby: Path, nearest: str, farthest: str
):
    texts = {"stereo.nearest_m": nearest, "stereo.farthest_m": farthest}
    settings = parse_settings(TRACKERS["stereo-joint"], texts)
    with (
        open_recording(lobby) as recording,
        pytest.raises(SettingsError, match=f"nearest_m={nearest} .*farthest_m={farthest} leave"),
    ):
        track(recording, "stereo-joint", settings)


def test_one_camera_may_show_what_it_likes(lobby: Path):
    with open_recording(lobby, cameras_of(lobby, "left.mp4", "left.mp4")) as same:
        assert told(same, "spheroid") == ()
