"""Saving the open session: where it stands, somewhere else, and what is to happen after it."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from app.core.controller import Controller
from app.core.document import document_loader
from app.core.i18n import tr
from app.core.widgets.questions import choose_new_file
from app.core.widgets.user_settings import UserSettings
from app.core.widgets.work import Work
from app.features.files.export_formats import propose_session_name
from app.shell.close_prompts import Then
from app.shell.export_controller import beside
from tracking.errors import TrackwrightError
from tracking.session import Session

if TYPE_CHECKING:
    from app.shell.files import Files
    from app.shell.main_window import MainWindow

_SESSIONS = "trackwright (*.h5)"


class SaveController(Controller):
    """Saves the open document in the background.

    Signals: `changed()`, it is saved.

    Attributes:
        proposed: the place that is proposed for a session without one; None: beside the recording.
        settled: the state of the session that is no change of ours.
    """

    def __init__(
        self, files: Files, window: MainWindow, work: Work, remembered: UserSettings
    ) -> None:
        super().__init__(files)
        self._files, self._window = files, window
        self._work, self._remembered = work, remembered
        self.proposed: Path | None = None
        self.settled: object = None

    def begin(self, session: Session | None) -> None:
        """A session as it was opened, if it was: nothing of it is changed here yet."""
        self.settled = _state(session)

    @property
    def changed_here(self) -> bool:
        """Whether something unsaved was done since it was opened: in this window, by somebody.

        Edits of an earlier sitting that are still unsaved stay where they are kept.
        """
        return self.unsaved and (
            self._files.tracker_found_some
            or self._files.keeping.holds
            or _state(self._files.session) != self.settled
        )

    @property
    def unsaved(self) -> bool:
        """Whether something would be lost from view without saving."""
        if self._files.tracker_found_some or self._files.keeping.holds:
            return True
        session = self._files.session
        return session is not None and (
            session.dirty or document_loader.is_unsaved_place(session.path)
        )

    def save(self, then: Then | None = None) -> None:
        """Save where the session stands; ask for a place where it has none yet."""
        self._window.workspace.take_typed()
        session = self._files.session
        if session is None:
            self._files.keeping.try_again(then)
        elif document_loader.is_unsaved_place(session.path):
            self.save_as(then)
        elif session.path is not None:
            self.save_to(session.path, then)

    def save_as(self, then: Then | None = None) -> None:
        """Ask for a place and save there."""
        self._window.workspace.take_typed()
        if self._files.controller is not None:
            own = self._files.session.path if self._files.session is not None else None
            document = self._files.controller.document
            kept = own is not None and not document_loader.is_unsaved_place(own)
            name = (
                own.name
                if own is not None and kept
                else propose_session_name(document.recording.name)
            )
            start = self.proposed or beside(document, name)
            chosen = partial(self.save_to, then=then)
            last = self._remembered.last_folder("session")
            choose_new_file(self._window, tr("Save session"), start, _SESSIONS, chosen, last)

    def save_to(self, path: Path, then: Then | None = None) -> None:
        """Save at a place."""
        session = self._files.session
        if self._work.refuses():
            return
        if session is None:
            self._files.keeping.try_again(then, path)
            return

        def saved(_: object) -> None:
            document_loader.finish_save(session, pending)
            self.settled = settled
            self._remembered.add_recent(path.resolve(), session.recording.name)
            self.said.emit(tr("Saved: {path}", path=path))
            self.changed.emit()
            if then is not None:
                then()

        settled = _state(session)
        try:
            pending = session.begin_save(path)
        except TrackwrightError as error:
            self.failed.emit(error)
            return
        title = tr("Saving {name}", name=path.name)
        abandon = partial(session.abandon_save, pending)
        self._work.run(title, lambda _: pending.write(), saved, abandon, cancellable=False)


def _state(session: Session | None) -> object:
    """What tells whether somebody changed a session: what undo takes back is no change."""
    if session is None:
        return None
    last = session.history.next_undo
    edit = last.id if last is not None else 0
    return session.created, edit, session.runs.serials, session.adopted_run
