"""Colours of long sessions, made off the GUI thread."""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal

from app.background import Job, Progress
from app.presenters.document.document import Document
from app.presenters.document.showing import Colours
from app.presenters.track_colours import TrackColours


class Colouring(QObject):
    """Makes the colours of the document's tracks where that takes long; old ones stay till then.

    Signals: `changed()`, tracks have other colours by now.
    """

    changed = Signal()

    def __init__(self, document: Document, parent: QObject) -> None:
        super().__init__(parent)
        self._document = document
        self._making: Colours | None = None
        self._job: Job | None = None

    def look(self) -> None:
        """Begin where colours are due that nobody makes yet."""
        due = self._document.colours_due
        if due is self._making:
            return
        self.close()
        if due is None:
            return
        make = due.make

        def work(_: Progress) -> TrackColours:
            return make()

        self._making, self._job = due, Job("colours of tracks", work, self)
        self._job.done.connect(self._take)
        self._job.start()

    def close(self) -> None:
        """Make none any more; the thread has ended then."""
        self._making = None
        if self._job is not None:
            job, self._job = self._job, None
            job.blockSignals(True)
            job.wait()
            job.deleteLater()

    def _take(self, colours: TrackColours) -> None:
        making = self._making
        self.close()
        if making is not None and self._document.take_colours(making, colours):
            self.changed.emit()
