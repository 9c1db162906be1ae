"""The open document's way from disk and back: open, save, export, close."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QUrl, Signal

from app.presenters.files import opening
from app.presenters.files.demonstration import Demonstration
from app.presenters.files.first_page import first_page
from app.presenters.files.opening import Opened
from app.presenters.scenes import WelcomeScene
from app.presenters.words import tr
from app.views.desk.desk import Desk
from app.views.files.author import Author
from app.views.files.compare import Beside
from app.views.files.exporting import Exporting, beside
from app.views.files.generations import OlderStates
from app.views.files.keeping import Keeping
from app.views.files.leaving import Leaving, Then
from app.views.files.whereabouts import Whereabouts
from app.views.parts.detectors import Detectors
from app.views.runs.track_dialog import TrackDialog
from app.views.widgets.questions import choose_file, choose_new_file
from app.views.widgets.remembered import Remembered
from app.views.widgets.work import Work
from tracking.errors import SessionError, TrackwrightError
from tracking.recording import OpenOptions
from tracking.session import RecordingMissing, Session, generations

if TYPE_CHECKING:
    from app.views.window.main_window import MainWindow

_SESSIONS = "trackwright (*.h5)"
_OPENABLE = "Recordings and sessions (recording.toml *.h5 *.mp4 *.avi *.mkv *.mov *.ts *.m4v)"


class Files(QObject):
    """Opens recordings and sessions on the window's desk, saves and closes them.

    Signals: `changed()`, another document, title or save state; `progressed()`, the tracker at
    work is further; `failed(error)`; `said(text)`.
    """

    changed = Signal()
    progressed = Signal()
    failed = Signal(object)
    said = Signal(str)

    def __init__(self, window: MainWindow, work: Work, remembered: Remembered) -> None:
        super().__init__(window)
        self._window = window
        self._work = work
        self._remembered = remembered
        self._opening: Path | None = None  # only while it is being opened as the document
        work.changed.connect(self._end_opening)
        self._save_at: Path | None = None
        self._whereabouts = Whereabouts(remembered, self)
        self._greeting = ""
        self._leaving = Leaving(self, window)
        self.desk: Desk | None = None
        self.author = Author(window, remembered, self)
        self.exporting = Exporting(window, work, self)
        self.exporting.said.connect(self.said)
        self.detectors = Detectors(window, work, remembered, self)
        self.detectors.changed.connect(self.changed)
        self.detectors.failed.connect(self.failed)
        self.detectors.said.connect(self.said)
        self.older = OlderStates(window, work, self)
        self.older.said.connect(self.said)
        self.older.changed.connect(self.changed)
        self.beside = Beside(window, work, self)
        self.keeping = Keeping(window, work, self)
        self.keeping.changed.connect(self.changed)

    # opening

    def ask_open(self) -> None:
        """Ask for a file."""
        choose_file(self._window, tr("Open"), tr(_OPENABLE), self.open_path)

    def ask_open_folder(self) -> None:
        """Ask for a folder: a recording, or pictures."""
        choose_file(self._window, tr("Open folder"), "", self.open_path, folder=True)

    def open_dropped(self, urls: Sequence[QUrl]) -> None:
        """Open the first of some files that were dropped."""
        paths = [Path(url.toLocalFile()) for url in urls if url.isLocalFile()]
        if paths:
            self.open_path(paths[0])

    def open_path(
        self,
        path: Path,
        recording: Path | None = None,
        options: OpenOptions | None = None,
        *,
        play: bool = False,
        save_at: Path | None = None,
    ) -> None:
        """Open a recording or a session.

        Args:
            path: what to open.
            recording: where a session's recording is by now.
            options: what a bare recording does not say of itself.
            play: play at once, and track what has no tracks yet.
            save_at: the place that is proposed for the session; beside the recording if None.
        """
        again = partial(self.open_path, path, recording, options, play=play, save_at=save_at)
        if not self.may_leave(again):
            return
        if not self._work.busy:
            self._opening = path
        self._remembered.note_closed()  # what crashes while it opens is not opened again unasked
        title = tr("Opening {name}", name=path.name)

        def show(opened: Opened) -> None:
            self._show(opened, from_start=play)
            self._save_at = save_at
            if play and self.desk is not None:
                self.desk.toggle()

        work = partial(opening.open_cancellable, path, recording, options)
        self._work.run(title, work, show)

    def open_demo(self) -> None:
        """Make the built-in recording where it is not there yet, and play it."""
        demo = Demonstration.of_user()
        play = partial(self.open_path, play=True, save_at=demo.session)
        self._work.run(tr("Making the demo recording"), demo.make, play)

    def tell_failure(self, error: Exception) -> None:
        """Tell why something did not work; offer to find a recording that has moved."""
        session = self._opening
        if isinstance(error, RecordingMissing) and session is not None:
            find = partial(self._find, session)
            self._window.notice.say(str(error), tr("Find it..."), find, is_error=True)
        elif isinstance(error, SessionError) and session is not None and generations(session):
            take = tr("Open the copy saved before")
            older = partial(self._open_older, session)
            self._window.notice.say(str(error), take, older, is_error=True)
        else:
            self.failed.emit(error)

    def _end_opening(self) -> None:
        if not self._work.busy:
            self._opening = None

    def _open_older(self, session: Path) -> None:
        try:
            copy = opening.older_copy(session)
        except TrackwrightError as error:
            self.failed.emit(error)
            return
        if copy is not None:
            self.open_path(copy)

    def _find(self, session: Path) -> None:
        choose_file(
            self._window,
            tr("Where is the recording now?"),
            "",
            lambda place: self.open_path(session, place),
            folder=True,
        )

    def _show(self, opened: Opened, from_start: bool) -> None:
        self.close()
        path = opened.path
        self.desk = desk = Desk(opened.document, self._window.workspace, self)
        self.author.sign()
        self.detectors.begin(desk)
        desk.changed.connect(self.changed)
        desk.drawn.connect(self.beside.draw)
        desk.progressed.connect(self.progressed)
        desk.failed.connect(self.failed)
        desk.said.connect(self.said)
        desk.tracked.connect(self.keeping.keep)
        desk.noted.connect(lambda notes: self._window.notice.say("\n".join(notes)))
        if not opening.is_unsaved_place(path):
            self._remembered.add_recent(path.resolve())
        self._window.show_workspace()
        self._tell_oddities(opened)
        desk.set_eyes(self._remembered.text("eyes", "both"))
        self._whereabouts.begin(desk, path, from_start)

    def greet_after_crash(self) -> None:
        """Say, with what is opened next, that it was open when the program ended in a crash."""
        self._greeting = tr("trackwright did not end as it should; here is where you were.")

    def _tell_oddities(self, opened: Opened) -> None:
        session = opened.document.session
        greeting, self._greeting = self._greeting, ""
        lines = [
            *([greeting] if greeting else []),
            *(() if session is None else session.notes),
            *opened.document.recording.notes,
        ]
        if lines:
            self._window.notice.say("\n".join(lines), passing=True)
        else:
            self._window.notice.hide()

    # tracking

    def ask_track(self) -> None:
        """Ask for tracker and settings, then put it to work; corrected tracks are not touched."""
        desk = self.desk
        if desk is None:
            return
        if self.keeping.holds:
            self.keeping.offer()
            return
        warning = ""
        if self.session is not None and len(self.session.history):
            warning = tr(
                "The corrected tracks stay as they are; the new result is kept beside them."
            )
        document = desk.document
        asked = document.parts_asked
        dialog = TrackDialog(
            document.recording, desk.proposed_tracker, warning, self._window, asked
        )
        dialog.accepted.connect(lambda: self._track(dialog))
        dialog.open()

    def _track(self, dialog: TrackDialog) -> None:
        if self.desk is not None:
            self.desk.track(*dialog.answer())

    # saving

    @property
    def session(self) -> Session | None:
        """The open session."""
        return self.desk.document.session if self.desk is not None else None

    @property
    def unsaved(self) -> bool:
        """Whether something would be lost from view without saving."""
        if self.tracker_found_some or self.keeping.holds:
            return True
        session = self.session
        return session is not None and (session.dirty or opening.is_unsaved_place(session.path))

    @property
    def tracker_found_some(self) -> bool:
        """Whether a tracker is at work and has come past its first frame."""
        return self.desk is not None and self.desk.live.running and self.desk.live.done > 0

    def save(self, then: Then | None = None) -> None:
        """Save where the session stands; ask for a place where it has none yet."""
        self._window.workspace.take_typed()
        session = self.session
        if session is None:
            self.keeping.try_again(then)
        elif opening.is_unsaved_place(session.path):
            self.save_as(then)
        elif session.path is not None:
            self.save_to(session.path, then)

    def save_as(self, then: Then | None = None) -> None:
        """Ask for a place and save there."""
        self._window.workspace.take_typed()
        if self.desk is not None:
            own = self.session.path if self.session is not None else None
            name = "session.h5" if own is None or opening.is_unsaved_place(own) else own.name
            start = self._save_at or beside(self.desk.document, name)
            chosen = partial(self.save_to, then=then)
            choose_new_file(self._window, tr("Save session"), start, _SESSIONS, chosen)

    def save_to(self, path: Path, then: Then | None = None) -> None:
        """Save at a place in the background."""
        session = self.session
        if self._work.refuses():
            return
        if session is None:
            self.keeping.try_again(then, path)
            return

        def saved(_: object) -> None:
            opening.finish_save(session, pending)
            self._remembered.add_recent(path.resolve())
            self.said.emit(tr("Saved: {path}", path=path))
            self.changed.emit()
            if then is not None:
                then()

        try:
            pending = session.begin_save(path)
        except TrackwrightError as error:
            self.failed.emit(error)
            return
        title = tr("Saving {name}", name=path.name)
        abandon = partial(session.abandon_save, pending)
        self._work.run(title, lambda _: pending.write(), saved, abandon, cancellable=False)

    # leaving

    def may_leave(self, again: Then) -> bool:
        """Whether the open document can be let go; if not, ask, and do `again` afterwards."""
        self._window.workspace.take_typed()
        return self._leaving.may_leave(again)

    def close_recording(self) -> None:
        """Close what is open and go back to the first page."""
        if self.may_leave(self.close_recording):
            self.close()
            self._window.notice.hide()
            self._window.show_welcome()

    def quit(self) -> None:
        """Close the window."""
        self._window.close()

    def close(self) -> None:
        """Let the open document go; its threads have ended when this returns."""
        if self.desk is not None:
            desk, self.desk = self.desk, None
            self.keeping.drop()
            self.beside.close()
            self.older.close()
            self.detectors.close()
            if desk.document.recording.is_stereo:  # one camera leaves nothing to choose
                self._remembered.set_text("eyes", desk.eyes)
            self._whereabouts.end()
            desk.close()
            desk.deleteLater()

    def close_without_asking(self) -> None:
        """Let the open document go for a picture or a test: what is not saved stays as it is."""
        self._leaving.agree()
        self.close()

    # words

    def title(self) -> str:
        """The window's title, with Qt's place for the mark of unsaved changes."""
        if self.desk is None:
            return "trackwright"
        recording, session = self.desk.document.recording, self.session
        name = recording.name
        if session is not None and session.path is not None:
            kept = not opening.is_unsaved_place(session.path)
            name = f"{name} \u2013 {session.path.name if kept else tr('not saved yet')}"
        return f"{name}[*] \u2013 trackwright"

    def welcome_scene(self) -> WelcomeScene:
        """The first page: what was opened before, and what a crash left behind."""
        return first_page(self._remembered.recent)
