"""Looking for parts that are worth labelling, off the GUI thread."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from PySide6.QtCore import QObject, Signal

from app.core.colours.palette import NOBODY
from app.core.document.detector_choice import DetectorChoice
from app.core.document.document import Document
from app.core.error_messages import explain
from app.core.i18n import time_text, tr
from app.core.jobs.jobs import Job, Progress
from app.core.keymap import in_brackets, key_or_title
from app.core.scenes.labels import SuggestedPart, Tool
from app.core.scenes.part_names import no_parts, part_name
from app.features.labelling.scene import LabellingScene
from app.features.labelling.suggestion_list import SuggestionQueue
from tracking.errors import EditError
from tracking.failure import Suggestion, suggest
from tracking.progress import Progress as Reporter
from tracking.progress import no_progress
from tracking.session.provenance import parts_by_now
from tracking.tracks import Labels, Run, TrackTable
from tracking.translation import msg


class SuggestionSearch(QObject):
    """Finds suggestions of the open session, once they are asked for.

    Signals: `changed()`, others were found.

    Attributes:
        queue: what was found. asked: whether anybody asked.
    """

    changed = Signal()

    def __init__(self, document: Document, parent: QObject) -> None:
        super().__init__(parent)
        self.queue = SuggestionQueue()
        self.asked = False
        self._document = document
        self._job: Job | None = None
        self._problem = ""

    def look(self) -> None:
        """Look for suggestions in the tracks as they are now."""
        session = self._document.session
        self.stop()
        if session is None:
            return
        self.asked = True
        table, labels, run = session.tracks.snapshot(), session.labels, session.corrected_run
        fps, detector = self._document.recording.fps, self._document.detector

        def work(report: Progress) -> tuple[SuggestedPart, ...]:
            return suggestions_for(table, run, labels, fps, detector, report)

        self._job = Job(tr("Looking for parts to label"), work, self)
        self._job.done.connect(self._take)
        self._job.failed.connect(lambda error: self._tell(explain(error)))
        self._job.cancelled.connect(lambda: self._tell(_cancelled()))
        self._job.start()

    def stop(self) -> None:
        """Ask for none any more; the thread has ended then."""
        self.asked, self._problem = False, ""
        self.queue = SuggestionQueue()
        if self._job is not None:
            job, self._job = self._job, None
            job.end_untold()

    def shown(self, scene: LabellingScene) -> LabellingScene:
        """The panel's scene with the suggestions, where they are asked for."""
        session = self._document.session
        if not self.asked or scene.tool is not Tool.PARTS or session is None:
            return scene
        self.queue.take_labels(session.labels.parts)
        found, place = self.queue.open, self.queue.place
        return replace(scene, suggestions=found, current=place, doing=self._doing())

    def _doing(self) -> str:
        if self._job is not None:
            return tr("Looking where the part-failure detector is least sure...")
        if self._problem or self.queue.open:
            return self._problem
        return tr(
            "No suggestions are left: train the part-failure detector{key} with the "
            "labels, and track again with it.",
            key=in_brackets("detector.train"),
        )

    def _take(self, found: tuple[SuggestedPart, ...]) -> None:
        self._drop()
        session = self._document.session
        if session is not None:
            self.queue.take(self._coloured(found), session.labels.parts)
        self.changed.emit()

    def colour_anew(self) -> None:
        """Tracks have other colours by now."""
        self.queue.replace_each(self._coloured)

    def _coloured(self, found: Iterable[SuggestedPart]) -> list[SuggestedPart]:
        colour_of = self._document.colour_of
        return [replace(one, colour=colour_of(one.key[1])) for one in found]

    def _tell(self, problem: str) -> None:
        self._drop()
        self._problem = problem
        self.changed.emit()

    def _drop(self) -> None:
        if self._job is not None:
            self._job.deleteLater()
            self._job = None


def _cancelled() -> str:
    again = key_or_title("detector.suggest")
    return tr("Cancelled; {suggest} looks again", suggest=again)


def suggestions_for(
    table: TrackTable,
    run: Run | None,
    labels: Labels,
    fps: float,
    choice: DetectorChoice,
    report: Reporter = no_progress,
) -> tuple[SuggestedPart, ...]:
    """The parts nearest to the detector's operating point, the nearest first, in no colour yet.

    On any thread: it reads nothing that may change meanwhile.
    Raises EditError where no parts were tracked, FormatError where the detector is gone,
    CancelledError by `report`.
    """
    if run is None or not len(run.parts["frame"]):
        raise EditError(no_parts())
    parts = parts_by_now(table, run, table.track_ids)
    found = suggest(parts, fps, choice.load(), labels.parts, report=report)
    return tuple(_suggested(one, labels, fps, choice.name_in_text) for one in found)


def _suggested(one: Suggestion, labels: Labels, fps: float, scored_by: str) -> SuggestedPart:
    return SuggestedPart(
        key=one.key,
        reason=msg(
            "unsure: score {score} of {detector}", score=f"{one.score:+z.2f}", detector=scored_by
        ),
        title=part_name(one.part),
        label=labels.title(one.track),
        colour=NOBODY,
        when=time_text(one.frame / fps),
    )
