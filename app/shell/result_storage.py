"""Keeping what a tracker found; what cannot be put on disk waits in memory until it can."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from app.core.colours.track_colours import TrackColours
from app.core.controller import Controller
from app.core.document import document_loader
from app.core.error_messages import explain
from app.core.i18n import tr
from app.core.widgets.work import Work
from tracking.errors import CancelledError, TrackwrightError
from tracking.progress import Progress
from tracking.recording import Recording
from tracking.session import Session
from tracking.tracks import Run

if TYPE_CHECKING:
    from app.shell.close_prompts import Then
    from app.shell.main_window import MainWindow


class ResultStorage(Controller):
    """Puts a finished run into the open session, or into a new one that is on disk at once.

    Signals: `changed()`, something is held or let go.
    """

    def __init__(self, window: MainWindow, work: Work, parent: QObject) -> None:
        super().__init__(parent)
        self._window = window
        self._work = work
        self._run: Run | None = None
        self._waits = self._at_work = False
        work.changed.connect(self._go_on)

    @property
    def holds(self) -> bool:
        """Whether a run is in memory alone."""
        return self._run is not None

    @property
    def at_work(self) -> bool:
        """Whether it is being put on disk right now; that goes on though the window closes."""
        return self._at_work

    def keep(self, run: Run | None) -> None:
        """Keep what was tracked; None: nothing was."""
        if run is not None:
            self._run = run
            self.try_again()

    def drop(self) -> None:
        """Forget what is held."""
        self._run, self._waits = None, False
        self.changed.emit()

    def try_again(self, then: Then | None = None, path: Path | None = None) -> None:
        """Keep what is held, at a place or among the program's own files; `then` once it is."""
        controller, run = self._window.controller, self._run
        if controller is None or run is None:
            return
        if controller.document.session is not None:
            self._add(run)
        elif self._work.busy:
            self._waits = True
        else:
            document = controller.document
            work = partial(_kept, document.recording, run, path, document.colours_watched)
            title = tr("Keeping the result")
            self._at_work = True
            ended = partial(self._end, then=then)
            self._work.run(title, work, ended, self._stop, cancellable=False)

    def offer(self) -> None:
        """Say that something is held, and offer to try again."""
        self._tell(tr("The result is in memory only."))

    def _go_on(self) -> None:
        """Other work is done: keep what waited for that."""
        if self._waits and not self._work.busy:
            self._waits = False
            self.try_again()

    def _add(self, run: Run) -> None:
        controller = self._window.controller
        try:
            if controller is not None:
                controller.tracking.add_run(run)
            self.drop()
        except TrackwrightError as error:
            self._tell(_why(error))

    def _stop(self) -> None:
        self._at_work = False

    def _end(self, kept: Session | Exception, then: Then | None) -> None:
        self._stop()
        if isinstance(kept, Exception):
            self._tell(_why(kept))
            return
        self.drop()
        if self._window.controller is not None:
            self._window.controller.tracking.take_session(kept)
        if then is not None:
            then()

    def _tell(self, why: str) -> None:
        text = tr(
            "{why}\nNothing is lost while the window is open: make room and try again, or save it "
            "elsewhere with Save as.",
            why=why,
        )
        self._window.notice.say(text, tr("Try again"), self.try_again, is_error=True)
        self.changed.emit()


def _kept(
    recording: Recording,
    run: Run,
    path: Path | None,
    seen: TrackColours | None,
    report: Progress,
) -> Session | Exception:
    """The session, or why there is none: it is told together with what can be done.

    Raises:
        CancelledError: the window has closed meanwhile; the session is on disk, and given back.
    """
    try:
        kept = document_loader.keep_run(recording, run, path, seen)
    except (TrackwrightError, OSError) as error:
        return error
    try:
        report(1, 1)
    except CancelledError:
        kept.close()
        raise
    return kept


def _why(error: Exception) -> str:
    return tr("The result is not kept on disk: {why}", why=explain(error))
