"""File > Restore a backup: listed, looked at and restored in the background."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from app.core.controller import Controller
from app.core.error_messages import explain
from app.core.i18n import joined_text, tr
from app.core.jobs.jobs import Job
from app.core.widgets.work import Work
from app.features.files.backup_dialog import BackupDialog
from app.features.files.backups import list_backup_lines, what_differs
from tracking.session import Session

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow


class BackupController(Controller):
    """Restores backups of the session that is open in a window.

    `changed`: another state of the session is open.
    """

    def __init__(self, window: MainWindow, work: Work, parent: QObject) -> None:
        super().__init__(parent)
        self._window = window
        self._work = work
        self._looking: Job | None = None

    @property
    def _session(self) -> Session | None:
        return None if self._window.controller is None else self._window.controller.document.session

    def ask(self) -> None:
        """List the backups of the open session."""
        session = self._session
        if session is None or session.path is None:
            return
        path = session.path
        self._work.run(tr("Looking for backups"), lambda _: list_backup_lines(path), self._choose)

    def restore(self, number: int) -> None:
        """Restore a backup; the current state becomes the newest backup."""
        session = self._session
        if session is None:
            return
        # What is edited while the state is put back would be an edit of neither.
        self._window.workspace.setEnabled(False)
        self._work.run(
            tr("Restoring a backup"),
            lambda _: session.restore(number),
            self._show,
            lambda: self._window.workspace.setEnabled(True),
            cancellable=False,
        )

    def close(self) -> None:
        """End what is being looked at."""
        if self._looking is not None:
            job, self._looking = self._looking, None
            job.end_untold()

    def _choose(self, lines: object) -> None:
        if not isinstance(lines, tuple) or not lines:
            self.said.emit(tr("There is no backup yet: each save keeps the state before it"))
            return
        dialog = BackupDialog(lines, self._window)
        dialog.looked_at.connect(partial(self._look, dialog))
        dialog.restore_asked.connect(self.restore)
        dialog.finished.connect(self.close)
        dialog.begin()

    def _look(self, dialog: BackupDialog, number: int) -> None:
        """Find out what differs, in a thread; the last question counts."""
        session = self._session
        if session is None or session.path is None:
            return
        self.close()
        path, now, entries = session.path, session.tracks.snapshot(), session.history.entries
        job = Job(
            tr("Comparing with a backup"), partial(what_differs, path, number, now, entries), self
        )
        job.done.connect(lambda lines: dialog.show_differences(number, lines))
        job.cancelled.connect(lambda: dialog.show_differences(number, (tr("Cancelled."),)))
        job.failed.connect(lambda error: dialog.show_differences(number, (explain(error),)))
        self._looking = job
        job.start()

    def _show(self, session: Session) -> None:
        self._window.workspace.setEnabled(True)
        controller = self._window.controller
        if controller is None:
            session.close()
            return
        controller.tracking.take_session(session)
        done = tr("Restored. The state before is kept as the newest backup: File > Restore")
        self.said.emit(joined_text(" ", (done, *session.damage)))
        self.changed.emit()
