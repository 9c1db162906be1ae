"""The floor found by a board that lies on it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from rendered_boards import CAMERA, FISHEYE, GROUND, image_of, lying

from tracking.calibration.boards import Board
from tracking.calibration.boards.detection import BoardView, GrayImage, find_board
from tracking.calibration.floor import board as board_floor
from tracking.calibration.floor import floor_of_board
from tracking.errors import CalibrationError
from tracking.geometry import Ground

BOARDS = {
    "chessboard": Board("chessboard", 9, 6, 0.1),
    "charuco": Board("charuco", 8, 6, 0.12, dictionary="5X5_100"),
    "circles": Board("circles", 9, 6, 0.1),
    "asymmetric-circles": Board("asymmetric-circles", 4, 9, 0.07),
}


def assert_near(ground: Ground) -> None:
    """Within 1 % and half a degree."""
    assert ground.height_m == pytest.approx(GROUND.height_m, rel=0.01)
    assert ground.tilt_deg == pytest.approx(GROUND.tilt_deg, abs=0.5)
    assert ground.roll_deg == pytest.approx(GROUND.roll_deg, abs=0.5)


@pytest.mark.parametrize("kind", BOARDS)
def test_a_board_of_any_kind_on_the_floor_gives_the_floor(kind: str) -> None:
    found = floor_of_board(CAMERA, [lying(BOARDS[kind])], BOARDS[kind])
    assert_near(found.ground)
    assert found.method == "board"
    assert abs(found.ground.height_m - GROUND.height_m) < 4 * found.height_sigma_m


def test_a_fisheye_sees_the_floor_by_a_board() -> None:
    board = BOARDS["chessboard"]
    assert_near(floor_of_board(FISHEYE, [lying(board, FISHEYE)], board).ground)


def test_the_dictionary_of_a_charuco_board_is_found() -> None:
    board = BOARDS["charuco"]
    assert_near(floor_of_board(CAMERA, [lying(board)], replace(board, dictionary="")).ground)


def test_a_board_carried_about_counts_where_it_lies_longest() -> None:
    board = BOARDS["chessboard"]
    there = [lying(board)] * 2
    carried = image_of(board, CAMERA, np.eye(3), np.array([0.0, 0.0, 1.8]))
    found = floor_of_board(CAMERA, [carried, *there], board)
    assert_near(found.ground)
    assert any("2 places" in str(note) for note in found.notes)


def test_a_board_that_is_not_there_and_one_of_no_size_are_refused() -> None:
    empty = np.full((480, 640), 120, np.uint8)
    with pytest.raises(CalibrationError, match="found in none of 1 images"):
        floor_of_board(CAMERA, [empty], BOARDS["chessboard"])
    with pytest.raises(CalibrationError, match="square in metres"):
        floor_of_board(CAMERA, [empty], Board("chessboard", 9, 6))


def test_a_still_board_of_which_some_points_are_missed_lies_at_one_place(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    random = np.random.default_rng(3)

    def find_most(image: GrayImage, board: Board) -> BoardView | None:
        view = find_board(image, board)
        return view and view.only(random.choice(view.point, len(view) - 3, replace=False))

    monkeypatch.setattr(board_floor, "find_board", find_most)
    board = BOARDS["chessboard"]
    found = floor_of_board(CAMERA, [lying(board)] * 4, board)
    assert_near(found.ground)
    assert found.notes == floor_of_board(CAMERA, [lying(board)], board).notes


def test_a_board_counted_from_its_other_end_lies_where_it_lay() -> None:
    view = BoardView(np.arange(54), np.random.default_rng(3).uniform(0, 400, (54, 2)))
    turned = BoardView(view.point, view.pixel[::-1].copy())
    (place,) = board_floor.views_by_place([view, turned])
    np.testing.assert_allclose(place[1].pixel, view.pixel)


def test_the_search_for_a_board_is_told_image_by_image() -> None:
    told: list[tuple[int, int]] = []
    images = [lying(BOARDS["chessboard"])] * 2
    floor_of_board(CAMERA, images, BOARDS["chessboard"], lambda *step: told.append(step))
    assert told == [(1, 4), (2, 4)]
