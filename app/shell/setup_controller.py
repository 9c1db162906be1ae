"""File > Set up a recording: the set-up's window, and recording.toml written."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QMessageBox

from app.core.controller import Controller
from app.core.error_messages import explain
from app.core.i18n import tr
from app.core.widgets.work import Work
from app.features.setup.cameras_presenter import state_of_plan
from app.features.setup.dialog import SetupDialog
from app.features.setup.drafts import Drafts
from app.features.setup.drawn_labels import check_drawn, keep_drawn, with_labels
from app.features.setup.scene import SetupState, Step
from tracking.errors import TrackwrightError
from tracking.recording import Recording
from tracking.setup import SetupPlan, write_setup
from tracking.setup.plan import plan_from_manifest, plan_of

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
        """Show the first step, which asks for files, or to go on with what was interrupted."""
        self._show(None)

    def begin(self, paths: list[Path]) -> None:
        """Set up these files, or a recording again."""
        self._show(None).editor.take_paths(paths)

    def again(self) -> None:
        """Set the open recording up again."""
        controller = self._window.controller
        if controller is None:
            return
        recording = controller.document.recording
        folder, own = recording.folder, recording.own_manifest
        try:
            plan = plan_of(folder) if own else _plan_of_opened(recording)
        except TrackwrightError as error:
            self._window.notice.say(explain(error))
            return
        draft, session = Drafts().find(plan), controller.document.session
        state = state_of_plan(plan)
        if session is not None:
            state = with_labels(state, session.labels, recording.view)
        self._show(draft or state).editor.resumed = draft is not None

    def metres(self) -> None:
        """Set it up again at the first step that metres need; other files where none is open."""
        if self._window.controller is None:
            self.ask()
            return
        self.again()
        if self.dialog is not None:
            self.dialog.go_to_first_open()

    def _show(self, state: SetupState | None) -> SetupDialog:
        if self.dialog is not None:
            self.dialog.reject()
        self.dialog = dialog = SetupDialog(self._window.remembered, self._window, state)
        dialog.planned.connect(self._write)
        dialog.finished.connect(self._forget)
        dialog.open()
        return dialog

    def _forget(self) -> None:
        self.dialog = None

    def _write(self, plan: SetupPlan) -> None:
        if self.dialog is None or not self.dialog.editor.scene.checked.replaces:
            self._write_and_open(plan, replace_old=False)
            return
        box = QMessageBox(self.dialog or self._window)
        box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        box.setIcon(QMessageBox.Icon.Question)
        box.setTextFormat(Qt.TextFormat.PlainText)
        box.setText(tr("Replace the recording.toml in {folder}?", folder=plan.folder.name))
        replacing = box.addButton(tr("Replace"), QMessageBox.ButtonRole.AcceptRole)
        box.addButton(QMessageBox.StandardButton.Cancel)
        replacing.clicked.connect(lambda: self._write_and_open(plan, replace_old=True))
        box.open()

    def _write_and_open(self, plan: SetupPlan, *, replace_old: bool) -> None:
        """Write beside the window's thread; what fails is told at the last step.

        What becomes of unsaved work on what is open is asked first: after Cancel nothing is
        written, and the set-up goes on.
        """
        dialog = self.dialog
        if dialog is None:
            return
        again = partial(self._write_and_open, plan, replace_old=replace_old)
        if not self._window.files.may_leave(again, partial(self._tell_unwritten, dialog)):
            return

        def done(path: Path) -> None:
            dialog.finish()
            self._window.remembered.add_recent(plan.folder.resolve(), plan.name or plan.folder.name)
            self._window.files.open_path(path)

        work = partial(_written, plan, dialog.editor.state, replace_old)
        dialog.editor.run(Step.WRITE, tr("Writing"), lambda _: work(), done)

    def _tell_unwritten(self, dialog: SetupDialog) -> None:
        """Say at the last step that the set-up is as it was."""
        controller = self._window.controller
        if controller is None or dialog is not self.dialog:
            return
        told = tr(
            "Nothing is written yet, as {name} stays open. All that you entered is still here; "
            "Write and open asks again.",
            name=controller.document.recording.name,
        )
        dialog.editor.tell(Step.WRITE, told)


def _plan_of_opened(recording: Recording) -> SetupPlan:
    """The plan of a recording without a recording.toml, which is to stand where it is opened."""
    plan = plan_from_manifest(recording.folder, recording.manifest_text, own=False)
    opened = recording.path.absolute()
    deeper = opened.is_dir() and opened in plan.folder.parents
    return replace(plan, at=opened) if deeper else plan


def _written(plan: SetupPlan, state: SetupState, replace_old: bool) -> Path:
    """Write it; what is to be opened then: the recording, or the session of what was drawn."""
    check_drawn(state)
    folder = write_setup(plan, replace_old=replace_old).parent
    return keep_drawn(folder, state) if state.occluders or state.lines else folder
