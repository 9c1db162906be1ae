"""The step of the floor: measured, typed, clicked, or from a pose; grid, horizon and a figure."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from app.core.i18n import tr
from app.features.setup.cameras_presenter import cameras_picture
from app.features.setup.scene import SetupPicture, SetupScene, SetupState
from tracking.arrays import Floats
from tracking.calibration.floor import (
    FloorEstimate,
    FloorPoint,
    floor_by_distances,
    floor_by_people,
    floor_by_points,
    floor_by_pose,
    floor_by_stereo,
)
from tracking.errors import CalibrationError
from tracking.geometry import Ground, View
from tracking.progress import Progress
from tracking.recording import open_recording
from tracking.recording.region_of_interest import EVERYWHERE
from tracking.setup.plan import options_of_plan

FIGURE_M, _FIGURE_WIDTH_M = 1.7, 0.5
_GRID_M, _FAR_M, _ASIDE_M = 1.0, 15.0, 6.0
"""Of the grid that is drawn on the floor: its step, and how far it reaches."""
_PIECE_M = 0.25
"""Lines are drawn in pieces, which may be cut at the edge of what the lens shows."""
_FARTHEST_PX = 4
"""Of the image's larger side: pieces farther off are left out."""
_UNSURE_HEIGHT, _UNSURE_TILT_DEG = 0.05, 2.0
"""Standard deviations (height: share) from which a floor is told to be unsure."""


def view_of(scene: SetupScene) -> View | None:
    """The left camera over its floor; None where calibration or floor are not known."""
    plan, calibration = scene.state.plan, scene.checked.calibration
    if plan is None or plan.ground is None or calibration is None or scene.images is None:
        return None
    height, width = scene.images.left.shape[:2]
    if calibration.left.size != (width, height):
        return None
    return View(calibration.left, plan.ground)


def measured(state: SetupState, progress: Progress) -> FloorEstimate:
    """The floor, by stereo where there are two calibrated cameras or depth, else by people; slow.

    Raises:
        CalibrationError, RecordingError: it is not found, or the plan cannot be opened.
    """
    assert state.plan is not None, "there are cameras"
    plan = replace(state.plan, ground=None, region=EVERYWHERE)
    with open_recording(plan.folder, options_of_plan(plan)) as recording:
        calibration = recording.calibration
        pair = recording.is_stereo and calibration is not None and calibration.right is not None
        deep = recording.has_depth and recording.rectification is not None
        find = floor_by_stereo if pair or deep else floor_by_people
        return find(recording, progress)


def estimated(scene: SetupScene) -> FloorEstimate:
    """The floor of what was clicked or read; quick.

    Raises:
        CalibrationError: too few points, no pose, or no calibration.
    """
    state, calibration = scene.state, scene.checked.calibration
    if calibration is None:
        raise CalibrationError("floor: the camera is not calibrated; do the step before first")
    camera = calibration.left
    if state.floor_way == "points":
        return floor_by_points(camera, state.points)
    if state.floor_way == "distances":
        pixels = np.array([(point.u, point.v) for point in state.points], float).reshape(-1, 2)
        return floor_by_distances(camera, pixels, state.distances)
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
    }.get(found.method, "")
    return tr(
        "{how}: height within {height:.2f} m, tilt within {tilt:.1f} degrees.",
        how=how,
        height=found.height_sigma_m,
        tilt=found.tilt_sigma_deg,
    )


def _doubt(found: FloorEstimate) -> str:
    lines = [text[:1].upper() + text[1:] + "." for text in map(tr, found.notes)]
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
    plan = replace(state.plan, ground=ground)
    return replace(state, plan=plan, floor_told=told, floor_doubt="")


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
    if not with_points or scene.state.floor_way not in ("points", "distances"):
        points = points[:0]
    picture = SetupPicture(
        images.left,
        points=points,
        handle=chosen,
        said=tr("Left camera with the floor's grid"),
    )
    view = view_of(scene)
    if view is None:
        return picture
    size = images.left.shape[1], images.left.shape[0]
    grid = tuple(_drawable(view.pixel_from_world(line), size) for line in _grid_lines())
    where = pointer or (size[0] * 0.5, size[1] * 0.75)
    return replace(picture, grid=grid, horizon=_horizon(view, size), figure=_figure(view, where))


def _drawable(pixels: Floats, size: tuple[int, int]) -> Floats:
    """The pixels with NaN where they are far off the image: there lines are not drawn."""
    far = _FARTHEST_PX * max(size)
    near = np.asarray((np.abs(np.nan_to_num(pixels, nan=np.inf)) < far).all(axis=1))
    return np.where(near[:, None], pixels, np.nan)


def _grid_lines() -> list[Floats]:
    """(n, 3) m: lines along and across the floor before the camera, and around below it."""
    along = np.arange(-_ASIDE_M, _FAR_M + _PIECE_M, _PIECE_M)
    across = np.arange(-_ASIDE_M, _ASIDE_M + _PIECE_M, _PIECE_M)
    lines = [
        np.column_stack((np.full(len(along), x), along, np.zeros(len(along))))
        for x in np.arange(-_ASIDE_M, _ASIDE_M + _GRID_M, _GRID_M)
    ]
    return lines + [
        np.column_stack((across, np.full(len(across), y), np.zeros(len(across))))
        for y in np.arange(-_ASIDE_M, _FAR_M + _GRID_M, _GRID_M)
    ]


def _horizon(view: View, size: tuple[int, int]) -> Floats:
    angle = np.deg2rad(np.arange(-80.0, 81.0, 2.0))
    far = 1e5 * np.column_stack((np.sin(angle), np.cos(angle), np.zeros(len(angle))))
    return _drawable(view.pixel_from_world(far), size)


def _figure(view: View, where: tuple[float, float]) -> tuple[float, float, float, float] | None:
    """Somebody of usual height who stands where a pixel shows the floor; None: above it."""
    place = view.floor_from_pixel(np.array([where]))
    if not np.isfinite(place).all():
        return None
    box = view.box_of_person(place, FIGURE_M, _FIGURE_WIDTH_M)[0]
    if not np.isfinite(box).all() or np.abs(box).max() > 1e5:
        return None
    left, top, width, height = box.tolist()
    return left, top, width, height
