"""What the set-up knows of cameras, calibration and floor, and the picture it shows of them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import cv2
import numpy as np

from app.core.i18n import tr
from tracking.calibration.floor import FloorEstimate, floor_by_people, floor_by_stereo
from tracking.errors import RecordingError, TrackwrightError
from tracking.geometry import Ground, View, read_calibration
from tracking.people.first_lag import first_lag
from tracking.progress import Progress
from tracking.recording import MANIFEST_NAME, OpenOptions, open_recording
from tracking.recording.frame import Image
from tracking.setup import CameraFindings, SetupPlan, find_cameras, pair_by_name, plan_of
from tracking.setup.files import sources_in

_GRID_M, _NEAR_M, _FAR_M, _ASIDE_M = 1.0, 0.0, 15.0, 6.0
"""Of the grid that is drawn on the floor: its step, and how far it reaches."""
_PIECE_M = 0.25
"""Lines are drawn in pieces, which may be cut at the edge of what the lens shows."""
_GRID, _HORIZON, _FIGURE = (90, 220, 120), (80, 190, 255), (255, 200, 60)
"""BGR."""
FIGURE_M, _FIGURE_WIDTH_M = 1.7, 0.5
_CALIBRATIONS = ("calibration.yaml", "calibration.yml", "calib.txt", "calib.json", "camchain.yaml")


@dataclass(frozen=True, slots=True, eq=False)
class SetupScene:
    """All that the set-up shows.

    Attributes:
        plan: what will be written. image: of the left camera; None: not looked at yet.
        found, doubts: what the images tell of the cameras, in words.
        floor_told: how the floor was found; "" where it was typed or is unknown.
        problem: why the plan cannot be used as it is; "" where it can.
    """

    plan: SetupPlan
    image: Image | None = None
    found: str = ""
    doubts: str = ""
    floor_told: str = ""
    problem: str = ""

    @property
    def stereo(self) -> bool:
        """Whether there are two cameras."""
        return self.plan.right is not None or self.plan.layout is not None


def scene_of_paths(paths: list[Path]) -> SetupScene:
    """The start of a set-up: files, a folder with some, or a recording that is set up again.

    Raises:
        RecordingError: nothing there can be a recording.
    """
    if len(paths) == 1 and (paths[0] / MANIFEST_NAME).is_file():
        plan = plan_of(paths[0])
        return SetupScene(plan, _image(plan), tr("as recording.toml says"))
    if len(paths) == 1 and paths[0].is_dir():
        paths = list(sources_in(paths[0]))
    pair = pair_by_name(paths)
    if pair is not None:
        return look(SetupPlan(pair.left, pair.right))
    if len(paths) > 2:
        raise RecordingError(
            "{count} files are given, and by their names no two are a pair; give two",
            count=len(paths),
        )
    return look(SetupPlan(paths[0], paths[1] if len(paths) == 2 else None))


def look(plan: SetupPlan) -> SetupScene:
    """Find what the cameras' images tell; slow. Raises RecordingError for unreadable files."""
    found = find_cameras(plan.left, plan.right)
    plan = replace(
        plan,
        left=found.left,
        right=found.right,
        layout=found.layout,
        first="left" if found.left_first else "right",
        calibration=plan.calibration or _calibration_beside(found.left),
    )
    told, doubts = (" ".join(map(tr, lines)) for lines in (found.notes, found.doubts))
    scene = SetupScene(plan, _image(plan), told, doubts)
    if found.same_scene and not found.doubts:
        scene = _with_lag(scene, found)
    return checked(scene)


def _with_lag(scene: SetupScene, found: CameraFindings) -> SetupScene:
    with open_recording(scene.plan.folder, options_of(scene.plan)) as recording:
        lag = first_lag(recording) if recording.is_stereo else None
    if not lag:
        return scene
    late = tr("The right camera is {lag} frames late.", lag=lag)
    told = f"{scene.found} {late}" if found.notes else late
    return replace(scene, plan=replace(scene.plan, lag=lag), found=told)


def _calibration_beside(left: Path) -> tuple[Path, ...]:
    """A calibration by a usual name in the folder of the left camera's file."""
    found = [left.parent / name for name in _CALIBRATIONS if (left.parent / name).is_file()]
    return tuple(found[:1])


def _image(plan: SetupPlan) -> Image:
    """A picture of the left camera from the middle of the footage."""
    bare = replace(plan, calibration=(), ground=None)
    with open_recording(plan.folder, options_of(bare)) as recording:
        return recording.read(recording.frame_count // 2).left


def swapped(scene: SetupScene) -> SetupScene:
    """The same with left and right exchanged."""
    plan = scene.plan
    if plan.right is not None:
        lag = None if plan.lag is None else -plan.lag
        plan = replace(plan, left=plan.right, right=plan.left, lag=lag)
    elif plan.layout is not None:
        plan = replace(plan, first="right" if plan.first == "left" else "left")
    return checked(replace(scene, plan=plan, image=_image(plan), floor_told=""))


def with_calibration(scene: SetupScene, files: tuple[Path, ...]) -> SetupScene:
    """The same with another calibration, or with none."""
    return checked(replace(scene, plan=replace(scene.plan, calibration=files), floor_told=""))


def with_ground(scene: SetupScene, ground: Ground | None) -> SetupScene:
    """The same with a floor that was typed."""
    return checked(replace(scene, plan=replace(scene.plan, ground=ground), floor_told=""))


def measured(scene: SetupScene, progress: Progress) -> FloorEstimate:
    """The floor, by stereo where there are two cameras, else by people; slow.

    Raises:
        CalibrationError, RecordingError: it is not found, or the plan cannot be opened.
    """
    plan = replace(scene.plan, ground=None)
    with open_recording(plan.folder, options_of(plan)) as recording:
        by_stereo = recording.is_stereo or recording.has_depth
        find = floor_by_stereo if by_stereo else floor_by_people
        return find(recording, progress)


def with_estimate(scene: SetupScene, found: FloorEstimate) -> SetupScene:
    """The same with a floor that was measured, rounded to what a person would type."""
    ground = found.ground
    rounded = Ground(
        round(ground.height_m, 3), round(ground.tilt_deg, 2), round(ground.roll_deg, 2)
    )
    told = tr(
        "Measured: height within {height:.2f} m, tilt within {tilt:.1f} degrees.",
        height=found.height_sigma_m,
        tilt=found.tilt_sigma_deg,
    )
    notes = " ".join(map(tr, found.notes))
    scene = replace(scene, plan=replace(scene.plan, ground=rounded))
    return replace(checked(scene), floor_told=f"{told} {notes}".strip())


def checked(scene: SetupScene) -> SetupScene:
    """The same with what is wrong with the plan, by opening it."""
    try:
        with open_recording(scene.plan.folder, options_of(scene.plan)):
            problem = ""
    except TrackwrightError as error:
        problem = tr(error.message)
    return replace(scene, problem=problem)


def options_of(plan: SetupPlan) -> OpenOptions:
    """The plan as options of a recording without a manifest."""
    ground = plan.ground
    return OpenOptions(
        left=plan.left,
        right=plan.right,
        calibration=plan.calibration,
        height_m=ground.height_m if ground else None,
        tilt_deg=ground.tilt_deg if ground else None,
        roll_deg=ground.roll_deg if ground else None,
        fps=plan.fps,
        layout=plan.layout,
        first=plan.first if plan.layout else None,
        look=plan.region.look,
        mask=plan.region.mask,
    )


def picture_of(scene: SetupScene) -> Image | None:
    """The left camera's image with grid, horizon and a figure on the floor, as far as known."""
    if scene.image is None:
        return None
    image = scene.image.copy()
    view = _view(scene)
    if view is None:
        return image
    width = max(1, round(image.shape[1] / 640))
    for line in _grid_lines():
        _draw(image, view.pixel_from_world(line), _GRID, width)
    _draw_horizon(image, view, width)
    _draw_figure(image, view, width)
    return image


def _view(scene: SetupScene) -> View | None:
    plan, image = scene.plan, scene.image
    if not plan.calibration or plan.ground is None or image is None:
        return None
    size = image.shape[1], image.shape[0]
    try:
        calibration = read_calibration(plan.calibration, size).scaled_to(size)
    except TrackwrightError:
        return None
    return View(calibration.left, plan.ground)


def _grid_lines() -> list[np.ndarray]:
    """(n, 3) m: lines along and across the floor before the camera, and around below it."""
    near = -_ASIDE_M
    along = np.arange(near, _FAR_M + _PIECE_M, _PIECE_M)
    across = np.arange(-_ASIDE_M, _ASIDE_M + _PIECE_M, _PIECE_M)
    lines = [
        np.column_stack((np.full(len(along), x), along, np.zeros(len(along))))
        for x in np.arange(-_ASIDE_M, _ASIDE_M + _GRID_M, _GRID_M)
    ]
    return lines + [
        np.column_stack((across, np.full(len(across), y), np.zeros(len(across))))
        for y in np.arange(near, _FAR_M + _GRID_M, _GRID_M)
    ]


def _draw(image: Image, pixels: np.ndarray, colour: tuple[int, int, int], width: int) -> None:
    """A line in pieces; those that leave the image by far are left out."""
    height, across = image.shape[:2]
    near = np.isfinite(pixels).all(axis=1)
    near &= (np.abs(np.nan_to_num(pixels)) < 4 * max(height, across)).all(axis=1)
    points = np.nan_to_num(pixels).round().astype(int)
    for row in np.flatnonzero(near[:-1] & near[1:]).tolist():
        begin, end = tuple(points[row].tolist()), tuple(points[row + 1].tolist())
        cv2.line(image, begin, end, colour, width, cv2.LINE_AA)


def _draw_horizon(image: Image, view: View, width: int) -> None:
    angle = np.deg2rad(np.arange(-80.0, 81.0, 2.0))
    far = 1e5 * np.column_stack((np.sin(angle), np.cos(angle), np.zeros(len(angle))))
    _draw(image, view.pixel_from_world(far), _HORIZON, width)


def _draw_figure(image: Image, view: View, width: int) -> None:
    """Somebody of usual height where the lower middle of the image shows the floor."""
    middle = np.array([[image.shape[1] * 0.5, image.shape[0] * 0.75]])
    place = view.floor_from_pixel(middle)
    if not np.isfinite(place).all():
        return
    box = view.box_of_person(place, FIGURE_M, _FIGURE_WIDTH_M)[0]
    if np.isfinite(box).all() and np.abs(box).max() < 1e4:
        left, top, wide, tall = box.round().astype(int).tolist()
        cv2.rectangle(image, (left, top), (left + wide, top + tall), _FIGURE, 2 * width)
