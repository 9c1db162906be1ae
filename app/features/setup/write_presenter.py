"""The last step: the recording.toml that will be written, and what is still open."""

from __future__ import annotations

from app.core.error_messages import explain
from app.core.i18n import tr
from app.features.setup.presenter import STEPS, mark_of, problem_of, step_title
from app.features.setup.scene import Mark, SetupScene, Step
from tracking.errors import TrackwrightError
from tracking.recording import MANIFEST_NAME
from tracking.setup import SetupPlan
from tracking.setup.plan import setup_text


def text_to_write(scene: SetupScene) -> str:
    """recording.toml as it will be; why there is none yet."""
    plan = scene.state.plan
    if plan is None:
        return tr("# Choose the cameras first.")
    try:
        return setup_text(plan)
    except TrackwrightError as error:
        return f"# {explain(error)}"


def places_told(scene: SetupScene) -> str:
    """Which files will be written."""
    plan = scene.state.plan
    if plan is None:
        return ""
    try:
        path, copied = plan.folder / MANIFEST_NAME, plan.calibration_file
    except TrackwrightError as error:
        return explain(error)
    if copied is None:
        return tr("Will be written: {path}", path=path)
    return tr("Will be written: {path}, and {name} beside it", path=path, name=copied.name)


def remarks(scene: SetupScene) -> tuple[str, ...]:
    """What is open, or to be warned of, a line for each step."""
    lines = []
    for step in STEPS:
        mark, why = mark_of(step, scene)
        told = problem_of(step, scene)
        if told:
            lines.append(tr("{step}: {told}", step=step_title(step), told=told))
        elif mark is Mark.WARNING or (mark is Mark.OPEN and step in _NEEDED_FOR_METRES):
            lines.append(tr("{step}: {told}", step=step_title(step), told=why))
    return tuple(lines)


_NEEDED_FOR_METRES = (Step.CALIBRATION, Step.FLOOR)


def default_name(plan: SetupPlan) -> str:
    """The name that a recording has where none is entered: its folder's."""
    try:
        return plan.folder.absolute().name
    except TrackwrightError:
        return ""
