"""Small pictures of any frame, decoded in a thread of their own and kept."""

from __future__ import annotations

import logging
import threading
from contextlib import closing

import cv2
import numpy as np
from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QImage

from tracking.errors import TrackwrightError
from tracking.recording import Recording

_log = logging.getLogger(__name__)
WIDTH_PX, HIGHEST_PX = 176, 132
MOST_KEPT = 240
"""About 20 MB. Of a recording there are no more different ones: frames close together share one."""


class Thumbnails(QObject):
    """Gives small pictures of the left camera; the newest request wins.

    They are read with decoders of their own: those that play stay where they are. A frame that
    cannot be read has none.

    Signals: `ready(frame, image)`, the `QImage` of what was asked for last.
    """

    ready = Signal(int, object)

    def __init__(self, recording: Recording, parent: QObject) -> None:
        super().__init__(parent)
        self._recording = recording
        self._step = max(1, -(-recording.frame_count // MOST_KEPT))
        self._kept: dict[int, QImage] = {}
        self._wanted: int | None = None
        self._closed, self._changed = False, threading.Condition()
        self._thread: threading.Thread | None = None

    def get(self, frame: int) -> QImage | None:
        """The picture near a frame where it is there; else it is asked for."""
        number = self._near(frame)
        with self._changed:
            image = self._kept.get(number)
            self._wanted = None if image is not None else number
            if image is None:
                self._begin()
                self._changed.notify()
        return image

    def close(self) -> None:
        """End the thread and wait for it."""
        with self._changed:
            self._closed = True
            self._changed.notify()
        if self._thread is not None:
            self._thread.join()

    def _near(self, frame: int) -> int:
        """The frame whose picture stands for it: the middle one of those that share it."""
        middle = frame // self._step * self._step + self._step // 2
        return min(max(0, middle), max(0, self._recording.frame_count - 1))

    def _begin(self) -> None:
        if self._thread is None and not self._closed:
            self._thread = threading.Thread(target=self._run, name="thumbnails", daemon=True)
            self._thread.start()

    def _run(self) -> None:
        while (number := self._next()) is not None:
            image = self._read(number)
            with self._changed:
                self._kept[number] = image
                while len(self._kept) > MOST_KEPT:
                    del self._kept[next(iter(self._kept))]
                told = self._wanted == number and not self._closed
                if told:
                    self._wanted = None
            if told:
                self.ready.emit(number, image)

    def _next(self) -> int | None:
        """What to read now, waited for; None at the end."""
        with self._changed:
            while not self._closed:
                if self._wanted is not None and self._wanted not in self._kept:
                    return self._wanted
                self._changed.wait()
        return None

    def _read(self, number: int) -> QImage:
        try:
            with closing(self._recording.frames(number, number + 1)) as frames:
                return _small(next(frames).left)
        except (TrackwrightError, StopIteration):
            _log.info("no thumbnail of frame %d", number, exc_info=True)
            return QImage()


def _small(picture: np.ndarray) -> QImage:
    """As large as fits, in pixels of its own."""
    high, wide = picture.shape[:2]
    scale = min(WIDTH_PX / wide, HIGHEST_PX / high, 1.0)
    size = max(1, round(scale * wide)), max(1, round(scale * high))
    small = np.ascontiguousarray(cv2.resize(picture, size, interpolation=cv2.INTER_AREA))
    return QImage(small.data, size[0], size[1], 3 * size[0], QImage.Format.Format_BGR888).copy()
