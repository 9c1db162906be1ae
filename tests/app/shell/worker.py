"""Somebody who works a day in the real window in one way: by keys, or by the mouse."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from person import NO_KEY, Person
from PySide6.QtCore import QPointF, Qt
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QApplication,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QTableWidget,
    QToolButton,
    QWidget,
)

from app.core.keymap import first_key
from tracking.session import Session

Columns = dict[str, bytes]
_FAR = 10
"""Pixels of a step with Shift."""
_CONTROLS = 60
"""Most presses of Tab until one gives up."""


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
        """Say which file or folder: paste its path, or click on it."""
        dialog = self.file_dialog()
        if self.keys:
            self.paste(str(path))
            self.press("Return")
            self._menu_closed()
            return
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
        """Select a person: walk to them by Tab, or click them on the floor or in the picture."""
        if self.keys:
            for _ in range(len(self.session.tracks.track_ids) + 1):
                if self.controller.document.selection.track == track:
                    return
                self.key_of("tracks.next")
        else:
            views, row = self.window.workspace, self.row(track, self.controller.playback.number)
            if views.overhead.isVisible():
                self.click(views.overhead, views.overhead.viewport.point(row["x"], row["y"]))
            else:
                middle = QPointF(row["left"] + row["width"] / 2, row["top"] + row["height"] / 2)
                self.click(views.left, views.left.viewport.point(middle.x(), middle.y()))
        assert self.controller.document.selection.track == track

    def draw(self, box: tuple[float, float, float, float]) -> None:
        """Draw a box of a new person; by keys the one that is proposed is moved there."""
        self.do("tracks.new")
        left, top, width, height = box
        if self.keys:
            proposed = self.controller.document.flow
            assert proposed is not None
            assert proposed.box is not None
            self._nudge(left - proposed.box[0], "Left", "Right")
            self._nudge(top - proposed.box[1], "Up", "Down")
            self.press("Return")
            return
        view = self.window.workspace.left
        point = view.viewport.point
        self.drag(view, point(left, top), point(left + width, top + height))
        if self.controller.document.flow is not None:
            self.apply()

    def _nudge(self, by: float, back: str, on: str) -> None:
        """Move the box that is shown by so many pixels, in large steps and then in small ones."""
        key = on if by > 0 else back
        far, near = divmod(round(abs(by)), _FAR)
        self.press(*[f"Shift+{key}"] * far, *[key] * near)

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

    def choose_option(self, number: int) -> None:
        """Say this option of the attribute that digit keys set."""
        if self.keys:
            self.press(str(number))
        else:
            self.choose(f"tracks.value{number}")

    # controls of dialogs

    def to(self, widget: QWidget, panel: QWidget | None = None) -> None:
        """Go to a control: by Tab, in a panel after its key; or by a click into it."""
        if not self.keys:
            self.click(widget)
        for _ in range(_CONTROLS):
            if widget.hasFocus():
                return
            focused = QApplication.focusWidget()
            inside = panel is None or (focused is not None and panel.isAncestorOf(focused))
            self.press("Tab" if inside else "F6")
        raise AssertionError(f"{widget} does not get the keyboard")

    def push(self, button: QAbstractButton, panel: QWidget | None = None) -> None:
        """Push a button."""
        assert button.isEnabled(), button.text()
        if self.keys:
            self.to(button, panel)
            self.press("Space")
        else:
            self.click(button)
        self._menu_closed()

    def fill(self, field: QWidget, text: str, panel: QWidget | None = None) -> None:
        """Type into a field, instead of what is in it."""
        self.to(field, panel)
        self.press("Ctrl+A")
        self.type(text)

    def choose_from(self, choice: QComboBox, row: int, panel: QWidget | None = None) -> None:
        """Choose an entry of a list that opens."""
        if self.keys:
            self.to(choice, panel)
            self.press("Home", *["Down"] * row)
        else:
            self.click(choice)
            shown = choice.view()
            self.wait(shown.isVisible)
            self.qtbot.wait(QApplication.doubleClickInterval())  # sooner it is the same click
            index = choice.model().index(row, choice.modelColumn())
            self.click(shown.viewport(), shown.visualRect(index).center())
            self._menu_closed()
        assert choice.currentIndex() == row

    def choose_rows(self, table: QTableWidget, first: int, last: int) -> None:
        """Select rows that follow each other in a table."""
        if self.keys:
            self.to(table)
            self.press("Ctrl+Home", *["Down"] * first, *["Shift+Down"] * (last - first))
            return
        for row in range(first, last + 1):
            place = table.visualItemRect(table.item(row, 0)).center()
            also = NO_KEY if row == first else Qt.KeyboardModifier.ControlModifier
            self.click(table.viewport(), place, modifiers=also)

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
