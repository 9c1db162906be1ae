"""Metres of a rough calibration are told to be rough wherever they are shown."""

from __future__ import annotations

import json
import math
from pathlib import Path

import pytest
from command_line import Trackwright

from tracking.geometry import read_calibration
from tracking.recording import open_recording
from tracking.session import Session
from tracking.tracks import Run

WORDS = "rough calibration"


@pytest.fixture
def rough_session(recording: Path, tiny_run: Run, tmp_path: Path) -> Path:
    calibration = next(recording.glob("calib*.y*ml"))
    calibration.write_text(calibration.read_text() + "rough: 1\n")
    path = tmp_path / "rough.h5"
    with open_recording(recording) as opened:
        Session.create(opened, [tiny_run], path).close()
    return path


def test_counts_say_that_metres_are_rough(trackwright: Trackwright, rough_session: Path) -> None:
    status, _, said = trackwright("count", rough_session, "--line", "gate:0,4:0,6")
    assert status == 0
    assert WORDS in said


def test_counts_of_a_sound_calibration_say_nothing(trackwright: Trackwright, session: Path) -> None:
    assert WORDS not in trackwright("count", session, "--line", "gate:0,4:0,6")[2]


def test_scores_and_their_report_say_that_metres_are_rough(
    trackwright: Trackwright, rough_session: Path, tmp_path: Path
) -> None:
    status, _, said = trackwright(
        "score", rough_session, "--truth", rough_session, "--match", "floor",
        "--report", tmp_path / "report",
    )  # fmt: skip
    assert status == 0, said
    assert WORDS in said
    pages = [path for path in (tmp_path / "report").rglob("*") if path.is_file()]
    assert any(WORDS in path.read_text(errors="ignore") for path in pages)
    documents = [json.loads(path.read_text()) for path in pages if path.suffix == ".json"]
    assert any('"rough": true' in json.dumps(document) for document in documents)


def test_a_rough_calibration_of_videos_alone_is_written_and_told(
    trackwright: Trackwright, recording: Path, tmp_path: Path
) -> None:
    out = tmp_path / "calibration.yaml"
    cameras = ("--left", recording / "left.mp4", "--right", recording / "right.mp4")
    given = ("--rough", *cameras, "--fov", "60", "--baseline", "0.12", "-o", out)
    status, printed, said = trackwright("calibrate", *given)
    assert status == 0, said
    assert "row_error" in printed
    assert f"written: {out}" in said
    assert out.is_file()


def test_one_camera_is_calibrated_roughly_from_its_field_of_view_alone(
    trackwright: Trackwright, recording: Path, tmp_path: Path
) -> None:
    out = tmp_path / "calibration.yaml"
    given = ("--left", recording / "left.mp4", "--rough", "--fov", "60", "-o", out)
    status, printed, said = trackwright("calibrate", *given)
    assert status == 0, said
    assert "60" in printed
    found = read_calibration([out])
    assert found.right is None
    assert found.rough
    width = found.left.size[0]
    assert found.left.matrix[0, 0] == pytest.approx(width / 2 / math.tan(math.radians(30)))


def test_a_right_camera_without_its_distance_is_refused(
    trackwright: Trackwright, recording: Path
) -> None:
    cameras = ("--left", recording / "left.mp4", "--right", recording / "right.mp4")
    status, _, said = trackwright("calibrate", "--rough", *cameras)
    assert status == 2
    assert "give both" in said
