"""`calibrate`: the document of the contract, and wrong input in one line."""

from __future__ import annotations

import json
from pathlib import Path

from command_line import Trackwright

from tests.calibration.rendered_boards import CAMERA, pair_of, write_pairs
from tracking.calibration.boards import Board
from tracking.geometry import read_calibration

BOARD = Board("chessboard", 8, 5, 0.03)


def test_the_contracts_document_is_printed_and_the_file_written(
    trackwright: Trackwright, tmp_path: Path
) -> None:
    left, right = write_pairs(tmp_path, BOARD, pair_of(CAMERA), count=6)
    out = tmp_path / "calibration.yaml"
    asked = ("--left", left, "--right", right, "--board", "8x5", "--square", "0.03")
    status, printed, _ = trackwright("calibrate", *asked, "-o", out, "--json")
    assert status == 0
    document = json.loads(printed)
    assert document["rms"] < 0.3
    assert document["pairs"] == 6
    assert set(document["per_picture"]) == {f"left{number:02}.png" for number in range(6)}
    assert {"left_rms", "right_rms", "rejected", "baseline", "coverage"} <= set(document)
    assert read_calibration([out]).baseline_m == document["baseline"]


def test_one_camera_has_no_figures_of_a_right_one(trackwright: Trackwright, tmp_path: Path) -> None:
    left, _ = write_pairs(tmp_path, BOARD, pair_of(CAMERA), count=6)
    status, printed, _ = trackwright("calibrate", "--left", left, "--board", "8x5", "--json")
    assert status == 0
    assert "right_rms" not in json.loads(printed)


def test_a_board_that_cannot_be_is_a_usage_error(trackwright: Trackwright) -> None:
    for wrong in (("--board", "nine"), ("--board", "9x6", "--square", "0")):
        status, printed, said = trackwright("calibrate", "--left", "left", *wrong)
        assert (status, printed) == (2, "")
        assert "--board" in said


def test_pictures_that_are_not_there_are_told_in_one_line(
    trackwright: Trackwright, tmp_path: Path
) -> None:
    out = tmp_path / "calibration.yaml"
    status, _, said = trackwright("calibrate", "--left", tmp_path / "no*.png", "-o", out)
    assert status == 1
    assert "no images found" in said
    assert not out.exists()
