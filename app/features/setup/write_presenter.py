"""The last step: what is still open before recording.toml is written."""

from __future__ import annotations

from app.core.i18n import tr
from app.features.setup.presenter import STEPS, fault_of, mark_of, step_title
from app.features.setup.scene import Mark, SetupScene, Step
from tracking.errors import TrackwrightError
from tracking.setup import SetupPlan


def remarks(scene: SetupScene) -> tuple[str, ...]:
    """What is open, or to be warned of, a line for each step."""
    lines = []
    for step in STEPS:
        mark, why = mark_of(step, scene)
        told = fault_of(step, scene)
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
