"""The set-up's course: what was entered with undo and redo, how each step stands."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from app.core.i18n import tr
from app.features.setup.scene import (
    CameraImages,
    Mark,
    SetupScene,
    SetupState,
    Step,
)
from tracking.recording import open_recording
from tracking.recording.region_of_interest import EVERYWHERE
from tracking.setup import SetupPlan
from tracking.setup.plan import options_of_plan

STEPS = tuple(Step)
_ANY_FPS = 25.0


def step_title(step: Step) -> str:
    """A step's name in the list."""
    return {
        Step.CAMERAS: tr("Cameras"),
        Step.CALIBRATION: tr("Calibration"),
        Step.FLOOR: tr("Floor"),
        Step.REGION: tr("Region"),
        Step.WRITE: tr("Write"),
    }[step]


class SetupHistory:
    """What was entered, step by step, to be undone and redone."""

    def __init__(self, state: SetupState) -> None:
        self._states = [state]
        self._at = 0

    @property
    def state(self) -> SetupState:
        """What counts now."""
        return self._states[self._at]

    @property
    def may_undo(self) -> bool:
        """Whether there is something before."""
        return self._at > 0

    @property
    def may_redo(self) -> bool:
        """Whether something was undone."""
        return self._at < len(self._states) - 1

    def change(self, state: SetupState) -> bool:
        """Take a change; what was undone before is forgotten. False: it is none."""
        if state == self.state:
            return False
        self._states = [*self._states[: self._at + 1], state]
        self._at += 1
        return True

    def undo(self) -> None:
        """Go back by a change."""
        self._at = max(self._at - 1, 0)

    def redo(self) -> None:
        """Take a change again that was undone."""
        self._at = min(self._at + 1, len(self._states) - 1)


def bare(plan: SetupPlan) -> SetupPlan:
    """The plan's cameras alone, to look at their images: how fast they come does not matter."""
    fps = plan.fps or _ANY_FPS
    return replace(plan, calibration=(), ground=None, region=EVERYWHERE, fps=fps)


def read_images(plan: SetupPlan, share: float) -> CameraImages:
    """Both cameras at one instant, a share (0 to 1) of the footage from its start; slow.

    Raises:
        RecordingError: they cannot be read.
    """
    plan = bare(plan)
    with open_recording(plan.folder, options_of_plan(plan)) as recording:
        number = round(share * (recording.frame_count - 1))
        partner = min(max(number + (plan.lag or 0), 0), recording.frame_count - 1)
        frame = recording.read(number, partner)
        return CameraImages(frame.left, frame.right, number, recording.frame_count)


def mark_of(step: Step, scene: SetupScene) -> tuple[Mark, str]:
    """How a step stands, and why, in a few words; a try that failed changes nothing of it."""
    state, plan, problem = scene.state, scene.state.plan, fault_of(step, scene)
    if plan is None:
        return Mark.OPEN, tr("not begun")
    if problem:
        return Mark.WARNING, tr("warning")
    if step is Step.CAMERAS:
        return _mark_of_cameras(state)
    if step is Step.CALIBRATION:
        if not plan.calibration:
            return Mark.OPEN, tr("no metres yet")
        if scene.misfit_px is not None:
            return Mark.WARNING, tr("does not fit")
        rough = scene.checked.calibration is not None and scene.checked.calibration.rough
        if rough or (plan.is_stereo and scene.checked.missing):
            return Mark.WARNING, tr("rough") if rough else tr("one camera")
        return Mark.DONE, tr("done")
    if step is Step.FLOOR:
        if plan.ground is None:
            return Mark.OPEN, tr("no metres yet")
        return (Mark.WARNING, tr("unsure")) if state.floor_doubt else (Mark.DONE, tr("done"))
    if step is Step.REGION:
        drawn = plan.region or state.occluders or state.lines
        return (Mark.DONE, tr("done")) if drawn else (Mark.OPEN, tr("whole image"))
    return Mark.OPEN, tr("not written")


def _mark_of_cameras(state: SetupState) -> tuple[Mark, str]:
    if state.doubts:
        return Mark.WARNING, tr("warning")
    return Mark.DONE, tr("done")


def still_told(
    problems: Mapping[Step, str], before: SetupState, after: SetupState
) -> dict[Step, str]:
    """What is left of failed tries once something else was entered.

    Those of the step that was changed, and of later ones, were about what is no more.
    """
    changed = next(
        (step for step in STEPS if _entered(step, before) != _entered(step, after)), None
    )
    if changed is None:
        return dict(problems)
    return {
        step: told for step, told in problems.items() if STEPS.index(step) < STEPS.index(changed)
    }


def _entered(step: Step, state: SetupState) -> tuple[object, ...]:
    """What was entered at a step."""
    plan = state.plan
    if step is Step.CAMERAS:
        cameras = (
            None
            if plan is None
            else replace(plan, calibration=(), ground=None, region=EVERYWHERE, name="")
        )
        return cameras, state.by_hand
    if plan is None:
        return ()
    if step is Step.CALIBRATION:
        made = (state.calibration_method, state.board, state.rough, state.left_out)
        return plan.calibration, *made
    if step is Step.FLOOR:
        marks = (state.points, state.distances, state.pose_file, state.convention)
        return plan.ground, state.floor_method, *marks
    if step is Step.REGION:
        return plan.region, state.occluders, state.lines
    return (plan.name,)


def problem_of(step: Step, scene: SetupScene) -> str:
    """What is told beside a step: why the last try failed, or its fault; "": nothing."""
    return scene.problems.get(step, "") or fault_of(step, scene)


def fault_of(step: Step, scene: SetupScene) -> str:
    """Why what counts at a step cannot be used, in words; "" where it can."""
    checked = scene.checked
    if checked.plan is not None and checked.plan == scene.state.plan and checked.step is step:
        return checked.problem
    return ""


def may_write(scene: SetupScene) -> bool:
    """Whether the plan can be written: it was opened as a trial, and nothing is wrong."""
    plan, checked = scene.state.plan, scene.checked
    return plan is not None and checked.plan == plan and not checked.problem and not scene.busy
