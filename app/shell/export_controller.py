"""What is made of the open session for others: exported tracks, the log of edits, a score."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from app.core.controller import Controller
from app.core.document import document_loader
from app.core.document.document import Document
from app.core.i18n import joined, tr
from app.core.keymap import in_brackets
from app.core.widgets.questions import choose_file, choose_new_file
from app.core.widgets.work import Work
from app.features.counting.controller import CountController
from app.features.counting.subject import CountResult
from app.features.files.export import prepare_export, refuse_to_lose
from app.features.files.export_dialog import ExportDialog
from app.features.files.export_formats import (
    export_formats,
    propose_file_name,
    propose_report_folder,
)
from app.features.files.own_files import remember
from app.features.scoring.controller import ScoreController
from app.features.scoring.score_report import WrittenReport, prepare_report
from app.features.scoring.subject import ScoreResult, score_subject
from tracking.counting import write_counts
from tracking.editing import History
from tracking.errors import CountingError
from tracking.formats import format_named, losses
from tracking.progress import Progress
from tracking.session import Session, write_log_csv, write_log_json

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow
    from app.shell.recording_controller import RecordingController

_LOGS = "CSV (*.csv);;JSON (*.json)"


class ExportController(Controller):
    """Writes files of the session that is open in a window."""

    def __init__(self, window: MainWindow, work: Work, parent: QObject) -> None:
        super().__init__(parent)
        self._window = window
        self._work = work
        self._format = "mot"  # as it was exported last

    @property
    def _session(self) -> Session | None:
        return None if self._window.controller is None else self._window.controller.document.session

    def ask_tracks(self) -> None:
        """Ask which tracks are exported, and as what; then for a place."""
        session = self._session
        if session is None:
            return
        runs = (
            tr("Run {number}: {tracker}", number=number, tracker=run.tracker)
            for number, run in enumerate(session.runs)
        )
        track_sources = (tr("Corrected tracks"), *runs)
        dialog = ExportDialog(export_formats(), track_sources, self._format, self._window)
        dialog.asked.connect(self._ask_place)
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()

    def _ask_place(self, name: str, run: int) -> None:
        self._format = name
        controller = self._window.controller
        each = next(one for one in export_formats() if one.name == name)
        if controller is not None:
            proposed = propose_file_name(controller.document.recording.name, each)
            wanted = None if run < 0 else run
            filters = f"{each.title} (*{each.ending})"
            self._ask(
                tr("Export tracks"),
                proposed,
                filters,
                lambda path: self.tracks_to(path, name, wanted),
            )

    def tracks_to(self, path: Path, name: str = "mot", run: int | None = None) -> None:
        """Write the corrected tracks, or a run's, in a format; piece by piece, and cancellable."""
        session, controller = self._session, self._window.controller
        kind = format_named(name)
        write = kind.write
        if session is None or controller is None or write is None:
            return
        # What is edited meanwhile is not in it.
        put_together = prepare_export(session, run, controller.document.recording.view)

        def work(report: Progress) -> tuple[str, tuple[str, ...]]:
            refuse_to_lose(path)
            exported = put_together()
            made = write(path, exported, report)
            remember(made)
            others = [file.name for file in made if file != path]
            beside = tr("Beside it: {files}", files=joined(", ", others)) if others else ""
            return beside, losses(kind, exported, path)

        title = tr("Exporting {name}", name=path.name)
        self._work.run(title, work, lambda told: self._tell_of_tracks(path, *told), place=path)

    def _tell_of_tracks(self, path: Path, beside: str, lost: tuple[str, ...]) -> None:
        """Where they are; and what the format does not hold stays said until it is read."""
        where = tr("Exported: {path}", path=path)
        told = f"{where}. {beside}" if beside else where
        self._tell("\n".join((told, *lost)), path, passing=not lost)

    def ask_report(self) -> None:
        """Ask for a folder and put a report of the score into one of its own there."""
        title = tr("Choose a folder: the report gets a new folder inside it")
        last = self._window.remembered.last_folder("report")
        choose_file(self._window, title, "", self.report_in, last, folder=True)

    def report_in(self, place: Path) -> None:
        """Write a report of the score as it was worked out last; where it was not, score first."""
        controller = self._window.controller
        if controller is None:
            return
        presenter = controller.of(ScoreController).presenter
        scored, subject = presenter.scored, presenter.current_subject()
        if scored is not None and (subject is None or scored.subject.version == subject.version):
            self._report(controller, scored, place)
        elif subject is not None:
            work = partial(score_subject, subject, None, presenter.capture(subject))
            self._work.run(
                tr("Scoring"), work, lambda scored: self._report(controller, scored, place)
            )

    def _report(self, controller: RecordingController, scored: ScoreResult, place: Path) -> None:
        if controller is not self._window.controller:
            return
        presenter, document = controller.of(ScoreController).presenter, controller.document
        given = presenter.capture(scored.subject)
        name = presenter.scene("").results[scored.subject.track_source + 1]
        folder = place / propose_report_folder(document.recording.name)
        work = prepare_report(document, scored, given, name, folder)
        self._work.run(tr("Writing the report"), work, self._tell_of_report, place=folder)

    def _tell_of_report(self, done: WrittenReport) -> None:
        """Where it is; and what is not in it stays said until it is read."""
        where = tr("Report: {path}", path=done.page)
        if done.left_out:
            self._tell(f"{where}\n{done.words}", done.page, passing=False)
        else:
            self._tell(where, done.page)

    def ask_log(self) -> None:
        """Ask for a place and write the log of edits."""
        self._ask(tr("Export the edit history"), "edits.csv", _LOGS, self.log_to)

    def log_to(self, path: Path) -> None:
        """Write the log of edits: as JSON where the name ends so, else as CSV."""
        session = self._session
        if session is not None:
            entries = session.history.entries  # what is edited meanwhile is not in it
            write = write_log_json if path.suffix.lower() == ".json" else write_log_csv
            self._write(path, lambda report: write(History(entries), path, report))

    def ask_counts(self) -> None:
        """Ask for a place and write what is counted, step by step; told where nothing is."""
        controller = self._window.controller
        if controller is None or controller.of(CountController).work() is None:
            self.said.emit(
                tr(
                    "Nothing is counted: draw a line{line_key} or a region{region_key} first",
                    line_key=in_brackets("labels.lines"),
                    region_key=in_brackets("labels.regions"),
                )
            )
            return
        self._ask(tr("Export counts"), "counts.csv", "CSV (*.csv)", self.counts_to)

    def counts_to(self, path: Path) -> None:
        """Count the tracks of now and write that as CSV."""
        controller = self._window.controller
        counting = controller.of(CountController).work() if controller is not None else None
        if counting is not None:
            self._write(path, lambda report: _written(counting(report), path))

    def _ask(self, title: str, name: str, filters: str, chosen: Callable[[Path], object]) -> None:
        controller = self._window.controller
        if self._session is not None and controller is not None:
            start = beside(controller.document, name)
            last = self._window.remembered.last_folder("export")
            choose_new_file(self._window, title, start, filters, chosen, last)

    def _write(self, path: Path, work: Callable[[Progress], object]) -> None:
        title, told = tr("Exporting {name}", name=path.name), tr("Exported: {path}", path=path)
        done = lambda left: self._tell(f"{told}. {left}" if left else told, path)  # noqa: E731
        self._work.run(title, work, done, place=path)

    def _tell(self, text: str, place: Path, *, passing: bool = True) -> None:
        """What came of it, with a button that opens it."""
        self._window.tell_ended(text, place, passing=passing)


def _written(counted: CountResult, path: Path) -> str:
    """Write what could be counted; gives what was left out and why.

    Raises CountingError where nothing could be counted.
    """
    counts, left_out = counted.counts, " ".join(why for _, why in counted.left_out)
    if not (counts.lines or counts.regions):
        raise CountingError(left_out)
    write_counts(path, counts)
    return left_out


def beside(document: Document, name: str) -> Path:
    """Where a file of that name is proposed: by the session's file, else by the recording."""
    own = document.session.path if document.session is not None else None
    if own is not None and not document_loader.is_unsaved_place(own):
        return own.with_name(name)
    place = document.recording.path
    return (place if place.is_dir() else place.parent) / name
