"""Makes the small pictures of the current review item off the GUI thread."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, Signal

from app.core.document.document import Document
from app.core.jobs.jobs import Job
from app.core.jobs.latest_job import LatestJob
from app.core.playback.playback import Playback
from app.features.review.strip import StripAsk, StripScene, prepare_strip, strip_frames
from tracking.errors import CancelledError
from tracking.progress import Progress
from tracking.review import ReviewItem


class StripSearch(QObject):
    """Signals: `made(scene)`, the pictures of the item asked for last, or none."""

    made = Signal(object)

    def __init__(
        self,
        document: Document,
        playback: Playback,
        name_of: Callable[[int], str],
        parent: QObject,
    ) -> None:
        """name_of: gives a track's number and name."""
        super().__init__(parent)
        self._document, self._playback, self._name_of = document, playback, name_of
        self._asked: StripAsk | None = None
        self._job = LatestJob("review_pictures", self._prepare, self, listed=False)
        self._job.found.connect(self._take)
        self._job.failed.connect(self._miss)

    @property
    def busy(self) -> bool:
        """Whether pictures are being made."""
        return self._job.busy

    def show(self, item: ReviewItem | None) -> None:
        """Make the pictures of an item; None: there are none."""
        asked = self._ask_of(item) if item is not None else None
        if asked == self._asked:
            return
        self._asked = asked
        if asked is None:
            self._job.stop()
            self.made.emit(StripScene())
        else:
            self._job.ask(asked)

    def close(self) -> None:
        """Make no more of them, and wait: the recording may be closed then."""
        self._asked = None
        self._job.stop()
        for job in self._job.findChildren(Job):
            job.wait()
        self.made.emit(StripScene())

    def _ask_of(self, item: ReviewItem) -> StripAsk | None:
        document = self._document
        session, recording = document.session, document.recording
        if session is None:
            return None
        return StripAsk(
            tracks=item.tracks,
            frames=strip_frames(item, recording.fps, recording.frame_count),
            revision=session.tracks.revision,
            fps=recording.fps,
            labels=tuple(map(self._name_of, item.tracks)),
            colours=tuple(document.colour_of(track) for track in item.tracks),
        )

    def _prepare(self, asked: Any) -> Callable[[Progress], StripScene]:
        session = self._document.session
        assert session is not None
        return prepare_strip(asked, session.tracks, self._read)

    def _read(self, frame: int) -> NDArray[np.uint8]:
        """The left picture; asked on the thread of the job."""
        kept = self._playback.at_hand(frame)
        return kept.left if kept is not None else self._document.recording.read(frame).left

    def _take(self, scene: StripScene) -> None:
        if self._asked is not None and not self._job.busy:
            self.made.emit(scene)

    def _miss(self, _asked: object, error: Exception) -> None:
        """A frame that cannot be read is told of where it is shown large."""
        if not isinstance(error, CancelledError):
            self.made.emit(StripScene())
