"""What is painted in the background over the left picture: foreground, disparity, the ramp."""

from __future__ import annotations

import math
from dataclasses import dataclass

from PySide6.QtCore import QObject, Qt

from app.core.controller import Controller
from app.core.document.document import Document
from app.core.i18n import tr
from app.core.playback.playback import Playback
from app.core.tracks.frame_state import NO_OVERLAY, Kinds, PictureOverlay
from app.core.tracks.made_by import MadeBy
from app.features.pictures.overlay_maker import OverlayMaker
from app.features.pictures.overlays import OverlayPainter
from app.features.pictures.ramp_overlay import RampPainter
from tracking.errors import CalibrationError

_Painter = OverlayPainter | RampPainter
_CAPACITY_BYTES = 128 * 2**20
_AHEAD = 12
_LATE, _MOST_LEAD = 4, 8


@dataclass(frozen=True, slots=True)
class _AtWork:
    """A painter, what made the tracks whose settings it has, and what runs it."""

    run: MadeBy | None
    painter: _Painter
    maker: OverlayMaker


class OverlayController(Controller):
    """Says what lies over the frame that is shown; nothing is computed before it is asked for.

    `changed`: the overlay of the frame shown has come.
    """

    def __init__(self, document: Document, playback: Playback, parent: QObject) -> None:
        super().__init__(parent)
        self._document = document
        self._playback = playback
        self._at_work: dict[bool, _AtWork] = {}  # by whether it is the ramp
        self._left: list[OverlayMaker] = []  # whose settings are no longer those shown
        self._last = (-1, Kinds())

    def laid(self, kinds: Kinds) -> PictureOverlay:
        """What lies over the frame shown; it is asked for where it is not there yet."""
        frame = self._playback.frame
        at_work = self._at_work_on(kinds.ramp, frame.number) if kinds and frame else None
        if at_work is None or frame is None:
            return NO_OVERLAY
        painter, maker = at_work.painter, at_work.maker
        maker.request(frame, kinds, *self._ahead(maker))
        image = maker.get(frame.number, kinds)
        if image is not None:
            self._last = (frame.number, kinds)
        elif self._still_good(frame.number, kinds):
            image = maker.get(*self._last)
        waiting = image is None and not self._playback.clock.playing
        said = (
            tr("Working out the ramp...")
            if kinds.ramp
            else tr("Working out foreground and disparity...")
        )
        return PictureOverlay(image, painter.legend(kinds), said if waiting else "")

    def close(self) -> None:
        """End the threads."""
        for maker in (*self._left, *(each.maker for each in self._at_work.values())):
            maker.close()

    def _at_work_on(self, ramp: bool, frame: int) -> _AtWork | None:
        """A painter with the settings of what is shown in a frame; None where it cannot paint."""
        run = self._document.made_by(frame)
        known = self._at_work.get(ramp)
        if known is not None and _alike(known.run, run):
            return known
        begun = self._begin(ramp, run)
        if known is not None and begun is not None:
            known.maker.leave()
            self._left.append(known.maker)
            self._last = (-1, Kinds())
        return begun

    def _begin(self, ramp: bool, run: MadeBy | None) -> _AtWork | None:
        """Start a painter; None where none can paint this recording."""
        recording = self._document.recording
        try:
            painter = RampPainter(recording, run) if ramp else OverlayPainter(recording, run)
        except CalibrationError as error:
            self.failed.emit(error)
            return None
        maker = OverlayMaker(painter.paint, self._playback.at_hand, _CAPACITY_BYTES, self)
        maker.ready.connect(self._announce, Qt.ConnectionType.QueuedConnection)
        maker.failed.connect(self.failed, Qt.ConnectionType.QueuedConnection)
        self._at_work[ramp] = _AtWork(run, painter, maker)
        return self._at_work[ramp]

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


def _alike(one: MadeBy | None, other: MadeBy | None) -> bool:
    """Whether two were made by the same tracker with the same settings."""
    if one is None or other is None:
        return one is other
    return (one.tracker, dict(one.settings)) == (other.tracker, dict(other.settings))
