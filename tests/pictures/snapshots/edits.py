"""Every edit as it waits for Enter: its panel, and for some the window with its preview."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from PySide6.QtWidgets import QWidget

from app.core.editing import edits
from app.core.editing.edit_spec import EditSpec
from app.features.correction.panel import EditPanel
from tests.pictures.snapshots.snapshot import On, snapshot
from tests.pictures.snapshots.stage import Stage

EDITS = "edits"
_IN_THE_WINDOW = (edits.SWAP, edits.MERGE, edits.DELETE, edits.MOVE, edits.FLOOR)
_SECOND, _WITH_A_GAP = 1, 2
_OF = {edits.KEYFRAME: _SECOND, edits.THIN: _SECOND, edits.FILL: _WITH_A_GAP}
"""Who of the people is edited where it is not the first, who has keyframes."""


def covers(spec: EditSpec) -> str:
    """How the snapshot of an edit says what it is of."""
    return f"edit:{spec.name}"


def _begin(spec: EditSpec, stage: Stage) -> None:
    editing = stage.controller.editing
    stage.pick(_OF.get(spec, 0))
    if spec is edits.DRAW:
        editing.begin_drawing()
    else:
        editing.begin(spec)
    if spec.of_two:
        editing.pick_next(1)
    if spec.places:
        editing.nudge(1, 0, far=True)
    stage.rest(250)


def _panel(spec: EditSpec, stage: Stage) -> Iterator[QWidget]:
    _begin(spec, stage)
    yield stage.window.workspace.preview


def _window(spec: EditSpec, stage: Stage) -> Iterator[QWidget]:
    _begin(spec, stage)
    yield stage.window


for _spec in edits.EDITS:
    snapshot(EDITS, On.SESSION, EditPanel, covers(_spec), name=_spec.name)(partial(_panel, _spec))
for _spec in _IN_THE_WINDOW:
    snapshot(EDITS, On.SESSION, EditPanel, name=f"{_spec.name} in the window")(
        partial(_window, _spec)
    )


@snapshot(EDITS, On.SESSION, EditPanel)
def swap_without_the_other_one(stage: Stage) -> Iterator[QWidget]:
    """It says whom it waits for."""
    stage.controller.editing.begin(edits.SWAP)
    yield stage.window.workspace.preview
