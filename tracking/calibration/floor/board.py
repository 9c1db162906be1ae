"""The floor from a calibration board that lies on it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import cv2
import numpy as np

from tracking.calibration.boards import Board
from tracking.calibration.boards.detection import (
    BoardView,
    GrayImage,
    find_board,
    find_dictionary,
)
from tracking.calibration.floor.estimate import FloorEstimate
from tracking.calibration.floor.points import floor_of_places
from tracking.errors import CalibrationError
from tracking.geometry import Camera
from tracking.progress import Progress, no_progress
from tracking.recording import Recording
from tracking.translation import Message, msg

_LOOKS = 15
"""Frames in which the board is looked for, evenly over the recording."""
_CORNER_PX = 0.2
"""Corners are no surer than so: prints bend, and lenses are not quite as calibrated."""
_STILL_PX = 2.0
"""A board whose points moved by less, in the median, lies where it lay."""


def floor_by_board(
    recording: Recording, board: Board, progress: Progress = no_progress
) -> FloorEstimate:
    """The floor that a board lies on, seen by the left camera in some of the frames.

    Where the board is seen at several places, the one counts at which it is seen most often: it
    was carried there and lies still.

    Raises:
        CalibrationError: the camera is not calibrated, the board's square is not known, or the
            board is not found.
        RecordingError: a frame cannot be read.
    """
    if recording.calibration is None:
        raise CalibrationError(
            "{path}: the floor by a board needs a calibrated camera; give its calibration",
            option="--calibration",
            path=recording.path,
        )
    numbers = np.linspace(0, recording.frame_count - 1, min(_LOOKS, recording.frame_count))
    images = []
    for done, number in enumerate(np.unique(numbers.astype(int)).tolist()):
        left = recording.read(number).left
        images.append(np.asarray(cv2.cvtColor(left, cv2.COLOR_BGR2GRAY), np.uint8))
        progress(done + 1, len(numbers))
    return floor_of_board(recording.calibration.left, images, board)


def floor_of_board(camera: Camera, images: Sequence[GrayImage], board: Board) -> FloorEstimate:
    """The floor that a board lies on.

    Args:
        images: (height, width) grey, of the camera as it records; one suffices.

    Raises:
        CalibrationError: the board's square is not known, or the board is not found.
    """
    if board.square_m is None:
        raise CalibrationError(
            "floor: the height needs the board's square in metres; measure it on the print",
            option="--square",
        )
    board, views = _found(images, board)
    places = _lying(views)
    longest = max(places, key=len)
    point = longest[0].point
    pixels = np.mean([view.pixel for view in longest], axis=0)
    on_board = board.places()[point, :2]
    found = floor_of_places(camera, pixels, on_board, "board", _CORNER_PX)
    return replace(found, notes=(*found.notes, *_notes(places, len(longest))))


def _found(images: Sequence[GrayImage], board: Board) -> tuple[Board, list[BoardView]]:
    """The board as it lies, and where it is seen."""
    if board.kind == "charuco" and not board.dictionary:
        name = find_dictionary(list(images), board)
        if not name:
            raise CalibrationError(
                "floor: no ChArUco markers of a common dictionary are seen; name the dictionary",
                option="--dictionary",
            )
        board = replace(board, dictionary=name)
    for way in (board, board.turned()):
        seen = [find_board(image, way) for image in images]
        views = [view for view in seen if view is not None]
        if views:
            return way, views
    raise CalibrationError(
        "floor: the board of {columns} x {rows} is found in none of {count} images; check its size "
        "(inner corners of a chessboard), that all of it is in view, and the light",
        option="--board",
        columns=board.columns,
        rows=board.rows,
        count=len(images),
    )


def _lying(views: Sequence[BoardView]) -> list[list[BoardView]]:
    """The views by where the board lies; views of one place show the same points."""
    places: list[list[BoardView]] = []
    for view in views:
        for others in places:
            if _is_same_place(view, others[0]):
                others.append(view)
                break
        else:
            places.append([view])
    return places


def _is_same_place(one: BoardView, other: BoardView) -> bool:
    if not np.array_equal(one.point, other.point):
        return False
    return float(np.median(np.hypot(*(one.pixel - other.pixel).T))) < _STILL_PX


def _notes(places: Sequence[Sequence[BoardView]], longest: int) -> tuple[Message, ...]:
    if len(places) == 1:
        return ()
    return (
        msg(
            "the board is seen at {places} places; the floor is where it is seen most often "
            "({count} images)",
            places=len(places),
            count=longest,
        ),
    )
