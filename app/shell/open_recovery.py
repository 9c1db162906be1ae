"""What is offered where a session does not open: its recording elsewhere, an older copy of it."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from app.core.controller import Controller
from app.core.document import document_loader
from app.core.i18n import tr
from app.core.widgets.questions import choose_file
from app.core.widgets.work import Work
from tracking.errors import SessionError, TrackwrightError
from tracking.session import RecordingMissing, find_backups

if TYPE_CHECKING:
    from app.shell.files import Files
    from app.shell.main_window import MainWindow


class OpenRecovery(Controller):
    """Tells why work did not end well, with a way on where there is one."""

    def __init__(self, files: Files, window: MainWindow, work: Work) -> None:
        super().__init__(files)
        self._files, self._window, self._work = files, window, work
        self._opening: Path | None = None  # only while it is being opened as the document
        work.changed.connect(self._end_opening)

    def begin_opening(self, path: Path) -> None:
        """What fails from now on is the opening of this, until the work is done."""
        if not self._work.busy:
            self._opening = path

    def tell(self, error: Exception) -> None:
        """Tell why something did not work; offer to find a recording that has moved."""
        session = self._opening
        if isinstance(error, RecordingMissing) and session is not None:
            find = partial(self._find, session)
            self._window.notice.say(tr(error.reason), tr("Find it..."), find, is_error=True)
        elif isinstance(error, SessionError) and session is not None and find_backups(session):
            take = tr("Open the copy saved before")
            older = partial(self._open_older, session)
            self._window.notice.say(tr(error.message), take, older, is_error=True)
        else:
            self.failed.emit(error)

    def _end_opening(self) -> None:
        if not self._work.busy:
            self._opening = None

    def _open_older(self, session: Path) -> None:
        try:
            copy = document_loader.copy_newest_backup(session)
        except TrackwrightError as error:
            self.failed.emit(error)
            return
        if copy is not None:
            self._files.open_path(copy)

    def _find(self, session: Path) -> None:
        choose_file(
            self._window,
            tr("Where is the recording now?"),
            "",
            lambda place: self._files.open_path(session, place),
            self._window.remembered.last_folder("open"),
            folder=True,
        )
