"""Makes the scenes of the review panel."""

from __future__ import annotations

from app.core.document.document import Document
from app.core.editing.review_target import find_first_frame
from app.core.i18n import joined_text, span_text, tr
from app.core.scenes.review_words import COUNTED
from app.features.review.no_items import empty_words, waiting_words
from app.features.review.presenter import ReviewQueue
from app.features.review.progress_words import progress_text
from app.features.review.review_meter import MeterWords
from app.features.review.review_search import ReviewSearch
from app.features.review.scene import ReviewScene
from app.features.review.watched_ranges import WatchedRanges
from tracking.review import ReviewItem
from tracking.session import Session


class SceneMaker:
    """Makes the scene of the review panel from a document and its queue."""

    def __init__(
        self, document: Document, queue: ReviewQueue, search: ReviewSearch, watching: WatchedRanges
    ) -> None:
        self._document, self._queue = document, queue
        self._search, self._watching = search, watching
        self._meter: MeterWords | None = None

    def begin(self, session: Session) -> None:
        """Another session: what was done is counted from here."""
        self._meter = MeterWords(session.labels, session.history)

    def start_of(self, review_item: ReviewItem) -> int:
        """Where watching it starts: just before it, with its people in sight."""
        session = self._document.session
        return (
            review_item.start if session is None else find_first_frame(review_item, session.tracks)
        )

    def scene(self, *, hidden: bool, waits: bool, plays: bool) -> ReviewScene:
        """The queue as it stands.

        Args:
            hidden: a tracker's tracks are shown, not the session's. waits: nothing was looked for.
            plays: a stretch is played as soon as it is jumped to.
        """
        queue, current = self._queue, self._queue.current
        title, text = self._empty_words(hidden, waits)
        if hidden:
            return ReviewScene(order=queue.order, plays=plays, title=title, text=text)
        return ReviewScene(
            items=queue.items,
            current=queue.place,
            left=len(queue.open),
            kinds=queue.kinds(),
            kind=queue.kind,
            order=queue.order,
            plays=plays,
            also=self._also(current) if current is not None else "",
            learned=queue.learned_text(),
            all_learned="\n".join(queue.learned_texts()),
            doing=self._search.doing,
            title=title,
            text=text,
            meter=self._meter_text(waits),
            counted=tr(COUNTED),
            waits=waits,
        )

    def _also(self, review_item: ReviewItem) -> str:
        """What there is to watch, from a little before, and further reasons."""
        fps = self._document.recording.fps
        span = span_text(self.start_of(review_item) / fps, (review_item.end - 1) / fps)
        return joined_text("; ", (tr("Watch {span}", span=span), *review_item.others))

    def _meter_text(self, waits: bool) -> str:
        session = self._document.session
        if session is None or self._meter is None:
            return ""
        done = self._meter.text(session.labels, session.history, self._watching.minutes)
        told = self._queue.is_searched and not waits
        so_far = progress_text(self._queue.state) if told else ""
        return "\n".join(line for line in (so_far, done, self._search.measures) if line)

    def _empty_words(self, hidden: bool, waits: bool) -> tuple[str, str]:
        """What is said where nothing is listed."""
        session = self._document.session
        if session is not None and waits:
            return waiting_words(session)
        if self._search.doing:
            return "", ""
        known = None if self._document.is_untouched else session
        return empty_words(known, live=hidden, problem=self._search.problem)
