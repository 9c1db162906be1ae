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
from tracking.recording.spread_frames import spread_frames
from tracking.translation import Message, msg

_LOOKS = 15
"""Frames in which the board is looked for, evenly over the recording."""
_CORNER_PX = 0.2
"""Corners are no surer than so: prints bend, and lenses are not quite as calibrated."""
_STILL_PX = 2.0
"""A board whose points moved by less, in the median, lies where it lay."""
_FEWEST_COMMON = 6
"""Points that two views must share to be compared: parts of a ChArUco board are seen, too."""


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
    images = []
    # The board is looked for both ways round after that.
    for number in spread_frames(
        recording.frame_count, _LOOKS, lambda done, total: progress(done, 3 * total)
    ):
        left = recording.read(number).left
        images.append(np.asarray(cv2.cvtColor(left, cv2.COLOR_BGR2GRAY), np.uint8))
    read = len(images)
    return floor_of_board(
        recording.calibration.left,
        images,
        board,
        lambda done, total: progress(read + done, read + total),
    )


def floor_of_board(
    camera: Camera, images: Sequence[GrayImage], board: Board, progress: Progress = no_progress
) -> FloorEstimate:
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
    board, views = _found(images, board, progress)
    places = views_by_place(views)
    longest = max(places, key=len)
    lying = _mean_view(longest)
    on_board = board.places()[lying.point, :2]
    found = floor_of_places(camera, lying.pixel, on_board, "board", _CORNER_PX)
    return replace(found, notes=(*found.notes, *_notes(places, len(longest))))


def _found(
    images: Sequence[GrayImage], board: Board, progress: Progress
) -> tuple[Board, list[BoardView]]:
    """The board as it lies, and where it is seen."""
    if board.kind == "charuco" and not board.dictionary:
        name = find_dictionary(list(images), board)
        if not name:
            raise CalibrationError(
                "floor: no ChArUco markers of a common dictionary are seen; name the dictionary",
                option="--dictionary",
            )
        board = replace(board, dictionary=name)
    done = 0
    for way in (board, board.turned()):
        views = []
        for image in images:
            view = find_board(image, way)
            views += [view] if view is not None else []
            done += 1
            progress(done, 2 * len(images))
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


def views_by_place(views: Sequence[BoardView]) -> list[list[BoardView]]:
    """The views by where the board lies, those of one place the same way round."""
    places: list[list[BoardView]] = []
    for view in views:
        for others in places:
            alike = [way for way in _ways(view) if any(_is_same_place(way, one) for one in others)]
            if alike:
                others.append(alike[0])
                break
        else:
            places.append([view])
    return places


def _ways(view: BoardView) -> tuple[BoardView, BoardView]:
    """The view, and the same counted from its last point, as boards without a mark may be found."""
    return view, BoardView(view.point, view.pixel[::-1].copy())


def _is_same_place(one: BoardView, other: BoardView) -> bool:
    _, mine, its = np.intersect1d(one.point, other.point, return_indices=True)
    if len(mine) < _FEWEST_COMMON:
        return False
    return float(np.median(np.hypot(*(one.pixel[mine] - other.pixel[its]).T))) < _STILL_PX


def _mean_view(views: Sequence[BoardView]) -> BoardView:
    """Each point where the views that have it see it, on average."""
    points = np.concatenate([view.point for view in views])
    pixels = np.concatenate([view.pixel for view in views])
    seen, row = np.unique(points, return_inverse=True)
    total = np.column_stack([np.bincount(row, pixels[:, axis]) for axis in (0, 1)])
    return BoardView(seen, total / np.bincount(row)[:, None])


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
