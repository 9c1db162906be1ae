"""The step of the calibration: a file, a board, or rough from the images."""

from __future__ import annotations

import glob
import os
import re
from dataclasses import dataclass, replace
from pathlib import Path

import cv2
import numpy as np

from app.core.i18n import sentence, tr
from app.features.setup.cameras_presenter import cameras_picture
from app.features.setup.presenter import bare
from app.features.setup.scene import (
    MOST_ROWS_APART_PX,
    BoardForm,
    CalibrationMethod,
    CameraImages,
    RoughForm,
    SetupPicture,
    SetupScene,
    SetupState,
    Shown,
)
from tracking.calibration.boards import (
    Board,
    BoardCalibration,
    BoardRequest,
    FoundBoards,
    find_boards,
    fit_boards,
)
from tracking.calibration.rectified_preview import RectifiedPreview, rectified_preview
from tracking.calibration.rough import calibrate_images_roughly, calibrate_one_roughly
from tracking.errors import CalibrationError
from tracking.geometry import StereoCalibration
from tracking.progress import Progress
from tracking.recording import open_recording
from tracking.recording.frame import Image
from tracking.recording.images import IMAGE_SUFFIXES
from tracking.setup import SetupPlan, pair_by_name
from tracking.setup.files import may_be_camera
from tracking.setup.plan import options_of_plan

_MM = 1000.0
_LEAST_SQUARE_MM = 1.0
"""Of a board that a camera can see; less was meant as metres."""
_INSTANTS = 12
_LAST_DIGITS = re.compile(r"\d+(?=\D*$)")
_COVERED, _BARE = (90, 220, 120), (60, 60, 220)
"""BGR of cells of the image with points of boards, and without."""
_GOOD_PX, _GOOD_COVERED = 0.5, 0.6


@dataclass(frozen=True, slots=True, eq=False)
class MadeCalibration:
    """A calibration that was made. Attributes: told: how well, in words."""

    calibration: StereoCalibration
    told: str
    boards: BoardCalibration | None = None
    found: FoundBoards | None = None


def with_method(state: SetupState, method: CalibrationMethod) -> SetupState:
    """The same with another form shown."""
    return replace(state, calibration_method=method)


def with_board(state: SetupState, board: BoardForm) -> SetupState:
    """The same with what was entered of a board."""
    return replace(state, board=board)


def with_rough(state: SetupState, fov_deg: float, baseline_mm: float) -> SetupState:
    """The same with what was entered for a rough calibration."""
    return replace(state, rough=RoughForm(fov_deg, baseline_mm))


def with_files(state: SetupState, files: tuple[Path, ...]) -> SetupState:
    """The same with a calibration that was read from files, or with none."""
    return _with_calibration(state, files, "")


def with_made(state: SetupState, file: Path, told: str) -> SetupState:
    """The same with a calibration that was made and put into a file."""
    return _with_calibration(state, (file,), told)


def _with_calibration(state: SetupState, files: tuple[Path, ...], told: str) -> SetupState:
    """With another calibration; a floor that was found by the one before is doubtful now."""
    if state.plan is None:
        return state
    doubt = state.floor_doubt
    if state.plan.ground is not None and state.floor_told not in ("", tr("Set by hand.")):
        doubt = tr("The calibration has changed since: find the floor again.")
    return replace(
        state,
        plan=replace(state.plan, calibration=files),
        calibration_told=told,
        floor_doubt=doubt,
    )


def source_of_board(path: Path) -> str:
    """The source that a chosen file stands for: of a picture the series it is one of."""
    if path.suffix.lower() not in IMAGE_SUFFIXES:
        return str(path)
    pattern = _LAST_DIGITS.sub("*", path.stem)
    return str(path.with_name(pattern + path.suffix))


def other_source(left: str) -> str:
    """The right camera's source beside the left one's, by its name; "" where there is none."""
    path = Path(left)
    for here, there in (("left", "right"), ("Left", "Right"), ("LEFT", "RIGHT"), ("_L", "_R")):
        if here in path.name:
            name = there.join(path.name.rsplit(here, 1))
            beside = path.with_name(name)
            if _is_there(str(beside)):
                return str(beside)
    others = [p for p in path.parent.iterdir() if may_be_camera(p)] if _is_there(left) else []
    found = [pair_by_name([path, one]) for one in others if one != path]
    pairs = [pair for pair in found if pair is not None]
    if len(pairs) == 1:
        return str(pairs[0].right if pairs[0].left == path else pairs[0].left)
    return ""


def _is_there(source: str) -> bool:
    """Whether it is a file, a folder or a pattern of some; whatever was typed raises nothing."""
    return os.path.exists(source) or bool(glob.glob(source))  # noqa: PTH110, PTH207


def board_request(form: BoardForm, stereo: bool) -> BoardRequest:
    """What is to be calibrated.

    Raises:
        CalibrationError: something is not entered, or makes no board.
    """
    if not form.left or (stereo and not form.right):
        raise CalibrationError("choose the pictures or the video of the board first")
    if stereo and form.square_mm <= 0:
        raise CalibrationError(
            "Square: the side of a square is not entered; measure it on the print, in mm"
        )
    return BoardRequest(form.left, form.right if stereo else None, board_of(form), form.lens)


def board_of(form: BoardForm) -> Board:
    """The board that was entered. Raises CalibrationError: there is none like that."""
    if 0 < form.square_mm < _LEAST_SQUARE_MM:
        raise CalibrationError(
            "Square: {square:g} mm is no side of a square; enter it in mm, as 25 for 0.025 m",
            square=form.square_mm,
        )
    square_m = form.square_mm / _MM if form.square_mm > 0 else None
    return Board(form.kind, form.columns, form.rows, square_m)


def calibrate_board(form: BoardForm, stereo: bool, progress: Progress) -> MadeCalibration:
    """Look for the board and fit the cameras; slow.

    Raises:
        CalibrationError, RecordingError: no board is found, or the views make no camera.
    """
    found = find_boards(board_request(form, stereo), progress)
    return _calibrated(found, fit_boards(found))


def fit_again(found: FoundBoards, left_out: frozenset[str] | None) -> MadeCalibration:
    """Fit with other pictures left out; slow. Raises CalibrationError where too few are left."""
    return _calibrated(found, fit_boards(found, left_out))


def _calibrated(found: FoundBoards, made: BoardCalibration) -> MadeCalibration:
    lines = [
        tr(
            "Error {rms:.2f} px in {used} pictures; {share:.0%} of the image covered.",
            rms=made.rms_px,
            used=len(made.used),
            share=made.covered,
        )
    ]
    if made.row_error_px is not None:
        lines.append(tr("Rows after rectification {px:.2f} px apart.", px=made.row_error_px))
    if made.rms_px > _GOOD_PX:
        lines.append(tr("The error is large: leave out blurred pictures, or try another lens."))
    if made.covered < _GOOD_COVERED:
        lines.append(tr("Corners of the image are not covered: take pictures there, too."))
    lines += map(sentence, made.notes)
    return MadeCalibration(made.calibration, " ".join(lines), made, found)


def calibrate_rough(
    plan: SetupPlan, fov_deg: float, baseline_mm: float, progress: Progress
) -> MadeCalibration:
    """A rough calibration from the cameras' own images; slow.

    Raises:
        CalibrationError: the baseline is not entered, or the two do not show the same place.
        RecordingError: images cannot be read.
    """
    if plan.is_stereo and baseline_mm <= 0:
        raise CalibrationError(
            "the distance of the cameras is not entered; measure it from lens to lens, in m"
        )
    plan = bare(plan)
    with open_recording(plan.folder, options_of_plan(plan)) as recording:
        if not recording.is_stereo:
            made_of_one = calibrate_one_roughly(recording.size, fov_deg)
            told = tr("Rough: a field of view of {fov:.0f} degrees, no distortion.", fov=fov_deg)
            return MadeCalibration(made_of_one, told)
        last, lag = recording.frame_count - 1, plan.lag or 0
        numbers = np.unique(np.linspace(max(0, -lag), last - max(0, lag), _INSTANTS).astype(int))
        views = []
        for number in numbers.tolist():
            frame = recording.read(number, number + lag)
            assert frame.right is not None, "there are two cameras"
            views.append((frame.left, frame.right))
    made = calibrate_images_roughly(views, fov_deg, baseline_mm / _MM, progress)
    told = tr(
        "Rough: {share:.0%} of {count} matched points agree, {px:.2f} px off.",
        share=made.inlier_share,
        count=made.matches,
        px=made.row_error_px,
    )
    return MadeCalibration(made.calibration, told)


def preview(calibration: StereoCalibration, images: CameraImages) -> RectifiedPreview | None:
    """Both cameras rectified; None for one camera; slow. Raises CalibrationError."""
    if calibration.right is None or images.right is None:
        return None
    return rectified_preview(calibration, images.left, images.right)


def rows_told(found: RectifiedPreview) -> str:
    """How well the rows of both cameras lie level, in words."""
    if found.row_error_px is None:
        return tr("Rows cannot be compared: too few points are seen by both cameras.")
    if found.row_error_px <= MOST_ROWS_APART_PX:
        return tr("Rows of the same point are {px:.2f} px apart.", px=found.row_error_px)
    return tr(
        "Rows of the same point are {px:.2f} px apart: above 1 px the calibration does not fit.",
        px=found.row_error_px,
    )


def calibration_picture(
    scene: SetupScene,
    shown: Shown,
    rectified: RectifiedPreview | None,
    pointer: tuple[float, float] | None = None,
) -> SetupPicture:
    """The cameras as recorded, rectified with level lines, or covered by boards."""
    if shown == "rectified" and rectified is not None:
        width = rectified.image.shape[1] / 2
        titles = ((0.0, tr("Left, rectified")), (width, tr("Right, rectified")))
        return SetupPicture(rectified.image, titles, said=rows_told(rectified))
    if shown == "coverage" and scene.boards is not None:
        image = _coverage(scene)
        told = tr("{share:.0%} of the image covered by boards", share=scene.boards.covered)
        return SetupPicture(image, ((0.0, told),), said=told)
    return cameras_picture(scene, pointer)


def _coverage(scene: SetupScene) -> Image:
    """The left image (or none) under the cells in which points of boards fell."""
    assert scene.boards is not None, "there are boards"
    counts = scene.boards.coverage
    width, height = scene.boards.calibration.left.size
    rows, columns = counts.shape
    image = np.full((height, width, 3), 90, np.uint8)
    if scene.images is not None:
        image = np.asarray(cv2.resize(scene.images.left, (width, height)), np.uint8)
    tint = image.copy()
    for row in range(rows):
        for column in range(columns):
            top, bottom = row * height // rows, (row + 1) * height // rows
            left, right = column * width // columns, (column + 1) * width // columns
            colour = _COVERED if counts[row, column] else _BARE
            cv2.rectangle(tint, (left, top), (right - 2, bottom - 2), colour, -1)
    return np.asarray(cv2.addWeighted(image, 0.6, tint, 0.4, 0), np.uint8)
