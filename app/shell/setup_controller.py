"""File > Set up a recording: cameras looked at, the form shown, recording.toml written."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog, QMessageBox

from app.core.controller import Controller
from app.core.error_messages import explain
from app.core.i18n import tr
from app.core.widgets.work import Work
from app.features.setup.dialog import SetupDialog
from app.features.setup.presenter import SetupScene, scene_of_paths
from tracking.errors import TrackwrightError
from tracking.recording import MANIFEST_NAME
from tracking.setup import SetupPlan, write_setup

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow


class SetupController(Controller):
    """Sets recordings up in a window."""

    def __init__(self, window: MainWindow, work: Work, parent: Controller) -> None:
        super().__init__(parent)
        self._window = window
        self._work = work
        self.dialog: SetupDialog | None = None

    def ask(self) -> None:
        """Ask for one or two videos."""
        last = self._window.remembered.last_folder("open")
        dialog = QFileDialog(self._window, tr("Videos of one camera, or of a pair"))
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.setFileMode(QFileDialog.FileMode.ExistingFiles)
        dialog.setDirectory(str(last.folder or last.remembered.recent_folder or Path.home()))
        dialog.filesSelected.connect(lambda names: self.begin([Path(name) for name in names]))
        dialog.open()

    def begin(self, paths: list[Path]) -> None:
        """Look at these files, or at a recording that is to be set up again."""
        title = tr("Looking at the cameras")
        self._work.run(title, lambda _: scene_of_paths(paths), self._show)

    def again(self) -> None:
        """Set the open recording up again."""
        controller = self._window.controller
        if controller is not None:
            self.begin([controller.document.recording.folder])

    def _show(self, scene: SetupScene) -> None:
        self.dialog = dialog = SetupDialog(scene, self._window.remembered, self._window)
        dialog.planned.connect(self._write)
        dialog.destroyed.connect(self._forget)
        dialog.open()

    def _forget(self) -> None:
        self.dialog = None

    def _write(self, plan: SetupPlan) -> None:
        if not (plan.folder / MANIFEST_NAME).exists():
            self._write_and_open(plan)
            return
        box = QMessageBox(self.dialog or self._window)
        box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        box.setIcon(QMessageBox.Icon.Question)
        box.setTextFormat(Qt.TextFormat.PlainText)
        box.setText(tr("Replace the recording.toml in {folder}?", folder=plan.folder.name))
        replace = box.addButton(tr("Replace"), QMessageBox.ButtonRole.AcceptRole)
        box.addButton(QMessageBox.StandardButton.Cancel)
        replace.clicked.connect(lambda: self._write_and_open(plan))
        box.open()

    def _write_and_open(self, plan: SetupPlan) -> None:
        try:
            path = write_setup(plan, replace_old=True)
        except TrackwrightError as error:
            self._window.notice.say(explain(error))
            return
        if self.dialog is not None:
            self.dialog.accept()
        self._window.files.open_path(path.parent)
