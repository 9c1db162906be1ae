"""Foreground and disparity over the left picture: painted in the background, shown when due."""

from __future__ import annotations

import math

from PySide6.QtCore import QObject, Qt, Signal

from app.background import OverlayMaker
from app.presenters.document.document import Document
from app.presenters.document.setting import NOTHING_LAID, Laid
from app.presenters.pictures.overlays import Kinds, OverlayPainter
from app.presenters.words import tr
from app.views.playing.playback import Playback
from tracking.errors import CalibrationError

_CAPACITY_BYTES = 128 * 2**20
_AHEAD = 12
_LATE, _MOST_LEAD = 4, 8


class Overlaying(QObject):
    """Says what lies over the frame that is shown; nothing is computed before it is asked for.

    Signals: `changed()`, the overlay of the frame shown has come; `failed(error)`, there is none.
    """

    changed = Signal()
    failed = Signal(object)

    def __init__(self, document: Document, playback: Playback, parent: QObject) -> None:
        super().__init__(parent)
        self._document = document
        self._playback = playback
        self._at_work: tuple[OverlayPainter, OverlayMaker] | None = None
        self._last = (-1, Kinds())

    def laid(self, kinds: Kinds) -> Laid:
        """What lies over the frame shown; it is asked for where it is not there yet."""
        frame = self._playback.frame
        at_work = self._begin() if kinds and frame is not None else None
        if at_work is None or frame is None:
            return NOTHING_LAID
        painter, maker = at_work
        maker.request(frame, kinds, *self._ahead(maker))
        image = maker.made(frame.number, kinds)
        if image is not None:
            self._last = (frame.number, kinds)
        elif self._still_good(frame.number, kinds):
            image = maker.made(*self._last)
        waiting = image is None and not self._playback.clock.playing
        said = tr("Working out foreground and disparity...") if waiting else ""
        return Laid(image, painter.legend(kinds), said)

    def close(self) -> None:
        """End the thread."""
        if self._at_work is not None:
            self._at_work[1].close()

    def _begin(self) -> tuple[OverlayPainter, OverlayMaker] | None:
        """Start the painter at its first use; None where it cannot paint this recording."""
        if self._at_work is not None:
            return self._at_work
        session = self._document.session
        run = session.corrected_run if session is not None else None
        try:
            painter = OverlayPainter(self._document.recording, run)
        except CalibrationError as error:
            self.failed.emit(error)
            return None
        maker = OverlayMaker(painter.paint, self._playback.at_hand, _CAPACITY_BYTES, self)
        maker.ready.connect(self._announce, Qt.ConnectionType.QueuedConnection)
        maker.failed.connect(self.failed, Qt.ConnectionType.QueuedConnection)
        self._at_work = (painter, maker)
        return self._at_work

    def _announce(self, frame: int) -> None:
        if frame == self._playback.number:
            self.changed.emit()

    def _ahead(self, maker: OverlayMaker) -> tuple[int, int]:
        """How many frames are painted ahead, and how many of them are passed over."""
        clock = self._playback.clock
        if not clock.playing:
            return 0, 0
        lead = min(_MOST_LEAD, math.ceil(maker.paint_s * clock.fps * abs(clock.rate)))
        return (_AHEAD if clock.rate > 0 else -_AHEAD), lead

    def _still_good(self, frame: int, kinds: Kinds) -> bool:
        """While it plays, an overlay some frames late is better than one that flickers."""
        number, of = self._last
        return self._playback.clock.playing and of == kinds and abs(frame - number) <= _LATE
