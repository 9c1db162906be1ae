"""The real window on a crowded frame of the tiny session, with keys and mouse at hand."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QAction, QContextMenuEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu, QWidget
from pytestqt.qtbot import QtBot

from app.shell.main_window import MainWindow
from app.shell.recording_controller import RecordingController

CROWDED = 60
NO_KEY = Qt.KeyboardModifier.NoModifier
CTRL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier
LEFT = Qt.MouseButton.LeftButton


def open_for_correcting(
    window: MainWindow, qtbot: QtBot, path: Path, frame: int = CROWDED
) -> RecordingController:
    """The controller once the frame is shown in both cameras and the window has the keyboard."""
    window.files.open_path(path)
    qtbot.waitUntil(
        lambda: window.controller is not None and window.controller.playback.frame is not None
    )
    with qtbot.waitActive(window):
        window.activateWindow()
    controller = window.controller
    assert controller is not None
    controller.playback.go(frame)
    qtbot.waitUntil(lambda: controller.playback.number == frame)
    return controller


def offered(menu: QMenu) -> list[QAction]:
    """The actions of a menu and of the menus in it."""
    found: list[QAction] = []
    for action in menu.actions():
        inner = action.menu()
        found += offered(inner) if isinstance(inner, QMenu) else [action]
    return found


@dataclass(frozen=True, slots=True)
class Hands:
    """Whoever sits before the window: presses keys, clicks, drags; looks at the session's rows."""

    window: MainWindow
    controller: RecordingController
    qtbot: QtBot

    def press(self, key: Qt.Key, modifiers: Qt.KeyboardModifier = NO_KEY) -> None:
        """Press a key where the keyboard is."""
        QTest.keyClick(self.window.focusWidget() or self.window, key, modifiers)
        self.qtbot.wait(1)

    def type(self, text: str) -> None:
        """Type where the keyboard is."""
        QTest.keyClicks(self.window.focusWidget() or self.window, text)
        self.qtbot.wait(1)

    def go(self, frame: int) -> None:
        """Go to a frame and wait until it is seen."""
        self.controller.playback.go(frame)
        self.qtbot.waitUntil(lambda: self.controller.playback.number == frame)

    def click(self, widget: QWidget, at: QPointF, modifiers: Qt.KeyboardModifier = NO_KEY) -> None:
        """Click at a place of a widget."""
        QTest.mouseClick(widget, LEFT, modifiers, at.toPoint())
        self.qtbot.wait(1)

    def drag(self, widget: QWidget, start: QPointF, end: QPointF, drop: bool = True) -> None:
        """Drag over a widget in a few steps."""
        QTest.mousePress(widget, LEFT, NO_KEY, start.toPoint())
        for step in range(1, 6):
            QTest.mouseMove(widget, (start + (end - start) * step / 5).toPoint())
            self.qtbot.wait(1)
        if drop:
            QTest.mouseRelease(widget, LEFT, NO_KEY, end.toPoint())
            self.qtbot.wait(1)

    def choose_in_menu(
        self, widget: QWidget, at: QPointF, command: str, by_key: bool = False
    ) -> None:
        """Open the menu of a right click, or of the menu key, and choose a command in it."""
        place, reasons = at.toPoint(), QContextMenuEvent.Reason
        reason = reasons.Keyboard if by_key else reasons.Mouse
        asked = QContextMenuEvent(reason, place, widget.mapToGlobal(place))
        QApplication.sendEvent(widget, asked)
        menu = self.window.context_menu.menu
        assert isinstance(menu, QMenu)
        action = self.window.menus.actions[command]
        assert action in offered(menu)
        menu.close()
        action.trigger()
        self.qtbot.wait(1)

    # what there is

    def row(self, track: int, frame: int) -> dict[str, Any]:
        """A row of the session's corrected table; empty where there is none."""
        table = self.controller.document.session.tracks
        rows = table.of_track(track, frame, frame + 1)
        return {name: column[0].item() for name, column in rows.items() if len(column)}

    def people(self, frame: int = CROWDED) -> list[int]:
        """Who stands in a frame."""
        ids: list[int] = self.controller.document.session.tracks.of_frame(frame)["track"].tolist()
        return ids

    def frames(self, track: int) -> list[int]:
        """Where a track stands."""
        found: list[int] = self.controller.document.session.tracks.frames_of_track(track).tolist()
        return found

    def apart(self) -> int:
        """Somebody in the crowded frame whom nobody stands close to."""
        rows = self.controller.document.tracks.of_frame(CROWDED)
        places = np.column_stack((rows["x"], rows["y"]))
        apart = np.linalg.norm(places[:, None] - places, axis=2) + 99 * np.eye(len(places))
        return int(rows["track"][int(apart.min(axis=1).argmax())])

    def box_on(self, track: int, frame: int = CROWDED) -> QRectF:
        """A person's box in the widget of the left camera."""
        row = self.row(track, frame)
        box = QRectF(*(row[name] for name in ("left", "top", "width", "height")))
        return self.window.workspace.left.viewport.rect(box)

    def place_on(self, track: int, frame: int = CROWDED) -> QPointF:
        """Where a person is drawn in the overhead view."""
        row = self.row(track, frame)
        return self.window.workspace.overhead.viewport.point(row["x"], row["y"])

    def lane_of(self, track: int) -> QPointF:
        """A point of the track's lane beside its bar."""
        area = self.window.workspace.timeline.area
        for y in range(0, area.height(), 4):
            lane = area.lane_at(QPointF(30, y))
            if lane is not None and lane.track == track:
                return QPointF(30, y + 2)
        raise AssertionError(f"no lane of {track}")
