"""An open project: looked through again and again, read in the background, shown on its page."""

from __future__ import annotations

import time
from functools import partial
from math import inf
from pathlib import Path

from platformdirs import user_cache_path
from PySide6.QtCore import QTimer, Signal

from app.core.controller import Controller
from app.core.i18n import tr
from app.core.jobs.jobs import Job
from app.features.project.batch_watch import BatchWatch
from app.features.project.page import ProjectPage
from app.features.project.presenter import scene_of
from app.features.project.scene import RecordingRow
from tracking.progress import Progress
from tracking.project import (
    Project,
    ProjectList,
    ProjectRow,
    ReaderProcess,
    Wanted,
    next_to_review,
)
from tracking.project.agreements import compared_rows
from tracking.session import resolve_author

_LOOK_EVERY_MS = 4000
_SHOW_EVERY_MS = 400
"""While files are being read."""
_RESULTS = "results"
_HELD_EVERY_S = 60.0
"""Somebody who edits changes a session all the time; it is read again no more often than this."""


def cache_folder() -> Path:
    """Where what was read of recordings is kept."""
    return user_cache_path("trackwright", appauthor=False)


class ProjectController(Controller):
    """Shows the folder of a project on a page as it is now.

    Signals: `changed()`, another project is open, or none; `open_asked(row)`, a `RecordingRow`.
    """

    open_asked = Signal(object)

    def __init__(self, page: ProjectPage, parent: Controller) -> None:
        super().__init__(parent)
        self.page = page
        self.project: Project | None = None
        self.found: ProjectList | None = None
        self._look_job: Job | None = None
        self._read_job: Job | None = None
        self._reader: ReaderProcess | None = None
        self._share: float | None = None
        self._again = self._given_up = False
        self._read_s: dict[Path, float] = {}
        self._opened = ""
        self._timer = QTimer(self, interval=_LOOK_EVERY_MS)
        self._timer.timeout.connect(self.look)
        self._soon = QTimer(self, singleShot=True, interval=_SHOW_EVERY_MS)
        self._soon.timeout.connect(self.look)
        self.batches: BatchWatch = BatchWatch(self)
        self.batches.changed.connect(self._show)
        self.batches.ended.connect(self.look)
        page.cancel_asked.connect(self.batches.cancel)
        page.open_asked.connect(self._open)
        page.next_asked.connect(self.open_next)

    @property
    def folder(self) -> Path | None:
        """Of the open project; None: none is open."""
        return self.project.folder if self.project is not None else None

    @property
    def why_not_next(self) -> str:
        """Why there is no recording to review next, in words; "": there is one."""
        rows = self.found.rows if self.found is not None else ()
        if next_to_review(rows, self._opened) is not None:
            return ""
        if self._opened:
            return tr("Nothing is left to review in the other recordings")
        return self.page.scene.next_text or tr("Nothing is left to review")

    def open(self, folder: Path, author: str) -> None:
        """Open a folder as a project. author: as `Author.name`; whose sessions come first."""
        self.close()
        self.project = Project(folder, cache_folder(), author or resolve_author(None))
        self._show()
        self.changed.emit()
        self.look()

    def begin(self) -> None:
        """The page is shown: look through the folder now, and every few seconds."""
        self._opened, self._given_up = "", False
        self._timer.start()
        self.look()

    def pause(self) -> None:
        """The page is not shown; what is being read goes on."""
        self._timer.stop()

    def close(self) -> None:
        """No project is open any more; its threads have ended when this returns."""
        self._timer.stop()
        self._soon.stop()
        if self._reader is not None:
            self._reader.close()
        for job in (self._look_job, self._read_job):
            if job is not None:
                job.end_untold()
        self._look_job = self._read_job = self._reader = None
        project, self.project, self.found = self.project, None, None
        self._share, self._again, self._opened = None, False, ""
        self._read_s.clear()
        if project is not None:
            project.close()
            self.changed.emit()

    def image_of(self, name: str) -> bytes:
        """The image of a recording by its name."""
        rows = self.found.rows if self.found is not None else ()
        row = next((one for one in rows if one.name == name), None)
        return self.project.image(row) if self.project is not None and row is not None else b""

    def open_next(self) -> None:
        """Open the recording that is reviewed next."""
        rows = self.found.rows if self.found is not None else ()
        best = next_to_review(rows, self._opened)
        row = None if best is None else self.page.row_named(best.name)
        if row is not None:
            self.page.table.choose(row.name)
            self._open(row)

    def _open(self, row: RecordingRow) -> None:
        self._opened = row.name
        self.open_asked.emit(row)

    def look(self) -> None:
        """Look through the folder in the background."""
        project = self.project
        if project is None:
            return
        if self._look_job is not None:
            self._again = True
            return
        self._again = False
        self._look_job = job = Job("project", lambda _: project.look(), self, listed=False)
        job.done.connect(self._take)
        job.failed.connect(self._fail)
        job.start()

    def _take(self, found: ProjectList) -> None:
        self._end_look()
        self.found = found
        self.batches.follow(found.batches)
        self._show()
        self._read(found.wanted)
        if self._again:
            self.look()

    def _fail(self, error: Exception) -> None:
        """A folder that has gone is told once; its page stays as it was."""
        self._end_look()
        self._timer.stop()
        if self.found is None:
            self.found = ProjectList(self.project.folder) if self.project is not None else None
            self._show()
        self.failed.emit(error)

    def _end_look(self) -> None:
        if self._look_job is not None:
            self._look_job.deleteLater()
            self._look_job = None

    def _show(self) -> None:
        if self.project is None:
            return
        batches = self.batches
        scene = scene_of(self.found, self.project.folder, self._share, batches.works, batches.left)
        self.page.show_scene(scene)
        if batches.watched is None:
            self.page.show_batch("", None, None)
        else:
            self.page.show_batch(batches.text, batches.share, batches.watched.seconds_left)
        self.changed.emit()

    def batch_choices(self) -> dict[str, tuple[Path, ...]]:
        """Recordings that a batch may track, by what the choice is called."""
        rows = self.found.rows if self.found is not None else ()
        paths = {row.name: row.recording.path for row in rows if row.recording is not None}
        chosen = [row.name for row in self.page.table.chosen()]
        untracked = [row.name for row in rows if not (row.sessions or row.problem)]
        named = {
            tr("Selected"): chosen if len(chosen) > 1 else [],
            tr("Not tracked yet"): untracked,
            tr("All of the project"): list(paths),
        }
        return {
            choice: tuple(paths[name] for name in names if name in paths)
            for choice, names in named.items()
        }

    @property
    def compared(self) -> list[ProjectRow]:
        """The recordings that two or more annotators' sessions are of."""
        return compared_rows(self.found.rows if self.found is not None else ())

    @property
    def labelled(self) -> list[Path]:
        """Sessions with labels of body parts, which a detector can learn from."""
        rows = self.found.rows if self.found is not None else ()
        sessions = [one for row in rows for one in row.sessions]
        return [one.path for one in sessions if one.facts is not None and one.facts.part_labels]

    @property
    def results_folder(self) -> Path:
        """Where a batch puts its results unless told otherwise: where one did before."""
        assert self.project is not None
        before = self.found.batches if self.found is not None else ()
        return before[0] if before else self.project.folder / _RESULTS

    def _read(self, wanted: tuple[Wanted, ...]) -> None:
        """Read what is not known, where nothing is being read yet."""
        project = self.project
        now_s = time.monotonic()
        wanted = tuple(one for one in wanted if not self._may_wait(one, now_s))
        if not wanted or self._read_job is not None or project is None or self._given_up:
            return
        self._read_s |= dict.fromkeys((one.file.path for one in wanted), now_s)
        self._reader = reader = ReaderProcess()
        work = partial(_read_all, project, wanted, reader)
        self._read_job = job = Job(tr("Reading the recordings of the project"), work, self)
        job.progressed.connect(self._tell)
        job.done.connect(lambda _: self._end_read())
        job.failed.connect(self._fail_read)
        job.cancelled.connect(self._give_up_reading)
        self._share = 0.0
        job.start()
        self._show()

    def _may_wait(self, wanted: Wanted, now_s: float) -> bool:
        """Whether a file was read a moment ago, and changes again as long as it is open."""
        return wanted.is_held and now_s - self._read_s.get(wanted.file.path, -inf) < _HELD_EVERY_S

    def _tell(self, done: int, total: int) -> None:
        self._share = done / max(total, 1)
        if not self._soon.isActive():
            self._soon.start()

    def _fail_read(self, error: Exception) -> None:
        """A bug: reading again at once would fail again."""
        self._timer.stop()
        self._forget_read()
        self.failed.emit(error)

    def _give_up_reading(self) -> None:
        """The user cancelled it: nothing is read until the page is shown again."""
        self._given_up = True
        self._forget_read()
        self._show()

    def _end_read(self) -> None:
        self._forget_read()
        self.look()

    def _forget_read(self) -> None:
        if self._read_job is not None:
            self._read_job.deleteLater()
        self._read_job = self._reader = None
        self._share = None


def _read_all(
    project: Project, wanted: tuple[Wanted, ...], reader: ReaderProcess, report: Progress
) -> None:
    with reader:
        project.read(wanted, reader, report)
