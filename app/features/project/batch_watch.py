"""Batches at work in a project's folders: the one started here, and those of other programs."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import QTimer, Signal

from app.core.controller import Controller
from app.core.i18n import count_text, tr
from app.features.project.batch_process import BatchProcess, BatchWish
from tracking.batch.watch import WatchedBatch, WorkedOn, ask_to_stop, watch

_LOOK_EVERY_MS = 1000


class BatchWatch(Controller):
    """Starts a batch, and tells how far one is.

    Signals: `changed()`, one began, moved or ended; `ended(text)`, the one started here has.

    Attributes:
        watched: the batch at work; None: none is. out: its output folder.
    """

    ended = Signal(str)

    def __init__(self, parent: Controller) -> None:
        super().__init__(parent)
        self.watched: WatchedBatch | None = None
        self.out = Path()
        self._own: BatchProcess | None = None
        self._outs: tuple[Path, ...] = ()
        self._timer = QTimer(self, interval=_LOOK_EVERY_MS)
        self._timer.timeout.connect(self.look)

    @property
    def is_own(self) -> bool:
        """Whether a batch that was started here is at work."""
        return self._own is not None

    @property
    def works(self) -> dict[Path, WorkedOn]:
        """What workers do, by the recording."""
        return {} if self.watched is None else {one.path: one for one in self.watched.works}

    @property
    def left(self) -> frozenset[Path]:
        """Recordings that the batch has still to do, those in work too."""
        return frozenset() if self.watched is None else self.watched.left

    @property
    def text(self) -> str:
        """How far it is, in words."""
        batch = self.watched
        if batch is None or not batch.total:
            return tr("The batch starts...")
        words = tr("Batch: {ended} of {total} recordings", ended=batch.ended, total=batch.total)
        if batch.failed:
            words += ", " + count_text(batch.failed, "{n} failed", "{n} failed")
        return words

    @property
    def share(self) -> float | None:
        """How far it is, 0 to 1; None while it looks for what is left."""
        batch = self.watched
        if batch is None or not batch.total:
            return None
        return min(1.0, (batch.ended + sum(one.share or 0.0 for one in batch.works)) / batch.total)

    def follow(self, outs: Sequence[Path]) -> None:
        """Look into these output folders from now on."""
        self._outs = tuple(outs)
        if self._outs and not self._timer.isActive():
            self.look()
            self._timer.start()

    def start(self, wish: BatchWish) -> None:
        """Start a batch, where none that was started here is at work."""
        if self._own is not None:
            return
        try:
            self._own = BatchProcess(wish)
        except OSError as error:
            self.failed.emit(error)
            return
        self._timer.start()
        self.look()

    def cancel(self) -> None:
        """End the batch that is shown; what is done stays."""
        if self._own is not None:
            self._own.stop()
            return
        try:
            ask_to_stop(self.out)
        except OSError as error:
            self.failed.emit(error)

    def look(self) -> None:
        """See how far batches are."""
        before = self.watched, self.out
        self.watched = None
        own = () if self._own is None else (self._own.wish.out,)
        for out in (*own, *self._outs):
            found = watch(out)
            if found is not None:
                self.watched, self.out = found, out
                break
        if self._own is not None:
            if self._own.status is not None:
                self._end()
            elif self.watched is None:  # it is about to begin
                self.watched, self.out = WatchedBatch(), self._own.wish.out
        if (self.watched, self.out) != before:
            self.changed.emit()
        if not (self._own or self._outs):
            self._timer.stop()

    def _end(self) -> None:
        own, self._own = self._own, None
        if own is not None:
            told = own.told()
            own.close()
            self.ended.emit(told)

    def close(self) -> None:
        """The window closes; a batch at work goes on by itself."""
        self._timer.stop()
        self._outs, self.watched = (), None
        if self._own is not None:
            self._own.close()
            self._own = None
