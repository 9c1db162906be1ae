"""From a project to its recordings and back."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QMessageBox

from app.core.controller import Controller
from app.core.i18n import tr
from app.core.widgets.questions import choose_file

# Most windows open no project: what one needs is imported with the first, as it takes long.
if TYPE_CHECKING:
    from app.features.project.batch_process import BatchWish
    from app.features.project.batch_watch import BatchWatch
    from app.features.project.controller import ProjectController
    from app.features.project.scene import RecordingRow
    from app.shell.main_window import MainWindow
    from tracking.project.agreements import PairAgreement


class ProjectNavigation(Controller):
    """Opens projects, and their recordings from them."""

    def __init__(self, window: MainWindow, parent: Controller) -> None:
        super().__init__(parent)
        self._window = window
        self._agreed = False
        self._project: ProjectController | None = None

    @property
    def project(self) -> ProjectController:
        """The open one; it and its page are made when they are first asked for."""
        if self._project is None:
            self._project = self._begun()
        return self._project

    def _begun(self) -> ProjectController:
        from app.features.project.controller import ProjectController

        page = self._window.project_page
        project = ProjectController(page, self)
        project.changed.connect(self.changed)
        project.open_asked.connect(self._open_row)
        project.batches.ended.connect(self._tell_of_batch)
        page.track_asked.connect(self.ask_batch)
        page.close_asked.connect(self.close_project)
        page.folder_asked.connect(self.ask)
        return project

    @property
    def batches(self) -> BatchWatch | None:
        """The batch of the project, if there is one; None while no project was opened."""
        return self._project.batches if self._project is not None else None

    @property
    def folder(self) -> Path | None:
        """Of the open project; None: none is open."""
        return self._project.folder if self._project is not None else None

    @property
    def is_open(self) -> bool:
        """Whether a project is open, shown or not."""
        return self.folder is not None

    @property
    def is_batch_at_work(self) -> bool:
        """Whether a batch works in the project, or one that was started from it still does."""
        return self._project is not None and self._project.batches.watched is not None

    @property
    def name(self) -> str:
        """Of the open project; "": none is open."""
        folder = self.project.folder if self.is_open else None
        return "" if folder is None else folder.name or str(folder)

    def pause(self) -> None:
        """The page is not shown."""
        if self._project is not None:
            self._project.pause()

    def ask(self) -> None:
        """Ask for the folder of a project."""
        last = self._window.remembered.last_folder("project")
        choose_file(self._window, tr("Open project"), "", self.open, last, folder=True)

    def open(self, folder: Path) -> None:
        """Open a folder as a project and show it; what is open is closed."""
        files = self._window.files
        if not files.may_leave(partial(self.open, folder)):
            return
        self._window.notice.hide()
        files.close()
        self.project.open(folder, files.author.name)
        self._window.remembered.add_recent(folder.resolve(), self.name, project=True)
        self._window.show_start()

    def ask_batch(self) -> None:
        """Ask which recordings of the project are tracked, and how; then start a batch."""
        choices = self.project.batch_choices()
        if not any(choices.values()):
            self.said.emit(tr("No recordings are in this folder"))
            return
        last = self._window.remembered.last_folder("batch")
        from app.features.project.batch_dialog import BatchDialog

        dialog = BatchDialog(choices, self.project.results_folder, last, self._window)
        dialog.accepted.connect(lambda: self._start(dialog.answer()))
        dialog.open()

    def _tell_of_batch(self, text: str) -> None:
        """Say that the batch has ended, also where a recording is shown, and offer its page."""
        from tracking.batch.report import report_path

        page = report_path(self.project.batches.out)
        if page.is_file():
            self._window.tell_ended(text, page, passing=False)
        else:
            self._window.notice.say(text)

    def compare(self) -> None:
        """Show how far annotators agree over all recordings with several sessions."""
        from app.features.project.agreement_dialog import AgreementDialog
        from tracking.project.agreements import agreements

        rows = self.project.compared

        def show(pairs: tuple[PairAgreement, ...]) -> None:
            AgreementDialog(pairs, self._window).open()

        title = tr("Comparing sessions")
        self._window.work.run(title, lambda report: agreements(rows, report), show)

    def train(self) -> None:
        """Train one detector from the labels of all sessions."""
        self._window.files.detectors.ask_train_on(self.project.labelled)

    def _start(self, wish: BatchWish) -> None:
        self._agreed = False
        self.project.batches.start(wish)

    def agree(self) -> None:
        """Leave the batch at work going, or ending, without a further question."""
        self._agreed = True

    def may_close(self, again: Callable[[], object]) -> bool:
        """Whether the window may close; if not, ask what becomes of the batch, then do `again`."""
        if self._agreed or self._project is None or not self._project.batches.is_own:
            return True
        box = QMessageBox(self._window)
        box.setObjectName("batch")
        box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        box.setIcon(QMessageBox.Icon.Question)
        box.setTextFormat(Qt.TextFormat.PlainText)
        box.setText(tr("A batch is at work."))
        box.setInformativeText(
            tr("It can go on without the window. Stopped, it goes on later from where it is.")
        )
        leave = box.addButton(tr("Leave it going"), QMessageBox.ButtonRole.AcceptRole)
        stop = box.addButton(tr("Stop it"), QMessageBox.ButtonRole.DestructiveRole)
        box.addButton(QMessageBox.StandardButton.Cancel)
        box.setDefaultButton(leave)

        def answered(_: int) -> None:
            if box.clickedButton() not in (leave, stop):
                return
            if box.clickedButton() is stop:
                self.project.batches.cancel()
            self.agree()
            again()

        box.finished.connect(answered)
        box.open()
        return False

    def back(self) -> None:
        """Close the recording and go back to the list."""
        self._window.files.close_recording()

    def close_project(self) -> None:
        """Close the project; a recording that is open stays so."""
        self.project.close()
        if self._window.controller is None:
            self._window.show_start()

    def end(self) -> None:
        """The window closes."""
        if self._project is not None:
            self._project.batches.close()
            self._project.close()

    def _open_row(self, row: RecordingRow) -> None:
        place = row.recording if row.path != row.recording else None
        self._window.files.open_path(row.path, place)
