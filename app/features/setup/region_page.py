"""The step of the region: where people are looked for."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QGridLayout, QListWidget, QWidget

from app.core.i18n import tr
from app.features.setup import region_presenter
from app.features.setup.controller import SetupEditor
from app.features.setup.region_presenter import (
    fewest_corners,
    outlines_of,
    region_told,
    titles_of,
)
from app.features.setup.scene import OutlineKind, SetupPicture, SetupScene, ShownOutline, Step
from app.features.setup.step_page import StepPage, plain
from tracking.recording.region_of_interest import Outline

_ROWS_SEEN = 5


class RegionPage(StepPage):
    """Outlines drawn on the picture; corners are dragged, or moved with the arrow keys.

    Signals: picture_wanted(), keys are to go to the picture.
    """

    step = Step.REGION
    picture_wanted = Signal()

    def __init__(self, editor: SetupEditor, parent: QWidget) -> None:
        said = tr(
            "Draw where people are looked for, what is left out, what hides people, and lines to "
            "count at. All of it can stay open."
        )
        super().__init__(editor, tr("Region"), said, parent)
        self._kind: OutlineKind = "look"
        self._drawn: Outline | None = None
        self._chosen, self._corner = -1, -1
        self.rows.addLayout(self._buttons())
        self.how = plain("", self, "")
        self.rows.addWidget(self.how)
        self.list = QListWidget(self.widget())
        self.list.setAccessibleName(tr("Outlines"))
        self.list.setFixedHeight(_ROWS_SEEN * (self.list.fontMetrics().height() + 12))
        self.list.currentRowChanged.connect(self._choose_row)
        self.rows.addWidget(self.list)
        self.remove = self.button(tr("Delete"), self._delete_outline, tr("Delete what is chosen"))
        self.rows.addWidget(self.remove, 0, Qt.AlignmentFlag.AlignLeft)
        self.told = plain("", self)
        self.rows.addWidget(self.problem)
        self.rows.addWidget(self.told)
        self.kept = plain("", self)
        self.rows.addWidget(self.kept)
        self.rows.addStretch(1)

    def _buttons(self) -> QGridLayout:
        """What can be drawn."""
        self.look_here = self.button(tr("Look only here"), lambda: self._begin("look"))
        self.leave_out = self.button(tr("Leave this out"), lambda: self._begin("mask"))
        self.occluder = self.button(tr("Occluder"), lambda: self._begin("occluder"))
        self.line = self.button(tr("Counting line"), lambda: self._begin("line"))
        self.look_here.setToolTip(
            tr("People are seen as far as they are within: draw it around their heads, too.")
        )
        self.leave_out.setToolTip(tr("A clock, a screen, a mirror: nobody is looked for there."))
        self.occluder.setToolTip(tr("A pillar, a desk: people pass behind it."))
        self.line.setToolTip(tr("Passages over it are counted, both ways."))
        grid = QGridLayout()
        for number, button in enumerate((self.look_here, self.leave_out, self.occluder, self.line)):
            grid.addWidget(button, number // 2, number % 2)
        return grid

    def fill(self, scene: SetupScene) -> None:
        """The outlines."""
        outlines = outlines_of(scene.state)
        if self._chosen >= len(outlines):
            self._chosen, self._corner = -1, -1
        titles = titles_of(scene.state)
        if [self.list.item(row).text() for row in range(self.list.count())] != titles:
            self.list.clear()
            self.list.addItems(titles)
        self.list.setCurrentRow(self._chosen)
        ready = scene.images is not None
        for button in (self.look_here, self.leave_out, self.occluder, self.line):
            button.setEnabled(ready)
        self.remove.setEnabled(self._chosen >= 0)
        self.told.setText(region_told(scene))
        self.kept.setText(region_presenter.kept_told(scene.state))
        self._tell_how()

    def picture(self, scene: SetupScene) -> SetupPicture:
        """The outlines on the left image."""
        state = scene.state
        handle = region_presenter.handle_of_corner(state, self._chosen, max(self._corner, 0))
        drawn = None
        if self._drawn:
            drawn = ShownOutline(np.array(self._drawn), self._kind, True, closed=False)
        if self._drawn is not None or self._corner < 0:
            handle = -1
        return region_presenter.region_picture(scene, self._chosen, handle, drawn, self.pointer)

    def _tell_how(self) -> None:
        if self._drawn is None:
            said = tr("Drag corners; arrow keys move the chosen one, Page Down takes the next.")
        elif self._kind == "line":
            said = tr("Click both ends of the line. Enter makes a line in the middle.")
        elif self._drawn:
            said = tr("Click the corners. Enter or the first corner ends it, Escape gives it up.")
        else:
            said = tr("Click the corners. Enter makes a rectangle in the middle.")
        self.how.setText(said)

    # gestures

    def _begin(self, kind: OutlineKind) -> None:
        self._kind, self._drawn = kind, ()
        self._chosen, self._corner = -1, -1
        self._redraw()
        self.picture_wanted.emit()

    def click(self, x: float, y: float) -> None:
        """One more corner of what is drawn, else the outline there is chosen."""
        if self._drawn is not None:
            self._drawn = (*self._drawn, (x, y))
            if self._kind == "line" and len(self._drawn) == fewest_corners("line"):
                self.end()
            else:
                self._redraw()
            return
        self._chosen, self._corner = self._outline_at(x, y), -1
        self._redraw()

    def choose_handle(self, number: int) -> None:
        """A corner is chosen; the first one of what is drawn ends it."""
        row, corner = region_presenter.corner_of_handle(self.editor.state, number)
        if self._drawn is not None and row < 0:
            self.end()
            return
        self._chosen, self._corner = row, corner
        self._redraw()

    def move_handle(self, number: int, x: float, y: float) -> None:
        """A corner is elsewhere."""
        state = self.editor.state
        row, corner = region_presenter.corner_of_handle(state, number)
        if row < 0:
            return
        self._chosen, self._corner = row, corner
        self.editor.change(region_presenter.with_corner(state, row, corner, x, y))

    def end(self) -> None:
        """What is drawn is an outline; with no corner yet, a rectangle in the middle is."""
        drawn, images = self._drawn, self.editor.scene.images
        if drawn is None or images is None:
            return
        if not drawn:
            size = images.left.shape[1], images.left.shape[0]
            drawn = region_presenter.middle_outline(self._kind, size)
        if len(drawn) < fewest_corners(self._kind):
            told = tr("An outline has three corners or more: click further.")
            if self._kind == "line":
                told = tr("A line has two ends: click the other one.")
            self.editor.tell(self.step, told)
            return
        self._drawn = None
        self.editor.tell(self.step, "")
        state = region_presenter.with_outline(self.editor.state, self._kind, drawn)
        self._chosen = region_presenter.number_of_last(state, self._kind)
        self._corner = 0
        self.editor.change(state)

    def leave(self) -> None:
        """What has corners enough is an outline, though nobody ended it."""
        if self._drawn is not None and len(self._drawn) >= fewest_corners(self._kind):
            self.end()

    def give_up(self) -> None:
        """Nothing is drawn any more."""
        self._drawn = None
        self.editor.tell(self.step, "")
        self._redraw()

    def delete(self) -> None:
        """Take the last corner of what is drawn, the chosen corner, or the outline, away."""
        if self._drawn:
            self._drawn = self._drawn[:-1]
            self._redraw()
        elif self._chosen >= 0 and self._corner >= 0:
            state = self.editor.state
            corner, self._corner = self._corner, -1
            self.editor.change(region_presenter.without_corner(state, self._chosen, corner))
        else:
            self._delete_outline()

    def _delete_outline(self) -> None:
        row, self._chosen, self._corner = self._chosen, -1, -1
        self.editor.change(region_presenter.without_outline(self.editor.state, row))

    def _choose_row(self, row: int) -> None:
        if not self._filling and row != self._chosen:
            self._chosen, self._corner = row, 0
            self._redraw()

    def _outline_at(self, x: float, y: float) -> int:
        return region_presenter.outline_at(self.editor.state, x, y)

    def _redraw(self) -> None:
        self.show_scene(self.editor.scene)
        self.redrawn.emit()
