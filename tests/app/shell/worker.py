"""Somebody who works a day in the real window in one way: by keys, or by the mouse."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from person import Person
from PySide6.QtCore import QPointF
from PySide6.QtWidgets import (
    QAbstractItemView,
    QApplication,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QToolButton,
)

from app.core.keymap import first_key
from tracking.session import Session

Columns = dict[str, bytes]
_NUDGES = 8


@dataclass(frozen=True, slots=True)
class Worker(Person):
    """Does each thing in the way of this worker, and looks at what the session says.

    Attributes:
        keys: by keys, else by the mouse.
    """

    keys: bool = True

    def do(self, command: str) -> None:
        """Run a command: by its key or by the search, or from the menus."""
        if self.keys and first_key(command):
            self.key_of(command)
        elif self.keys:
            self.search(command)
        else:
            self.choose(command)

    # files

    def open(self, path: Path) -> None:
        """Open a file and wait for its first frame."""
        self.do("file.open")
        self.answer_file(path)
        self.wait(
            lambda: (
                self.window.controller is not None
                and self.window.controller.playback.frame is not None
            )
        )
        self._menu_closed()

    def save_as_proposed(self) -> Path:
        """Save where the program proposes; the place."""
        self.do("file.save")
        dialog = self.file_dialog()
        path = Path(dialog.selectedFiles()[0])
        self.accept(dialog)
        self.wait(lambda: not self.window.work.busy and not self.window.files.saving.unsaved)
        self._menu_closed()
        return path

    def answer_file(self, path: Path) -> None:
        """Click on a file where one is asked for: the dialog is Qt's, or the desktop's."""
        dialog = self.file_dialog()
        views = [dialog.findChild(QAbstractItemView, name) for name in ("listView", "treeView")]
        listed = next(one for one in views if one is not None and one.isVisible())
        self.wait(lambda: path.name in _names(listed))
        row = _names(listed).index(path.name)
        index = listed.model().index(row, 0, listed.rootIndex())
        self.click(listed.viewport(), listed.visualRect(index).center())
        self.accept(dialog)

    def file_dialog(self) -> QFileDialog:
        """The dialog that asks for a file."""
        self.wait(lambda: isinstance(QApplication.activeModalWidget(), QFileDialog))
        dialog = QApplication.activeModalWidget()
        assert isinstance(dialog, QFileDialog)
        return dialog

    # where and who

    def toggle_play(self) -> None:
        """Play or pause."""
        if self.keys:
            self.key_of("play.toggle")
        else:
            self.click(self.window.workspace.transport._play)

    def go(self, frame: int) -> None:
        """Go to a frame: type its number, or click on the overview."""
        if self.keys:
            self.key_of("play.goto")
            self.type(str(frame))
            self.press("Return")
        else:
            strip = self.window.workspace.timeline.overview
            x = strip._axis().x_of(frame + 0.5)
            self.click(strip, QPointF(x, strip.height() / 2))
        self.wait(lambda: self.controller.playback.number == frame)

    def select(self, track: int) -> None:
        """Select a person: walk to them by Tab, or click them on the floor."""
        if self.keys:
            for _ in range(len(self.session.tracks.track_ids) + 1):
                if self.controller.document.selection.track == track:
                    return
                self.key_of("tracks.next")
        else:
            view = self.window.workspace.overhead
            row = self.row(track, self.controller.playback.number)
            self.click(view, view.viewport.point(row["x"], row["y"]))
        assert self.controller.document.selection.track == track

    def draw(self, box: tuple[float, float, float, float]) -> None:
        """Draw a box of a new person; by keys where the program proposes it, then nudged."""
        if self.keys:
            self.key_of("tracks.new")
            self.press(*(["Right"] * _NUDGES), "Return")
            return
        view = self.window.workspace.left
        self.do("tracks.new")
        left, top, width, height = box
        point = view.viewport.point
        self.drag(view, point(left, top), point(left + width, top + height))
        if self.controller.document.flow is not None:
            self.apply()

    def apply(self) -> None:
        """Apply the edit that is shown."""
        if self.keys:
            self.key_of("tracks.confirm")
        else:
            self.click(self.window.workspace.preview._confirm)

    def pick_other(self, other: int) -> None:
        """Say who the second person of an edit is: by their id, or by the chip with it."""
        if self.keys:
            self.type(str(other))
            self.press("Return")
            return
        chips = self.window.workspace.preview.findChildren(QToolButton)
        self.click(next(one for one in chips if one.text() == str(other) and one.isVisible()))

    def accept(self, dialog: QDialog) -> None:
        """End a dialog with what it is for: by Enter, or by its button."""
        self.wait(dialog.isVisible)
        if self.keys:
            self.press("Return")
            return
        box = dialog.findChild(QDialogButtonBox)
        assert box is not None
        accepts = QDialogButtonBox.ButtonRole.AcceptRole
        self.click(next(one for one in box.buttons() if box.buttonRole(one) == accepts))

    # what the session says

    @property
    def session(self) -> Session:
        """The one that is open."""
        session = self.controller.document.session
        assert session is not None
        return session

    def columns(self) -> Columns:
        """All rows of the corrected tracks."""
        return {name: column.tobytes() for name, column in self.session.tracks.columns().items()}

    def row(self, track: int, frame: int) -> dict[str, float]:
        """A row of the corrected tracks."""
        rows = self.session.tracks.of_track(track, frame, frame + 1)
        return {name: column[0].item() for name, column in rows.items() if len(column)}

    def people(self, frame: int) -> list[int]:
        """Who stands in a frame, those first who stand apart from the others."""
        rows = self.session.tracks.of_frame(frame)
        places = np.column_stack((rows["x"], rows["y"]))
        apart = np.linalg.norm(places[:, None] - places, axis=2) + 99 * np.eye(len(places))
        order = np.argsort(-apart.min(axis=1), kind="stable")
        found: list[int] = rows["track"][order].tolist()
        return found

    def kinds(self) -> list[str]:
        """What was done, oldest first."""
        return [entry.kind for entry in self.session.history]


def _names(view: QAbstractItemView) -> list[str]:
    model, root = view.model(), view.rootIndex()
    return [str(model.index(row, 0, root).data()) for row in range(model.rowCount(root))]
