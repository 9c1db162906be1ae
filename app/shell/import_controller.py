"""Tracks of other tools into the open document: a file chosen, looked over, taken as one edit."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from app.core.commands.conditions import drawable
from app.core.controller import Controller
from app.core.document import document_loader
from app.core.i18n import count_text, joined_text, tr
from app.core.jobs.latest_job import LatestJob
from app.core.widgets.questions import ask_unit, choose_file
from app.core.widgets.work import Work
from app.features.files.import_dialog import ImportDialog
from app.features.files.track_import import (
    FittedTracks,
    ImportChoice,
    ReadFile,
    import_scene,
    prepare_fit,
    read_tracks,
    with_good,
)
from app.shell.recording_controller import RecordingController
from tracking.errors import SessionError, TrackwrightError, UnitUnsaidError
from tracking.formats import Stated, TrackFormat, format_named, readable_formats, track_endings
from tracking.progress import Progress
from tracking.session import Session, describe_footage
from tracking.tracks import Labels

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow


class ImportController(Controller):
    """Imports tracks into what is open in a window."""

    def __init__(self, window: MainWindow, work: Work, parent: QObject) -> None:
        super().__init__(parent)
        self._window, self._work = window, work

    def ask(self) -> None:
        """Ask for the file."""
        endings = " ".join(f"*{each}" for each in track_endings())
        filters = f"{tr('Tracks of other tools')} ({endings})"
        last = self._window.remembered.last_folder("import")
        choose_file(self._window, tr("Import tracks"), filters, self.read, last)

    def read_dropped(self, path: Path) -> None:
        """The same of a file that was dropped, where the command may be given, too."""
        controller = self._window.controller
        if controller is None:
            return
        if why_not := drawable(self._window.app):
            self.said.emit(why_not)
        else:
            self.read(path)

    def read(self, path: Path, known: TrackFormat | None = None, unit: str = "") -> None:
        """Read a file in the background and show what it holds.

        Where it does not say the unit of its lengths, the user is asked.
        """
        controller = self._window.controller
        if controller is None:
            return
        filmed = replace(describe_footage(controller.document.recording), stated=Stated(unit))

        def work(report: Progress) -> ReadFile | None:
            try:
                return read_tracks(path, filmed, known, report)
            except UnitUnsaidError:
                return None

        def done(read: ReadFile | None) -> None:
            if controller is not self._window.controller:
                return
            if read is None:
                ask_unit(self._window, path.name, lambda unit: self.read(path, known, unit))
            else:
                LookedOver(self, controller, read).open()

        self._work.run(tr("Reading {name}", name=path.name), work, done)

    def take(self, controller: RecordingController, read: ReadFile, fitted: FittedTracks) -> None:
        """Take the tracks: as an edit, or where there is no session as a new one.

        Nothing is taken where another session came since the file was looked over, or a tracker's
        people are in view.
        """
        came = (fitted.into is None) != (controller.document.session is None)
        if (
            why_not := tr("another session was opened meanwhile")
            if came
            else drawable(self._window.app)
        ):
            self.failed.emit(
                SessionError("Nothing was imported: {why}; import the file again", why=why_not)
            )
            return
        if fitted.into is None:
            work = partial(_kept, controller, read, fitted)
            title = tr("Importing {name}", name=read.path.name)
            self._work.run(title, work, partial(self._show, controller, fitted), cancellable=False)
            return
        try:
            if fitted.written is not None:
                controller.document.apply(fitted.written.change, fitted.written)
        except TrackwrightError as error:
            self.failed.emit(error)
            return
        self._tell(controller, fitted)

    def _show(
        self, controller: RecordingController, fitted: FittedTracks, session: Session
    ) -> None:
        controller.tracking.take_session(session)
        self._tell(controller, fitted)

    def _tell(self, controller: RecordingController, fitted: FittedTracks) -> None:
        controller.draw()
        told = count_text(fitted.found.tracks, "{n} track imported", "{n} tracks imported")
        bad = fitted.found.bad_count
        left = count_text(bad, "{n} row was left out", "{n} rows were left out") if bad else ""
        self.said.emit(joined_text("; ", filter(None, (told, left))))


class LookedOver(QObject):
    """A file that was read, in its dialog; what is chosen there is worked out in the background."""

    def __init__(
        self, importing: ImportController, controller: RecordingController, read: ReadFile
    ) -> None:
        super().__init__(importing)
        self._importing, self._controller, self._read = importing, controller, read
        formats = [(each.name, tr(each.title)) for each in readable_formats()]
        self._dialog = ImportDialog(read.path.name, formats, controller.window_page)
        self._fitted: FittedTracks | None = None
        self._search = LatestJob(tr("Fitting tracks to the recording"), self._prepare, self)
        self._search.progressed.connect(self._dialog.show_progress)
        self._search.found.connect(self._take)
        self._search.failed.connect(lambda _, error: self._fail(error))
        self._search.cancelled.connect(lambda *_: self._dialog.reject())
        self._dialog.choice_made.connect(self._choose)
        self._dialog.format_chosen.connect(self._read_as)
        self._dialog.finished.connect(self._end)

    def open(self) -> None:
        """Show the dialog."""
        self._show()
        self._search.ask(self._dialog.choice)
        self._dialog.open()

    @property
    def _session(self) -> Session | None:
        return self._controller.document.session

    def _show(self) -> None:
        own = len(self._controller.document.tracks.ids) if self._session is not None else 0
        scene = import_scene(self._read, self._fitted, own)
        self._dialog.show_scene(scene, self._read.format.name)

    def _prepare(self, choice: ImportChoice) -> Callable[[Progress], FittedTracks]:
        session = self._session
        table = session.tracks.snapshot() if session is not None else None
        labels = session.labels if session is not None else Labels()
        project = document_loader.labels_at_first(self._controller.document.recording)
        return prepare_fit(self._read, choice, table, labels, project.schema)

    def _choose(self) -> None:
        choice, fitted = self._dialog.choice, self._fitted
        if fitted is not None and fitted.choice.wish == choice.wish:
            self._fitted = with_good(fitted, choice.takes_good)
        else:
            self._fitted = None
            self._search.ask(choice)
        self._show()

    def _take(self, fitted: FittedTracks) -> None:
        choice = self._dialog.choice
        if fitted.choice.wish == choice.wish:
            self._fitted = with_good(fitted, choice.takes_good)
            self._show()

    def _fail(self, error: Exception) -> None:
        self._dialog.reject()
        self._importing.failed.emit(error)

    def _read_as(self, name: str) -> None:
        """Read the file anew as another format; that has a dialog of its own."""
        self._dialog.reject()
        self._importing.read(self._read.path, format_named(name))

    def _end(self, result: int) -> None:
        self._search.stop()
        self._dialog.deleteLater()
        self.deleteLater()
        if (
            result
            and self._fitted is not None
            and self._controller is self._importing._window.controller
        ):
            self._importing.take(self._controller, self._read, self._fitted)


def _kept(
    controller: RecordingController, read: ReadFile, fitted: FittedTracks, report: Progress
) -> Session:
    """The tracks as a session of their own."""
    report(0, 1)
    return document_loader.keep_import(controller.document.recording, fitted.found, read.origin)
