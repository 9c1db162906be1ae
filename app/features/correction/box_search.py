"""Boxes of a frame that no track has: those of the runs, of networks, of a file of detections."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from PySide6.QtCore import QObject, Qt, Signal

from app.core.document.document import Document
from app.core.editing.suggested_boxes import FoundBoxes, unclaimed
from app.core.i18n import tr
from app.core.jobs.latest_job import LatestJob
from app.core.tracks.track_reader import TrackReader
from tracking.arrays import Floats
from tracking.detections import (
    DetectionSettings,
    RecordingDetections,
    files_beside,
    load_detections,
    outside,
)
from tracking.progress import Progress
from tracking.tracks import Run
from tracking.tracks.columns import boxes_of

_FILE = "detections.file"


class BoxSearch(QObject):
    """Reads a file of detections in the background, once; the rest is at hand.

    Signals: `found()`, there may be more boxes. `failed(object)`: why the file cannot be read.
    """

    found = Signal()
    failed = Signal(object)

    def __init__(self, document: Document, parent: QObject) -> None:
        super().__init__(parent)
        self._document = document
        self._read: RecordingDetections | None = None
        self._looked_for: Run | None = None
        self._name: str | None = None
        self._job = LatestJob(tr("Reading suggested boxes"), self._prepare, self, cancellable=False)
        self._job.found.connect(self._take)
        self._job.failed.connect(lambda _, error: self.failed.emit(error))
        self._job.changed.connect(self.found, Qt.ConnectionType.QueuedConnection)

    @property
    def busy(self) -> bool:
        """Whether the file is being read."""
        return self._job.busy

    def close(self) -> None:
        """End the thread."""
        self._job.stop()

    def boxes(self, frame: int, tracks: TrackReader) -> FoundBoxes:
        """The boxes of the left camera in a frame that none of these tracks has."""
        name = self._file()
        if name:
            self._job.ask(name)
        return unclaimed(self._sources(frame, tracks), boxes_of(tracks.of_frame(frame)))

    def _sources(self, frame: int, tracks: TrackReader) -> Iterator[Floats]:
        """What was measured before what a tracker made of it."""
        if self._read is not None:
            yield self._read.of(frame).box
        rows = tracks.network_boxes(frame)
        yield boxes_of(rows, rows["camera"] == 0)
        run = self._run
        if run is not None:
            low, high = run.tracks["frame"].searchsorted((frame, frame + 1))
            yield boxes_of(run.tracks, slice(int(low), int(high)))

    @property
    def _run(self) -> Run | None:
        session = self._document.session
        return session.corrected_run if session is not None else None

    def _file(self) -> str:
        """Where detections are, looked for once a run: frames are drawn too often for the disk."""
        run = self._run
        if self._name is None or run is not self._looked_for:
            self._looked_for, self._name = run, self._find_file(run)
        return self._name

    def _find_file(self, run: Run | None) -> str:
        """That of the run, unless only the session says it lies elsewhere, else one beside."""
        settings = dict(run.settings) if run is not None else {}
        named = str(settings.get(_FILE, ""))
        if named and not outside(settings):
            return named
        return next(iter(files_beside(self._document.recording)), "")

    def _prepare(self, name: str) -> Callable[[Progress], RecordingDetections | None]:
        recording = self._document.recording
        return lambda _: load_detections(recording, DetectionSettings(file=name))

    def _take(self, read: RecordingDetections | None) -> None:
        self._read = read
