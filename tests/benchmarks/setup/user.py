"""A user who sets a recording up with mouse and keys alone, whose actions are counted."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from pathlib import Path

from PySide6.QtCore import QEvent, QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent, QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractSpinBox, QApplication, QComboBox, QLineEdit, QWidget

from app.features.setup.dialog import SetupDialog
from app.shell.main_window import MainWindow

Wait = Callable[[Callable[[], bool]], object]
_LEFT = Qt.MouseButton.LeftButton
_PLAIN = Qt.KeyboardModifier.NoModifier


class SetupUser:
    """Presses, types and drops.

    A click, a drop, a field typed into, a key are an action each; a choice from a list is two.

    Attributes: actions: so far. doubt: what was said of a floor that is not sure, or not found.
    """

    def __init__(self, window: MainWindow, wait: Wait) -> None:
        self.window = window
        self._wait = wait
        self.actions = 0
        self.doubt = ""
        self._began_s = time.monotonic()

    @property
    def seconds(self) -> float:
        """Since the start."""
        return time.monotonic() - self._began_s

    @property
    def dialog(self) -> SetupDialog:
        """The set-up's window."""
        dialog = self.window.files.setup.dialog
        assert dialog is not None, "the set-up is open"
        return dialog

    def wait(self, ready: Callable[[], bool]) -> None:
        """Wait as a person does, seeing that something goes on."""
        self._wait(ready)

    def wait_for_rest(self) -> None:
        """Wait until the set-up has nothing at work."""
        self._wait(lambda: not self.dialog.editor.busy and not self.dialog.calibration.busy)

    def drop(self, paths: Sequence[Path], on: QWidget | None = None) -> None:
        """Drop files on the window."""
        self.actions += 1
        data = QMimeData()
        data.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
        target = on or self.window.welcome
        middle = target.rect().center()
        copy = Qt.DropAction.CopyAction
        enter = QDragEnterEvent(middle, copy, data, _LEFT, _PLAIN)
        QApplication.sendEvent(target, enter)
        drop = QDropEvent(QPointF(middle), copy, data, _LEFT, _PLAIN)
        QApplication.sendEvent(target, drop)

    def press(self, button: QWidget) -> None:
        """Click a button that can be pressed."""
        _check(button)
        self.actions += 1
        QTest.mouseClick(button, _LEFT)

    def type(self, field: QAbstractSpinBox | QLineEdit, text: str) -> None:
        """Type into a field in place of what it says, and press Enter."""
        _check(field)
        self.actions += 1
        field.setFocus()
        field.selectAll()
        QTest.keyClicks(field, text)
        QTest.keyClick(field, Qt.Key.Key_Return)

    def choose(self, box: QComboBox, value: str) -> None:
        """Choose from a list by arrow keys."""
        _check(box)
        self.actions += 2
        box.setFocus()
        wanted = box.findData(value)
        for _ in range(box.count()):
            step = wanted - box.currentIndex()
            if step:
                QTest.keyClick(box, Qt.Key.Key_Down if step > 0 else Qt.Key.Key_Up)
        assert box.currentData() == value, f"{value} is not in the list"

    def click_image(self, x: float, y: float) -> None:
        """Click a pixel of the image."""
        self.actions += 1
        QTest.mouseClick(self.dialog.picture, _LEFT, pos=self._at(x, y))

    def drag_image(self, begin: tuple[float, float], end: tuple[float, float]) -> None:
        """Drag from one pixel of the image to another."""
        self.actions += 1
        view = self.dialog.picture
        QTest.mousePress(view, _LEFT, pos=self._at(*begin))
        middle = self._at((begin[0] + end[0]) / 2, (begin[1] + end[1]) / 2)
        QTest.mouseMove(view, middle)
        QTest.mouseMove(view, self._at(*end))
        QTest.mouseRelease(view, _LEFT, pos=self._at(*end))

    def hover_image(self, x: float, y: float) -> None:
        """Move the mouse over a pixel of the image: no action."""
        view, at = self.dialog.picture, self._at(x, y)
        moved = QMouseEvent(
            QEvent.Type.MouseMove,
            QPointF(at),
            QPointF(view.mapToGlobal(at)),
            Qt.MouseButton.NoButton,
            Qt.MouseButton.NoButton,
            _PLAIN,
        )
        QApplication.sendEvent(view, moved)

    def key(self, widget: QWidget, key: Qt.Key, modifiers: Qt.KeyboardModifier = _PLAIN) -> None:
        """Press a key."""
        self.actions += 1
        QTest.keyClick(widget, key, modifiers)

    def _at(self, x: float, y: float) -> QPoint:
        return self.dialog.picture.place_of(x, y).toPoint()


def _check(widget: QWidget) -> None:
    assert widget.isVisible(), f"{widget.accessibleName()} is not there"
    assert widget.isEnabled(), f"{widget.accessibleName()} cannot be used now"


def set_up_with_file(user: SetupUser, paths: Sequence[Path]) -> None:
    """Videos whose calibration lies beside them: the floor measured, written and tracked."""
    user.drop(paths)
    if len(paths) == 1 and paths[0].is_file():  # one video is opened at once
        setup = user.window.workspace.setup
        user.wait(lambda: user.window.controller is not None and setup.isVisible())
        user.press(setup)
        user.wait_for_rest()
    else:
        user.wait(lambda: user.window.files.setup.dialog is not None)
        user.wait_for_rest()
        user.press(user.dialog.next)
        user.press(user.dialog.next)
    measure_write_and_track(user)


def set_up_roughly(
    user: SetupUser, paths: Sequence[Path], fov_deg: float, baseline_mm: float
) -> None:
    """Two bare videos: a rough calibration, the floor measured, written and tracked."""
    user.drop(paths)
    user.wait(lambda: user.window.files.setup.dialog is not None)
    user.wait_for_rest()
    dialog = user.dialog
    user.press(dialog.next)
    user.choose(dialog.calibration.method, "rough")
    user.type(dialog.calibration.rough.fov, f"{fov_deg:.1f}")
    user.type(dialog.calibration.rough.baseline, f"{baseline_mm / 1000:.4f}")
    user.press(dialog.calibration.rough.calibrate)
    user.wait_for_rest()
    user.press(dialog.next)
    measure_write_and_track(user)


def measure_write_and_track(user: SetupUser) -> None:
    """From the step of the floor to a tracker at work."""
    dialog, window = user.dialog, user.window
    user.wait_for_rest()
    user.press(dialog.floor.measure)
    user.wait_for_rest()
    user.doubt = dialog.floor.doubt.text() or dialog.floor.problem.text()
    user.press(dialog.next)
    user.press(dialog.next)
    user.wait_for_rest()
    user.press(dialog.write.write)
    user.wait(
        lambda: window.controller is not None and window.controller.playback.frame is not None
    )
    window.activateWindow()
    user.wait(window.isActiveWindow)
    user.wait(lambda: not window.work.busy)
    user.key(window.focusWidget() or window, Qt.Key.Key_Space)
