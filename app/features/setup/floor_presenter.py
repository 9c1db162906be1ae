"""The step of the floor: measured, typed, clicked, or from a pose; grid, horizon and a figure."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from app.core.i18n import sentence, tr
from app.features.setup.calibration_presenter import board_of
from app.features.setup.cameras_presenter import cameras_picture
from app.features.setup.floor_marks import with_floor
from app.features.setup.scene import SetupPicture, SetupScene, SetupState
from tracking.calibration.floor import (
    FloorEstimate,
    FloorPoint,
    floor_by_board,
    floor_by_distances,
    floor_by_people,
    floor_by_points,
    floor_by_pose,
    floor_by_stereo,
    with_calibration,
)
from tracking.errors import CalibrationError
from tracking.geometry import Ground
from tracking.progress import Progress
from tracking.recording import Recording, open_recording
from tracking.recording.limits import height_doubt
from tracking.recording.region_of_interest import EVERYWHERE
from tracking.setup.plan import options_of_plan

_UNSURE_HEIGHT, _UNSURE_TILT_DEG = 0.05, 2.0
"""Standard deviations (height: share) from which a floor is told to be unsure."""


def measured(state: SetupState, progress: Progress) -> FloorEstimate:
    """The floor, by stereo where there are two calibrated cameras or depth, else by people; slow.

    Raises:
        CalibrationError, RecordingError: it is not found, or the plan cannot be opened.
    """
    with _opened(state) as recording:
        calibration = recording.calibration
        pair = recording.is_stereo and calibration is not None and calibration.right is not None
        deep = recording.has_depth and recording.rectification is not None
        find = floor_by_stereo if pair or deep else floor_by_people
        return with_calibration(find(recording, progress), calibration)


def measured_by_board(state: SetupState, progress: Progress) -> FloorEstimate:
    """The floor by the board that lies on it; slow.

    Raises:
        CalibrationError, RecordingError: it is not found, or the plan cannot be opened.
    """
    board = board_of(state.board)
    with _opened(state) as recording:
        found = floor_by_board(recording, board, progress)
        return with_calibration(found, recording.calibration)


def _opened(state: SetupState) -> Recording:
    """What was entered so far, without a floor and a region."""
    assert state.plan is not None, "there are cameras"
    plan = replace(state.plan, ground=None, region=EVERYWHERE)
    return open_recording(plan.folder, options_of_plan(plan))


def estimated(scene: SetupScene) -> FloorEstimate:
    """The floor of what was clicked or read; quick.

    Raises:
        CalibrationError: too few points, no pose, or no calibration.
    """
    state, calibration = scene.state, scene.checked.calibration
    if calibration is None:
        raise CalibrationError("floor: the camera is not calibrated; do the step before first")
    camera = calibration.left
    if state.floor_method == "points":
        return with_calibration(floor_by_points(camera, state.points), calibration)
    if state.floor_method == "distances":
        pixels = np.array([(point.u, point.v) for point in state.points], float).reshape(-1, 2)
        found = floor_by_distances(camera, pixels, state.distances)
        return with_calibration(found, calibration)
    if state.pose_file is None:
        raise CalibrationError("floor: choose the file with the camera's pose first")
    return floor_by_pose(state.pose_file, camera, state.convention)


def with_estimate(state: SetupState, found: FloorEstimate) -> SetupState:
    """The same with a floor that was found, rounded to what a person would type."""
    if state.plan is None:
        return state
    ground = found.ground
    rounded = Ground(
        round(ground.height_m, 3), round(ground.tilt_deg, 2), round(ground.roll_deg, 2)
    )
    return replace(
        state,
        plan=replace(state.plan, ground=rounded),
        floor_told=_told(found),
        floor_doubt=_doubt(found),
    )


def _told(found: FloorEstimate) -> str:
    if found.method == "pose":
        return tr("Read from the pose.")
    how = {
        "stereo": tr("Measured by stereo"),
        "people": tr("Measured by people's heights"),
        "points": tr("From the points"),
        "board": tr("By the board"),
    }.get(found.method, "")
    return tr(
        "{how}: height within {height:.2f} m, tilt within {tilt:.1f} degrees.",
        how=how,
        height=found.height_sigma_m,
        tilt=found.tilt_sigma_deg,
    )


def _doubt(found: FloorEstimate) -> str:
    lines = list(map(sentence, found.notes))
    share = found.height_sigma_m / max(found.ground.height_m, 1e-3)
    if share > _UNSURE_HEIGHT or found.tilt_sigma_deg > _UNSURE_TILT_DEG:
        lines.append(tr("It is not sure: compare the figure with people in the picture."))
    return " ".join(lines)


def with_typed(state: SetupState, height_m: float, tilt_deg: float, roll_deg: float) -> SetupState:
    """The same with a floor that was typed; height 0: unknown. Raises CalibrationError."""
    if state.plan is None:
        return state
    ground = Ground(height_m, tilt_deg, roll_deg) if height_m > 0 else None
    told = tr("Set by hand.") if ground is not None else ""
    doubt = None if ground is None else height_doubt(ground)
    plan = replace(state.plan, ground=ground)
    said = "" if doubt is None else sentence(doubt)
    return replace(state, plan=plan, floor_told=told, floor_doubt=said)


def with_point(state: SetupState, u: float, v: float) -> SetupState:
    """The same with one more point that was clicked on the floor."""
    return replace(state, points=(*state.points, FloorPoint(round(u, 1), round(v, 1), 0.0, 0.0)))


def with_point_moved(state: SetupState, row: int, u: float, v: float) -> SetupState:
    """The same with a point at another pixel."""
    moved = replace(state.points[row], u=round(u, 1), v=round(v, 1))
    return replace(state, points=(*state.points[:row], moved, *state.points[row + 1 :]))


def with_place(state: SetupState, row: int, x_m: float, y_m: float) -> SetupState:
    """The same with the place of a point in metres."""
    placed = replace(state.points[row], x_m=x_m, y_m=y_m)
    return replace(state, points=(*state.points[:row], placed, *state.points[row + 1 :]))


def without_point(state: SetupState, row: int) -> SetupState:
    """The same without a point, and without the distances from it."""

    def number(at: int) -> int:
        return at - (at > row)

    distances = tuple(
        (number(one), number(other), metres)
        for one, other, metres in state.distances
        if row not in (one, other)
    )
    points = (*state.points[:row], *state.points[row + 1 :])
    return replace(state, points=points, distances=distances)


def with_distances(state: SetupState, distances: dict[tuple[int, int], float]) -> SetupState:
    """The same with these metres between points; 0: not known."""
    known = tuple((*pair, metres) for pair, metres in distances.items() if metres > 0)
    return replace(state, distances=known)


def pairs_of_points(state: SetupState) -> tuple[tuple[int, int], ...]:
    """Every two points between which a distance can be entered."""
    count = len(state.points)
    return tuple((one, other) for other in range(count) for one in range(other))


def floor_picture(
    scene: SetupScene,
    pointer: tuple[float, float] | None,
    chosen: int = -1,
    *,
    with_points: bool = True,
) -> SetupPicture:
    """The left image with grid, horizon, points, and a figure where the pointer is."""
    images = scene.images
    if images is None:
        return cameras_picture(scene)
    points = np.array([(point.u, point.v) for point in scene.state.points], float).reshape(-1, 2)
    if not with_points or scene.state.floor_method not in ("points", "distances"):
        points = points[:0]
    picture = SetupPicture(
        images.left,
        points=points,
        handle=chosen,
        said=tr("Left camera with the floor's grid"),
    )
    return with_floor(picture, scene, pointer)
