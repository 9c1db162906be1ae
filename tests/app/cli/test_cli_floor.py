"""`floor`: the document of the contract, what is written, and wrong input."""

from __future__ import annotations

import json
from pathlib import Path

import cv2
import pytest
from command_line import Trackwright

from tests.calibration.rendered_boards import CAMERA, GROUND, lying, pair_of
from tracking.calibration.boards import Board
from tracking.geometry import write_calibration
from tracking.recording import open_recording, read_manifest


def test_the_contracts_document_is_printed_and_the_floor_written(
    trackwright: Trackwright, recording: Path
) -> None:
    with open_recording(recording) as opened:
        truth = opened.ground
    assert truth is not None
    manifest = recording / "recording.toml"
    kept = manifest.read_text().split("[ground]")[0]
    manifest.write_text(kept)
    status, printed, _ = trackwright("floor", recording, "--write", "--json")
    assert status == 0
    document = json.loads(printed)
    assert document["method"] == "stereo"
    assert set(document["sigma"]) == {"height", "tilt", "roll"}
    assert document["height"] == pytest.approx(truth.height_m, rel=0.03)
    written = read_manifest(recording).ground
    assert written is not None
    assert written.height_m == pytest.approx(document["height"], abs=1e-5)
    assert manifest.read_text().startswith(kept)


def test_points_are_taken_as_typed(trackwright: Trackwright, recording: Path) -> None:
    points = ["--points", "10,10:0,0", "--points", "60,12:1,0", "--points", "12,80:0,1"]
    status, _, said = trackwright("floor", recording, *points)
    assert status == 1
    assert "3 points" in said
    status, _, said = trackwright("floor", recording, "--points", "10,10")
    assert status == 2
    assert "320,240:1.5,4" in said


def test_two_ways_at_once_are_a_usage_error(trackwright: Trackwright, recording: Path) -> None:
    status, _, _ = trackwright("floor", recording, "--heights", "--points", "1,1:0,0")
    assert status == 2


def test_a_bare_video_has_nothing_to_write_into(trackwright: Trackwright, recording: Path) -> None:
    video = next(recording.glob("left*.*"))
    status, _, said = trackwright("floor", video, "--heights", "--write")
    assert status == 1
    assert "recording.toml" in said


def test_a_board_on_the_floor_gives_it(trackwright: Trackwright, tmp_path: Path) -> None:
    images = tmp_path / "left"
    images.mkdir()
    for number in range(2):
        cv2.imwrite(str(images / f"{number}.png"), lying(Board("chessboard", 9, 6, 0.1)))
    write_calibration(tmp_path / "rig.yaml", pair_of(CAMERA))
    given = (images, "--calibration", tmp_path / "rig.yaml", "--fps", "5", "--board", "9x6")
    status, printed, _ = trackwright("floor", *given, "--square", "0.1", "--json")
    document = json.loads(printed)
    assert (status, document["method"]) == (0, "board")
    assert document["height"] == pytest.approx(GROUND.height_m, rel=0.01)
    assert document["tilt"] == pytest.approx(GROUND.tilt_deg, abs=0.5)
    status, _, said = trackwright("floor", *given)
    assert status == 1
    assert "--square" in said


def test_the_floor_is_written_into_a_text_that_names_no_sources(
    trackwright: Trackwright, tmp_path: Path
) -> None:
    images = tmp_path / "mav0" / "cam0" / "data"
    images.mkdir(parents=True)
    (images.parent / "data.csv").write_text("#timestamp [ns],filename\n0,0.png\n")
    cv2.imwrite(str(images / "0.png"), lying(Board("chessboard", 9, 6, 0.1)))
    write_calibration(tmp_path / "rig.yaml", pair_of(CAMERA))
    text = '# ours\nfps = 5.0\n\n[calibration]\nfile = "rig.yaml"\n'
    (tmp_path / "recording.toml").write_text(text)
    given = ("floor", tmp_path, "--board", "9x6", "--square", "0.1", "--write")
    status, _, said = trackwright(*given)
    assert status == 0, said
    assert f"written: {tmp_path / 'recording.toml'}" in said
    assert (tmp_path / "recording.toml").read_text().startswith(text)
    with open_recording(tmp_path) as opened:
        assert opened.ground is not None
        assert opened.ground.height_m == pytest.approx(GROUND.height_m, rel=0.01)
    status, _, said = trackwright(*given, "--calibration", tmp_path / "rig.yaml")
    assert (status, "recording.toml of its own" in said) == (1, True)
