"""What is drawn in the pictures and on the floor: occluders, counting lines, regions."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QObject, Signal

from app.core.controller import Controller
from app.core.drawing.surfaces import Surfaces
from app.core.i18n import tr
from app.core.playback.playback import Playback
from app.core.scenes.labels import LINE_COLOUR, OCCLUDER_COLOUR, REGION_COLOUR, Tool
from app.features.labelling.presenter import LabellingPresenter
from app.features.labelling.shape_planner import (
    corners_of,
    places_of_shapes,
    plan_drawn,
    plan_renamed,
    plan_reshaped,
    plan_taken_away,
    shapes_of_tool,
)
from app.features.labelling.shapes import ShapesLayer
from tracking.editing import Change

Do = Callable[[Callable[[], Change]], bool]
"""Does what is planned; whether it was done."""

_COLOURS = {
    Tool.OCCLUDERS: OCCLUDER_COLOUR,
    Tool.LINES: LINE_COLOUR,
    Tool.REGIONS: REGION_COLOUR,
}


class Shapes(Controller):
    """Draws, reshapes, names and takes away what the tool at hand draws.

    `changed`: another one is picked. Signals: `leave_asked()`.

    Attributes:
        on_picture, on_floor: the layers it is drawn on.
    """

    leave_asked = Signal()

    def __init__(
        self,
        surfaces: Surfaces,
        playback: Playback,
        presenter: LabellingPresenter,
        do: Do,
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._playback, self._presenter, self._do = playback, presenter, do
        self.on_picture = ShapesLayer(surfaces.left)
        self.on_floor = ShapesLayer(surfaces.floor)
        self.on_picture.drawn.connect(self._add_in_picture)
        self.on_floor.drawn.connect(self._add)
        for layer in (self.on_picture, self.on_floor):
            layer.reshaped.connect(self._reshape)
            layer.picked.connect(self.pick)
            layer.removal_asked.connect(self._remove_picked)
            layer.leave_asked.connect(self.leave_asked)
        for view in (surfaces.left, surfaces.right):
            view.picture_clicked.connect(self._tell_where)

    @property
    def _tool(self) -> Tool | None:
        return self._presenter.choice.tool

    def draw(self) -> None:
        """Show on the layers what is drawn with the tool."""
        tool = self._tool
        if tool not in _COLOURS:
            return
        for layer in (self.on_picture, self.on_floor):
            there = layer is self.on_picture
            shapes = places_of_shapes(tool, self._presenter.labels, in_picture=there)
            layer.show_shapes(shapes, closed=tool is not Tool.LINES, colour=_COLOURS[tool])

    def _add_in_picture(self, corners: tuple[tuple[float, float], ...]) -> None:
        self._add(corners, in_picture=True)

    def _add(self, corners: tuple[tuple[float, float], ...], *, in_picture: bool = False) -> None:
        tool, frame = self._tool, self._playback.number
        if tool is None:
            return
        plan = partial(plan_drawn, corners=corners, frame=frame, in_picture=in_picture)
        if self._do(lambda: plan(tool, self._presenter.labels)):
            there = [corners_of(item) for item in shapes_of_tool(tool, self._presenter.labels)]
            self.pick(there.index(corners) if corners in there else -1)

    def _reshape(self, number: int, corners: tuple[tuple[float, float], ...]) -> None:
        self._change(partial(plan_reshaped, number=number, corners=corners))

    def rename(self, number: int, name: str) -> None:
        """Call one by another name."""
        self._change(partial(plan_renamed, number=number, name=name))

    def _remove_picked(self) -> None:
        self.remove(self._presenter.choice.picked)

    def remove(self, number: int) -> None:
        """Take one away."""
        if 0 <= number < len(shapes_of_tool(self._tool, self._presenter.labels)):
            self._presenter.choice.picked = -1
            self._change(partial(plan_taken_away, number=number))

    def pick(self, number: int) -> None:
        """Choose one of those that are drawn; -1: none."""
        if number != self._presenter.choice.picked:
            self._presenter.choice.picked = number
            self.changed.emit()

    def _tell_where(self) -> None:
        """A click in a view the tool does not draw on; on its own a layer lies above."""
        if self._tool is Tool.OCCLUDERS:
            self.said.emit(tr("Occluders are drawn in the left image"))
        elif self._tool is not None and self._tool.on_floor:
            self.said.emit(
                tr("Lines and regions are drawn in the overhead view, or in the left image")
            )

    def _change(self, plan: Callable[..., Change]) -> None:
        tool = self._tool
        if tool is not None:
            labels, frame = self._presenter.labels, self._playback.number
            self._do(lambda: plan(tool, labels, frame=frame))
