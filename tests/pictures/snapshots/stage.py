"""The window that snapshots are taken of, with what is open in it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

from PySide6.QtCore import QCoreApplication, QEvent
from PySide6.QtWidgets import QApplication, QDialog, QMenu, QWidget

from app.shell.application import show_document, wait_until
from app.shell.main_window import MainWindow
from app.shell.recording_controller import RecordingController
from tests.pictures.snapshots.material import MIDDLE, Material

WidgetT = TypeVar("WidgetT", bound=QWidget)
_PATIENCE_MS = 120_000
_SETTLE_MS = 60
_WORK_MS = 8_000


class Stage:
    """A window with a recording, a project or nothing open, and hands to use it with."""

    def __init__(self, window: MainWindow, material: Material) -> None:
        self.window, self.material = window, material

    @property
    def controller(self) -> RecordingController:
        """Of the open recording."""
        assert self.window.controller is not None
        return self.window.controller

    def run(self, command: str) -> None:
        """Do a command that can be done now."""
        self.window.bring_up_to_date()
        item = self.window.registry.item(command)
        assert item.enabled, f"{command}: {item}"
        self.window.run_command(command)

    def wait(self, ready: Callable[[], bool]) -> None:
        """Wait until something is so. Raises TimeoutError where it does not come to be."""
        if not wait_until(ready, _PATIENCE_MS):
            raise TimeoutError("waited in vain")

    def rest(self, ms: int = _SETTLE_MS) -> None:
        """Let the window come to rest."""
        wait_until(lambda: False, ms)
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)

    def settle(self) -> None:
        """Let the window come to rest, and what it works on end, unless that is what is shown."""
        wait_until(lambda: not self.window.work.jobs.running, _WORK_MS)
        self.rest()

    def seen(self, kind: type[WidgetT], name: str = "") -> WidgetT:
        """The newest widget of a kind that is seen, once there is one."""

        def found() -> list[WidgetT]:
            every = QApplication.allWidgets()
            own = [one for one in every if isinstance(one, kind) and one.isVisible()]
            return [one for one in own if not name or one.objectName() == name]

        self.wait(lambda: bool(found()))
        return found()[-1]

    def open_session(self, path: Path | None = None) -> None:
        """Show the session in the middle, somebody selected, nothing looked for any more."""
        self.window.files.close_without_asking()
        show_document(self.window, path or self.material.session, MIDDLE)
        controller = self.controller
        self.wait(lambda: not controller.reviewing.busy and not self.window.work.busy)
        if self.people():
            self.pick(0)
        self.window.notice.hide()
        self.rest()

    def open_project(self) -> None:
        """Show the project once all its recordings are read."""
        self.window.show()
        projects = self.window.files.projects
        projects.open(self.material.project)
        self.wait(lambda: projects.project.found is not None and not projects.project.found.wanted)
        self.window.project_page.table.choose("Camera 2")
        self.rest()

    def people(self) -> list[int]:
        """Who stands in the frame that is shown."""
        frame = self.controller.playback.number
        people: list[int] = self.controller.document.tracks.of_frame(frame)["track"].tolist()
        return people

    def pick(self, at: int) -> int:
        """Select somebody of the frame that is shown."""
        track = self.people()[at]
        self.controller.editing.pick(track)
        return track

    def go(self, frame: int) -> None:
        """Show another frame."""
        self.controller.playback.go(frame)
        self.wait(lambda: self.controller.playback.number == frame)

    def tidy(self) -> None:
        """Close what a snapshot left open."""
        for widget in QApplication.topLevelWidgets():
            if isinstance(widget, QMenu) and widget.isVisible():
                widget.close()
        for dialog in self.window.findChildren(QDialog):
            if dialog.isVisible():
                dialog.reject()
        self.window.palette_of_commands.hide()
        self.window.notice.hide()
        if self.window.controller is not None:
            if self.controller.document.flow is not None:
                self.controller.leave()
            if self.controller.playback.number != MIDDLE:
                self.go(MIDDLE)
            self.pick(0)
        self.rest()
