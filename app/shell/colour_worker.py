"""Colours of long or crowded sessions, made off the GUI thread."""

from __future__ import annotations

from PySide6.QtCore import QObject

from app.core.colours.track_colours import TrackColours
from app.core.controller import Controller
from app.core.document.document import Document
from app.core.i18n import tr
from app.core.jobs.latest_job import LatestJob, Work
from app.core.tracks.session_colours import PendingColours


class ColourWorker(Controller):
    """Makes the colours of the document's tracks where that takes long; old ones stay till then.

    `changed`: tracks have other colours by now. `failed`: they keep those they have.
    """

    def __init__(self, document: Document, parent: QObject) -> None:
        super().__init__(parent)
        self._document = document
        self._making = LatestJob(
            tr("Choosing colours of people"), _work_of, self, cancellable=False
        )
        self._making.found.connect(self._take)
        self._making.failed.connect(self._give_up)

    def look(self) -> None:
        """Begin where colours are due that nobody makes yet."""
        due = self._document.colours_due
        if due is None:
            self.close()
        else:
            self._making.ask(due)

    def close(self) -> None:
        """Make none any more; nobody waits for what is in work, which only reads."""
        self._making.stop()

    def _take(self, made: tuple[PendingColours, TrackColours]) -> None:
        if self._document.take_colours(*made):
            self.changed.emit()

    def _give_up(self, due: PendingColours, error: Exception) -> None:
        self._document.forget_colours(due)
        self.failed.emit(error)


def _work_of(due: PendingColours) -> Work:
    return lambda _: (due, due.make())
