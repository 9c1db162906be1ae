"""Cameras calibrated from rendered images of boards."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest

from tests.calibration.rendered_boards import (
    CAMERA,
    FISHEYE,
    image_of,
    pair_of,
    poses,
    write_pairs,
)
from tracking.calibration.boards import (
    Board,
    BoardCalibration,
    BoardKind,
    BoardRequest,
    LensKind,
    calibrate_boards,
    find_boards,
)
from tracking.errors import CalibrationError
from tracking.geometry import Camera, read_calibration, write_calibration

CHESSBOARD = Board("chessboard", 8, 5, 0.03)


def calibrated(
    folder: Path, board: Board, camera: Camera = CAMERA, lens: LensKind = "standard", **pairs: int
) -> BoardCalibration:
    """The calibration of a rendered pair of such cameras."""
    left, right = write_pairs(folder, board, pair_of(camera), **pairs)
    return calibrate_boards(BoardRequest(left, right, board, lens))


@pytest.mark.parametrize(
    ("kind", "columns", "rows", "dictionary"),
    [("chessboard", 8, 5, ""), ("charuco", 8, 6, "5X5_100"), ("circles", 8, 5, "")],
)
def test_a_pair_is_found_as_it_was_rendered(
    tmp_path: Path, kind: BoardKind, columns: int, rows: int, dictionary: str
) -> None:
    found = calibrated(tmp_path, Board(kind, columns, rows, 0.03, dictionary=dictionary))
    truth = pair_of(CAMERA)
    assert found.rms_px < 0.3
    assert found.row_error_px is not None
    assert found.row_error_px < 0.3
    assert found.calibration.left.matrix[0, 0] == pytest.approx(520, rel=0.01)
    assert found.calibration.baseline_m == pytest.approx(truth.baseline_m, rel=0.01)
    np.testing.assert_allclose(found.calibration.rotation, truth.rotation, atol=0.004)


def test_a_fisheye_is_found_as_it_was_rendered_and_read_back(tmp_path: Path) -> None:
    found = calibrated(tmp_path, CHESSBOARD, FISHEYE, "fisheye", count=10)
    assert found.rms_px < 0.3
    assert found.calibration.left.matrix[0, 0] == pytest.approx(330, rel=0.01)
    path = tmp_path / "calibration.yaml"
    write_calibration(path, found.calibration)
    again = read_calibration([path])
    assert again.left.fisheye
    points = np.array([[20.0, 30.0], [600.0, 400.0]])
    np.testing.assert_allclose(
        again.left.undistort(points), found.calibration.left.undistort(points)
    )


def test_a_fisheye_pair_that_sees_parts_of_a_charuco_board_is_found(tmp_path: Path) -> None:
    board = Board("charuco", 7, 5, 0.05, dictionary="4X4_50")
    found = calibrated(tmp_path, board, FISHEYE, "fisheye", count=12, seed=7)
    assert found.rms_px < 0.3
    assert found.calibration.left.matrix[0, 0] == pytest.approx(330, rel=0.02)


def test_one_camera_needs_no_size_of_the_square(tmp_path: Path) -> None:
    left, _ = write_pairs(tmp_path, CHESSBOARD, pair_of(CAMERA))
    found = calibrate_boards(BoardRequest(left, None, Board("chessboard", 8, 5)))
    assert found.right_rms_px is None
    assert found.calibration.right is None
    assert found.calibration.left.matrix[0, 0] == pytest.approx(520, rel=0.02)


def test_two_cameras_without_the_size_of_the_square_are_refused() -> None:
    with pytest.raises(CalibrationError, match="square in metres"):
        calibrate_boards(BoardRequest("left", "right", Board("chessboard", 8, 5)))


def test_a_board_given_on_its_side_is_found_and_told(tmp_path: Path) -> None:
    board = Board("charuco", 8, 6, 0.03, dictionary="5X5_100")
    left, _ = write_pairs(tmp_path, board, pair_of(CAMERA), count=5)
    found = calibrate_boards(BoardRequest(left, None, board.turned()))
    assert "the board is 8 x 6" in map(str, found.notes)


def test_a_view_whose_corners_are_off_is_left_out_and_told(tmp_path: Path) -> None:
    left, right = write_pairs(tmp_path, CHESSBOARD, pair_of(CAMERA))
    bent = tmp_path / "left03.png"
    image = cv2.imread(str(bent))
    u, v = np.meshgrid(np.arange(640, dtype=np.float32), np.arange(480, dtype=np.float32))
    cv2.imwrite(str(bent), cv2.remap(image, u + 4 * np.sin(v / 25), v, cv2.INTER_LINEAR))
    found = calibrate_boards(BoardRequest(left, right, CHESSBOARD))
    assert found.rejected == ("left03.png",)
    assert found.per_picture["left03.png"] > 2 * found.rms_px
    assert any("left03.png" in str(note) for note in found.notes)


def test_pictures_without_a_board_and_without_a_partner_are_told(tmp_path: Path) -> None:
    left, right = write_pairs(tmp_path, CHESSBOARD, pair_of(CAMERA))
    (tmp_path / "right02.png").unlink()
    blurred = cv2.GaussianBlur(cv2.imread(str(tmp_path / "left04.png")), (0, 0), 25)
    cv2.imwrite(str(tmp_path / "left04.png"), blurred)
    found = calibrate_boards(BoardRequest(left, right, CHESSBOARD))
    assert found.missed == ("left04.png",)
    assert "pictures without a partner: left02.png" in map(str, found.notes)


def test_sharp_frames_of_a_video_are_chosen(tmp_path: Path) -> None:
    video = tmp_path / "left.avi"
    writer = cv2.VideoWriter(str(video), cv2.VideoWriter.fourcc(*"MJPG"), 10, (640, 480))
    for number, (rotation, shift) in enumerate(poses(16, 4)):
        image = image_of(CHESSBOARD, CAMERA, rotation, shift)
        if number % 4 == 1:
            image = cv2.blur(image, (11, 1))
        writer.write(cv2.cvtColor(image, cv2.COLOR_GRAY2BGR))
    writer.release()
    found = calibrate_boards(BoardRequest(str(video), None, CHESSBOARD))
    assert not {"1", "5", "9", "13"} & set(found.used)
    assert found.calibration.left.matrix[0, 0] == pytest.approx(520, rel=0.02)


def test_of_50_pictures_40_of_them_blurred_the_sharp_ones_are_used(tmp_path: Path) -> None:
    kernel = np.full((1, 11), 1 / 11)
    for number, (rotation, shift) in enumerate(poses(50, 3)):
        image = image_of(CHESSBOARD, CAMERA, rotation, shift)
        moved = image if number % 5 == 0 else cv2.filter2D(image, -1, kernel)
        cv2.imwrite(str(tmp_path / f"left{number:02}.png"), moved)
    found = calibrate_boards(BoardRequest(str(tmp_path / "left*.png"), None, CHESSBOARD))
    assert set(found.used) <= {f"left{number:02}.png" for number in range(0, 50, 5)}
    assert any("are blurred, and left out" in str(note) for note in found.notes)
    assert len(found.used) + len(found.rejected) == 50
    assert found.calibration.left.matrix[0, 0] == pytest.approx(520, rel=0.01)


def test_boards_near_and_far_with_the_same_blur_are_all_sharp(tmp_path: Path) -> None:
    """A board 170 to 1400 px wide, four times each."""
    row, column = np.indices((6, 10))
    for number in range(16):
        square = (17, 30, 90, 140)[number // 4]
        image = np.full((1100, 1750), 150.0)
        drawn = np.kron((row + column) % 2 * 150.0 + 50.0, np.ones((square, square)))
        top, left = 40 + number % 4 * 20, 50 + number % 4 * 40
        paper = np.pad(drawn, square // 2, constant_values=200.0)
        image[top : top + len(paper), left : left + paper.shape[1]] = paper
        noise = np.random.default_rng(number).normal(0.0, 2.0, image.shape)
        seen = cv2.GaussianBlur(image, (0, 0), 0.8) + noise
        cv2.imwrite(str(tmp_path / f"{number:02}.png"), seen.clip(0, 255).astype(np.uint8))
    found = find_boards(BoardRequest(str(tmp_path), None, Board("chessboard", 9, 5)))
    assert len(found.views.views) == 16
    assert not any("blurred" in str(note) for note in found.notes)
    assert found.blurred == ()


def test_no_board_is_told_in_one_line_with_what_to_do(tmp_path: Path) -> None:
    for number in range(5):
        cv2.imwrite(str(tmp_path / f"{number}.png"), np.full((120, 160), 90, np.uint8))
    with pytest.raises(CalibrationError, match="found in 0 of 5 images") as error:
        calibrate_boards(BoardRequest(str(tmp_path), None, CHESSBOARD))
    assert "\n" not in str(error.value)


def test_boards_that_all_face_the_camera_are_refused(tmp_path: Path) -> None:
    for number in range(6):
        shift = np.array([0.03 * number - 0.08, 0.01 * number - 0.03, 0.6])
        cv2.imwrite(str(tmp_path / f"{number}.png"), image_of(CHESSBOARD, CAMERA, np.eye(3), shift))
    with pytest.raises(CalibrationError, match=r"faces the same way|no camera fits"):
        calibrate_boards(BoardRequest(str(tmp_path), None, CHESSBOARD))


@pytest.mark.parametrize("square_m", [0.0, -0.02, 25.0])
def test_a_square_of_no_sensible_size_is_refused(square_m: float) -> None:
    with pytest.raises(CalibrationError, match="side in metres"):
        Board("chessboard", 9, 6, square_m)


def test_swapped_cameras_are_told(tmp_path: Path) -> None:
    left, right = write_pairs(tmp_path, CHESSBOARD, pair_of(CAMERA))
    with pytest.raises(CalibrationError, match="swap"):
        calibrate_boards(BoardRequest(right, left, CHESSBOARD))


def test_a_video_beside_pictures_is_refused(tmp_path: Path) -> None:
    left, _ = write_pairs(tmp_path, CHESSBOARD, pair_of(CAMERA), count=2)
    video = tmp_path / "right.avi"
    writer = cv2.VideoWriter(str(video), cv2.VideoWriter.fourcc(*"MJPG"), 10, (640, 480))
    writer.write(np.zeros((480, 640, 3), np.uint8))
    writer.release()
    with pytest.raises(CalibrationError, match="two sets of pictures"):
        calibrate_boards(BoardRequest(left, str(video), CHESSBOARD))


def test_a_picture_that_cannot_be_read_is_left_out_and_told(tmp_path: Path) -> None:
    left, right = write_pairs(tmp_path, CHESSBOARD, pair_of(CAMERA), count=7)
    (tmp_path / "right05.png").write_bytes(b"no picture")
    assert calibrate_boards(BoardRequest(left, right, CHESSBOARD)).missed == ("left05.png",)
