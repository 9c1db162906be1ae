"""The step of the cameras: files, which is left, how both lie in one image, the lag."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from app.core.i18n import sentence, tr
from app.features.setup.floor_marks import with_floor
from app.features.setup.presenter import bare
from app.features.setup.scene import Arrangement, FloorMethod, SetupPicture, SetupScene, SetupState
from tracking.errors import RecordingError, TrackwrightError
from tracking.people.first_lag import first_lag
from tracking.progress import Progress
from tracking.recording import MANIFEST_NAME, open_recording
from tracking.recording.frame import Image
from tracking.recording.image_pairs import LAYOUTS
from tracking.recording.limits import checked_fps
from tracking.setup import SetupPlan, find_cameras, pair_by_name
from tracking.setup.files import calibration_beside, is_container, may_be_camera, sources_in
from tracking.setup.plan import options_of_plan, plan_of_known
from tracking.translation import Message

_BETWEEN_PX = 8
_STEPS = 3


def plan_of_paths(paths: Sequence[Path]) -> SetupPlan:
    """The plan that files, a folder with some, or a recording that is set up again begin with.

    Raises:
        RecordingError: nothing there can be a recording.
    """
    if len(paths) == 1 and paths[0].name == MANIFEST_NAME:
        paths = [paths[0].parent]
    known = plan_of_known(paths[0]) if len(paths) == 1 else None
    if known is not None:
        return known
    if len(paths) == 1 and paths[0].is_dir():
        paths = sources_in(paths[0])
    paths = [path for path in paths if may_be_camera(path)] or paths
    pair = pair_by_name(paths)
    if pair is not None:
        return SetupPlan(pair.left, pair.right)
    if len(paths) > 2:
        raise RecordingError(
            "{count} files are given, and by their names no two are a pair; give two",
            count=len(paths),
        )
    return SetupPlan(paths[0], paths[1] if len(paths) == 2 else None)


def look(plan: SetupPlan, progress: Progress) -> SetupState:
    """Find what the cameras' images tell; slow.

    Raises:
        RecordingError: files cannot be read, or differ in size.
    """
    if plan.at is not None and (plan.at / MANIFEST_NAME).is_file():
        state = state_of_plan(plan)
        return replace(state, found=(tr("As recording.toml has it."), *state.found))
    progress(0, _STEPS)
    if plan.at is not None or is_container(plan.left):
        return _look_into_known(plan, progress)
    found = find_cameras(plan.left, plan.right)
    progress(1, _STEPS)
    plan = replace(
        plan,
        left=found.left,
        right=found.right,
        layout=found.layout,
        first="left" if found.left_first else "right",
    )
    plan, beside = _with_calibration_beside(plan)
    lag = find_lag(plan) if found.same_scene and not found.doubts else None
    progress(_STEPS, _STEPS)
    told = (*found.notes, *beside)
    notes, doubts = (tuple(map(sentence, lines)) for lines in (told, found.doubts))
    return SetupState(replace(plan, lag=lag or None), found=notes, doubts=doubts, found_lag=lag)


def _look_into_known(plan: SetupPlan, progress: Progress) -> SetupState:
    """Of what says itself what its cameras are: the lag alone is looked for."""
    told = find_cameras(plan.left, None).notes if is_container(plan.left) else ()
    progress(1, _STEPS)
    state = state_of_plan(plan)
    lag = find_lag(plan) if plan.is_stereo else None
    progress(_STEPS, _STEPS)
    found = (*map(sentence, told), *state.found) or (tr("As its files have it."),)
    return replace(
        state, plan=replace(state.plan or plan, lag=lag or None), found=found, found_lag=lag
    )


def state_of_plan(plan: SetupPlan) -> SetupState:
    """What a recording that is there begins with; without a calibration that beside its files."""
    plan, beside = _with_calibration_beside(plan)
    method: FloorMethod = "typed" if plan.ground else "measured"
    return SetupState(plan, found=tuple(map(sentence, beside)), floor_method=method)


def _with_calibration_beside(plan: SetupPlan) -> tuple[SetupPlan, tuple[Message, ...]]:
    """The plan with the calibration that lies beside its files, if it has none; what is told."""
    if plan.calibration:
        return plan, ()
    calibration, told = calibration_beside(plan.left)
    return replace(plan, calibration=calibration), told


def find_lag(plan: SetupPlan) -> int | None:
    """Frames by which the right camera is late; None: nothing moves, or one camera; slow."""
    plan = replace(bare(plan), lag=None, calibration=plan.calibration)
    try:
        with open_recording(plan.folder, options_of_plan(plan)) as recording:
            return first_lag(recording) if recording.is_stereo else None
    except TrackwrightError:
        if not plan.calibration:
            raise
        return find_lag(replace(plan, calibration=()))


def exchanged(state: SetupState) -> SetupState:
    """The same with left and right exchanged; the floor was of the other camera."""
    plan = state.plan
    if plan is None or not plan.is_stereo:
        return state
    lag = None if plan.lag is None else -plan.lag
    if plan.right is not None:
        left, right, depth = plan.topics
        topics = (right, left, depth)
        plan = replace(plan, left=plan.right, right=plan.left, lag=lag, topics=topics)
    else:
        plan = replace(plan, first="right" if plan.first == "left" else "left", lag=lag)
    found_lag = None if state.found_lag is None else -state.found_lag
    return replace(
        state,
        plan=replace(plan, ground=None),
        by_hand=state.by_hand | {"left"},
        found_lag=found_lag,
        floor_told="",
        floor_doubt="",
        points=(),
        distances=(),
    )


def arrangement_of(plan: SetupPlan) -> Arrangement:
    """How the cameras lie in their files."""
    return plan.layout or ("pair" if plan.right is not None else "one")


def arrangements(plan: SetupPlan) -> tuple[Arrangement, ...]:
    """Those that the files allow."""
    two = plan.right is not None
    return ("pair", "one") if two else ("one", *LAYOUTS)


def with_arrangement(state: SetupState, wanted: Arrangement) -> SetupState:
    """The same with the cameras lying otherwise in their files."""
    plan = state.plan
    if plan is None or wanted == arrangement_of(plan):
        return state
    if wanted == "one":
        plan = replace(plan, right=None, layout=None, lag=None)
    elif wanted != "pair":
        plan = replace(plan, right=None, layout=wanted, lag=None, depth=None)
    return replace(state, plan=plan, by_hand=state.by_hand | {"arrangement"})


def with_lag(state: SetupState, lag: int) -> SetupState:
    """The same with a lag that a person set."""
    if state.plan is None or lag == (state.plan.lag or 0):
        return state
    plan = replace(state.plan, lag=lag or None)
    return replace(state, plan=plan, by_hand=state.by_hand | {"lag"})


def with_fps(state: SetupState, fps: float | None) -> SetupState:
    """The same with another frame rate; None: as the files say. Raises RecordingError."""
    if state.plan is None or fps == state.plan.fps:
        return state
    checked = None if fps is None else checked_fps(fps, tr("frame rate"))
    return replace(state, plan=replace(state.plan, fps=checked))


def lag_told(state: SetupState) -> str:
    """Whether the lag was found or set."""
    if "lag" in state.by_hand:
        if state.found_lag is None:
            return tr("Set.")
        return tr("Set; {lag} frames were found.", lag=state.found_lag)
    if state.found_lag is None:
        return tr("Not told by the images.")
    return tr("Found from what moves.")


def cameras_picture(scene: SetupScene, pointer: tuple[float, float] | None = None) -> SetupPicture:
    """Left and right beside each other, the left one over its floor where that is known."""
    images, plan = scene.images, scene.state.plan
    if images is None or plan is None:
        return SetupPicture(said=_said_without_images(scene))
    if images.right is None:
        picture = SetupPicture(images.left, ((0.0, tr("The only camera")),), said=tr("The camera"))
    else:
        picture = side_by_side(images.left, images.right)
    return with_floor(picture, scene, pointer)


def _said_without_images(scene: SetupScene) -> str:
    """What stands in place of the picture."""
    plan, checked = scene.state.plan, scene.checked
    if scene.doing:
        return scene.doing
    if plan is None:
        return tr("Drop one or two videos, or a folder, here.")
    if checked.plan == plan and checked.problem:
        return tr("There is no image of these cameras.")
    return tr("Reading the images")


def side_by_side(left: Image, right: Image) -> SetupPicture:
    """Two images beside each other, with their titles."""
    gap = np.zeros((left.shape[0], _BETWEEN_PX, 3), np.uint8)
    image = np.concatenate((left, gap, right), axis=1)
    titles = ((0.0, tr("Left camera")), (float(left.shape[1] + _BETWEEN_PX), tr("Right camera")))
    return SetupPicture(image, titles, said=tr("Left and right camera"))
