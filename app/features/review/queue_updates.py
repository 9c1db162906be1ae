"""Updates of the review queue: it is searched for anew as the tracks of the document change."""

from __future__ import annotations

from collections.abc import Set
from dataclasses import dataclass

from PySide6.QtCore import QObject, Signal

from app.core.document.document import Document
from app.features.review.edited_items import EditedItems
from app.features.review.presenter import ReviewQueue
from app.features.review.review_search import ReviewSearch, Subject
from tracking.review import ReviewFinding, ReviewItemKey
from tracking.session import Session
from tracking.session.hand_made import is_hand_made
from tracking.tracks import Labels, Occluder


@dataclass(frozen=True, slots=True)
class _Searched:
    """The tracks of a session that were searched; run: the one they began as."""

    session: Session | None = None
    revision: int = 0
    run: int | None = None
    occluders: tuple[Occluder, ...] = ()


class QueueUpdates(QObject):
    """Keeps the review queue of a document up to date.

    Signals: `begun(session)`, another session is followed; `taken()`, the queue was filled anew.

    Attributes:
        search: finds the items in the background.
    """

    begun = Signal(object)
    taken = Signal()

    def __init__(self, document: Document, queue: ReviewQueue, parent: QObject) -> None:
        super().__init__(parent)
        self.search = ReviewSearch(self._subject, document.recording, self)
        self.search.found.connect(self._take)
        self._document, self._queue = document, queue
        self._searched = _Searched()
        self._labels: Labels | None = None
        self._edited = EditedItems()
        self._hand_made = False

    @property
    def waits(self) -> bool:
        """No tracker made the tracks: nothing is flagged in them until somebody asks."""
        return self._hand_made and not self.search.hand_made and not self._document.is_live

    def follow(self) -> Set[ReviewItemKey]:
        """Follow the document; the items whose decisions or edits were undone since."""
        session = self._document.session
        if session is None or session.is_untouched:
            self._forget()
            return frozenset()
        if self._document.is_live:
            return frozenset()
        first = session is not self._searched.session
        self._follow_tracks(session)
        undone = self._follow_labels(session, first=first)
        self._queue.take_names({track: of.name for track, of in session.labels.tracks.items()})
        return undone

    def flag_hand_made(self, flags: bool) -> None:
        """Flag also what people drew, corrected or imported as labels; or no more."""
        session = self._document.session
        if session is None or self._document.is_live:
            return
        self.search.hand_made = flags
        if self.waits:
            self.search.stop()
            self._queue.take(ReviewFinding(), session.labels)
        else:
            self.search.look(at_once=True)
        self.taken.emit()

    def _forget(self) -> None:
        self.search.stop()
        self._searched, self._labels = _Searched(), None
        self._hand_made = False
        self._queue.forget()

    def _follow_tracks(self, session: Session) -> None:
        """Search again where tracks are others than those that were searched."""
        before = self._searched
        occluders = session.labels.occluders
        now = _Searched(session, session.tracks.revision, session.adopted_run, occluders)
        if now == before:
            return
        self._searched = now
        if session is not before.session:
            self.begun.emit(session)
        anew = (session, now.run) != (before.session, before.run)
        if anew:
            self._queue.forget()  # the same ids are other people
            self._hand_made = is_hand_made(session.corrected_run)
            self.search.hand_made = False
        if not self.waits:
            self.search.look(at_once=anew)

    def _follow_labels(self, session: Session, *, first: bool) -> Set[ReviewItemKey]:
        """Take decisions; the items of decisions and corrections that were undone.

        first: the session is another one, whose earlier edits count for nothing here.
        """
        before, self._labels = self._labels, session.labels
        if session.labels is not before:
            self._queue.take_labels(session.labels)
        if first or before is None:
            self._edited.begin(session.history)
            return frozenset()
        key = self._queue.current_key
        item = self._edited.follow(session.history, key, self._document.edited)
        undecided = before.verdicts.keys() - session.labels.verdicts.keys()
        if item is not None and (item in undecided or not undecided):
            return {item}  # also of many that were decided at once
        return undecided

    def _subject(self) -> Subject:
        session = self._document.session
        assert session is not None
        return session.tracks.snapshot(), session.corrected_run, session.labels

    def _take(self, finding: ReviewFinding) -> None:
        session = self._document.session
        if session is not None:
            self._queue.take(finding, session.labels, session.tracks)
            self.taken.emit()
