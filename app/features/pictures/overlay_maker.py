"""Painting what is laid over the picture, off the GUI thread."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, Signal

from app.core.tracks.frame_state import Kinds
from tracking.recording import StereoFrame

Rgba = NDArray[np.uint8]
Paint = Callable[[StereoFrame, Kinds], Rgba]
AtHand = Callable[[int], StereoFrame | None]

_LOOK_AGAIN_S = 0.02


@dataclass(frozen=True, slots=True)
class _Request:
    frame: StereoFrame
    kinds: Kinds
    ahead: int
    lead: int


class OverlayMaker(QObject):
    """Paints overlays in a thread: the newest request first, then those of frames that come next.

    `ready(frame)` says that `get` has the overlay of a frame that was asked for. After
    `failed(error)` nothing more is painted. `paint_s` is how long the last one took.

    Args:
        paint: (frame, kinds) -> RGBA, called in the thread alone.
        at_hand: the frame of a number where it can be had without waiting.
        capacity_bytes: how much the overlays that are kept may take together.
    """

    ready = Signal(int)
    failed = Signal(object)

    def __init__(self, paint: Paint, at_hand: AtHand, capacity_bytes: int, parent: QObject) -> None:
        super().__init__(parent)
        self._paint = paint
        self._at_hand = at_hand
        self._capacity_bytes = capacity_bytes
        self.paint_s = 0.0
        self._made: dict[tuple[int, Kinds], Rgba] = {}
        self._wanted: _Request | None = None
        self._right_lag: int | None = 0
        self._closed = False
        self._changed = threading.Condition()
        self._thread = threading.Thread(target=self._run, name="overlays", daemon=True)
        self._thread.start()

    def get(self, frame: int, kinds: Kinds) -> Rgba | None:
        """The overlay of a frame, the same array each time; None where it is not painted yet."""
        with self._changed:
            return self._made.get((frame, kinds))

    def request(self, frame: StereoFrame, kinds: Kinds, ahead: int = 0, lead: int = 0) -> None:
        """Ask for a frame's overlay; it replaces what was asked before.

        Args:
            ahead: how many frames after it (negative: before it) are painted next.
            lead: while it plays, how many frames are left out at first: they would come late.
        """
        with self._changed:
            if not self._is_paired(frame):  # a late camera was found: what was made of it is wrong
                self._right_lag = frame.right_lag
                self._made.clear()
            self._wanted = _Request(frame, kinds, ahead, lead)
            self._changed.notify()

    def leave(self) -> None:
        """Let the thread end after what it is at; nothing more is told. `close` waits for it."""
        for told in (self.ready, self.failed):
            told.disconnect()
        with self._changed:
            self._closed = True
            self._changed.notify()

    def close(self) -> None:
        """End the thread and wait for it."""
        with self._changed:
            self._closed = True
            self._changed.notify()
        self._thread.join()

    def _run(self) -> None:
        while (task := self._next()) is not None:
            request, frame = task
            began_s = time.monotonic()
            try:
                painted = self._paint(frame, request.kinds)
            except Exception as error:  # a bug too: the window says so
                self.failed.emit(error)
                return
            self.paint_s = time.monotonic() - began_s
            self._keep(frame, request.kinds, painted)
            if frame is request.frame:
                self.ready.emit(frame.number)

    def _next(self) -> tuple[_Request, StereoFrame] | None:
        """What to paint now, waited for; None at the end."""
        with self._changed:
            while not self._closed:
                request = self._wanted
                if request is not None:
                    frame = self._first_missing(request)
                    if frame is not None:
                        return request, frame
                looking_ahead = request is not None and request.ahead
                self._changed.wait(_LOOK_AGAIN_S if looking_ahead else None)
            return None

    def _first_missing(self, request: _Request) -> StereoFrame | None:
        """The nearest frame of a request without its overlay, of those at hand."""
        asked = (request.frame.number, request.kinds) not in self._made
        if asked and not request.lead:
            return request.frame
        step = 1 if request.ahead > 0 else -1
        for distance in range(max(1, request.lead), abs(request.ahead) + 1):
            number = request.frame.number + step * distance
            if (number, request.kinds) in self._made:
                continue
            if (frame := self._at_hand(number)) is not None:
                return frame
        return request.frame if asked else None

    def _is_paired(self, frame: StereoFrame) -> bool:
        """Whether a frame's cameras are paired like those of the others."""
        return frame.right_lag is None or frame.right_lag == self._right_lag

    def _keep(self, frame: StereoFrame, kinds: Kinds, painted: Rgba) -> None:
        with self._changed:
            if not self._is_paired(frame):
                return
            self._made[frame.number, kinds] = painted
            most = max(2, self._capacity_bytes // max(painted.nbytes, 1))
            while len(self._made) > most:
                del self._made[next(iter(self._made))]
