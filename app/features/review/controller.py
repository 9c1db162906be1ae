"""Reviewing the open recording: review items walked, watched, decided and put right."""

from __future__ import annotations

from collections.abc import Callable, Sequence, Set
from dataclasses import dataclass

from PySide6.QtCore import QObject, Signal

from app.core.controller import Controller
from app.core.document.document import Document
from app.core.editing.edits import edit_named
from app.core.i18n import count_text, tr
from app.core.playback.playback import Playback
from app.core.projection.concern import Concern
from app.features.review.alike import AlikeGroup, groups_alike, plan_decisions
from app.features.review.alike_dialog import open_alike_dialog
from app.features.review.panel import ReviewPanel
from app.features.review.presenter import (
    QueuePlace,
    ReviewQueue,
    is_fixable,
    plan_review_verdict,
    settles,
    with_fixed_verdict,
)
from app.features.review.queue_updates import QueueUpdates
from app.features.review.scene import Order, ReviewScene
from app.features.review.scene_maker import SceneMaker
from app.features.review.stretch_playback import StretchPlayback
from app.features.review.strip_search import StripSearch
from app.features.review.watched_ranges import WatchedRanges
from tracking.editing import Change, plan_mark_reviewed, plan_unmark_reviewed
from tracking.errors import TrackwrightError
from tracking.review import ReviewItem, ReviewItemKey
from tracking.tracks import Labels


@dataclass(frozen=True, slots=True)
class ReviewStanding:
    """Where somebody is in a review, and how it is done."""

    queue: QueuePlace
    plays: bool
    measures: bool
    flags_hand_made: bool


class ReviewController(Controller):
    """The review queue of a document on its panel.

    `changed`: what commands can do is another. Signals: `edited()`, the labels or what is selected
    are others than before; `concerned(concern)`, people are looked at, None for nobody any more;
    `fix_asked(kind)`, an edit of who is selected is to be begun.
    """

    edited = Signal()
    concerned = Signal(object)
    fix_asked = Signal(object)

    def __init__(
        self,
        document: Document,
        playback: Playback,
        panel: ReviewPanel,
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        recording = document.recording
        self.queue = ReviewQueue(recording.fps, document.colour_of)
        self.watching = WatchedRanges(recording.frame_count, recording.fps)
        self.plays = False
        self._document, self._playback = document, playback
        self._panel = panel
        document.correcting.item_looked_at = lambda: self.queue.current
        document.settle = self._settle
        self._updates = QueueUpdates(document, self.queue, self)
        self._search = self._updates.search
        self._strip = StripSearch(document, playback, self.queue.name_of, self)
        self._scenes = SceneMaker(document, self.queue, self._search, self.watching)
        self._marked: tuple[ReviewItem, ...] | None = None
        self._stretch = StretchPlayback(playback, self)
        self._fixing: ReviewItem | None = None
        self._connect()

    def _connect(self) -> None:
        self._strip.made.connect(self._panel.strip.show_scene)
        self._updates.begun.connect(self._scenes.begin)
        self._updates.taken.connect(self._take)
        self._search.failed.connect(self._tell_problem)
        self._search.changed.connect(self._show)
        self._playback.shown.connect(self._watch)
        self._panel.item_chosen.connect(self.go_to)
        self._panel.kind_chosen.connect(self.narrow)
        self._panel.order_chosen.connect(self._sort_by)
        self._panel.playing_chosen.connect(self.set_plays)
        self._panel.search_asked.connect(self.look_through)

    def close(self) -> None:
        """Look no further, and leave the panel empty."""
        self._search.blockSignals(True)
        self._search.stop()
        self._strip.close()
        self._panel.show_scene(ReviewScene())

    # what there is to look at

    def refresh(self) -> None:
        """Follow the document: look again where its tracks are others, list what is left."""
        self._follow_fix()
        self._return_to(self._updates.follow())
        if self._document.is_untouched:
            self._stretch.forget()
        self._show()

    @property
    def busy(self) -> bool:
        """Whether review items are being looked for."""
        return self._search.busy

    @property
    def waits(self) -> bool:
        """No tracker made the tracks: nothing is flagged in them until somebody asks."""
        return self._updates.waits

    @property
    def flags_hand_made(self) -> bool:
        """Whether what people made is flagged, too."""
        return self._search.hand_made

    def look_through(self) -> None:
        """Look for what may be wrong also in tracks that no tracker made."""
        if self.waits:
            self.flag_hand_made(True)

    def flag_hand_made(self, flags: bool) -> None:
        """Flag also what people drew, corrected or imported as labels; or no more."""
        self._updates.flag_hand_made(flags)

    def _return_to(self, undecided: Set[ReviewItemKey]) -> None:
        """A decision or an edit was undone: its item is looked at again; of several none is."""
        if len(undecided) == 1:
            (key,) = undecided
            if self.queue.current_key != key or self.queue.current is None:
                back = self.queue.return_to(key)
                self._select(key[1])
                if back is not None:
                    self.concerned.emit(self._concern_of(back))
        elif undecided:
            self.queue.choose(None)

    def _take(self) -> None:
        self._show()
        again, self.queue.reopened = self.queue.reopened, 0
        if again:
            words = count_text(
                again,
                "{n} decided item is open again: it is found in another shape now",
                "{n} decided items are open again: they are found in another shape now",
            )
            self.said.emit(words)
        self.changed.emit()

    def _tell_problem(self, error: Exception) -> None:
        self._show()
        self.failed.emit(error)

    # walking the queue

    def walk(self, step: int) -> None:
        """N (1) or P (-1)."""
        self._look_at(self.queue.walk(step))

    def go_to(self, key: ReviewItemKey) -> None:
        """One was clicked."""
        self._look_at(self.queue.choose(key))

    def narrow(self, kind: str) -> None:
        """List one kind alone; "" for all."""
        self.queue.narrow(kind)
        self._show()

    def _sort_by(self, order: str) -> None:
        """The panel's choice; connected as a method, as the panel outlives this object."""
        self.sort(Order(order))

    def sort(self, order: Order) -> None:
        """List in another order."""
        self.queue.sort(order)
        self._show()

    def set_plays(self, plays: bool) -> None:
        """Whether a stretch is played as soon as it is jumped to."""
        self.plays = plays
        self._show()
        self.changed.emit()

    @property
    def measures(self) -> bool:
        """Whether it is told how good the queue is against the truth."""
        return self._search.measuring

    def set_measures(self, measures: bool) -> None:
        """Tell how good the queue is against the truth, or tell it no more."""
        self._search.measure(measures)
        self._show()
        self.changed.emit()

    @property
    def standing(self) -> ReviewStanding:
        """Where somebody is in the review."""
        flags = self.flags_hand_made
        return ReviewStanding(self.queue.standing, self.plays, self.measures, flags)

    def resume(self, standing: ReviewStanding) -> None:
        """Go on where somebody was; the playhead stays."""
        if standing.flags_hand_made:
            self.flag_hand_made(True)
        self.queue.resume(standing.queue)
        self.set_plays(standing.plays)
        self.set_measures(standing.measures)

    def _look_at(self, review_item: ReviewItem | None) -> None:
        """Select its people and go to just before it."""
        if review_item is None:
            self.concerned.emit(None)
            self._show()
            self.changed.emit()
            return
        self._document.correcting.leave()
        self._select(review_item.tracks)
        self._playback.pause()
        self.concerned.emit(self._concern_of(review_item))
        self._playback.go(self._scenes.start_of(review_item))
        if self.plays:
            self.play()
        self.edited.emit()

    def _concern_of(self, review_item: ReviewItem) -> Concern | None:
        """Its people while they are watched."""
        session = self._document.session
        if session is None:
            return None
        start = min(review_item.start, self._scenes.start_of(review_item))
        there = [track for track in review_item.tracks if track in session.tracks]
        rows = session.tracks.of_tracks(there, start, review_item.end)
        return Concern(rows, start, review_item.end)

    def _select(self, tracks: tuple[int, ...]) -> None:
        there = self._document.tracks.ids
        self._document.selection.choose_all([track for track in tracks if track in there])

    def play(self) -> None:
        """Play the stretch of the current review item, from its start to its end."""
        current = self.queue.current
        if current is not None:
            self._stretch.play(self._scenes.start_of(current), current.end)

    def _watch(self) -> None:
        self.watching.saw(self._playback.number)

    # deciding

    def decide(self, decision: str) -> None:
        """Say "right" or "dismissed" of the current review item and go to the next one."""
        current, session = self.queue.current, self._document.session
        if current is None or session is None:
            return
        labels = session.labels
        if self._do(lambda: plan_review_verdict(current, decision, labels)):
            self.walk(1)

    def groups_alike(self) -> tuple[AlikeGroup, ...]:
        """What the decision on the current review item may go for as well."""
        current = self.current
        return () if current is None else groups_alike(current, self.queue.open, self.queue.name_of)

    def ask_alike(self) -> None:
        """Show what can be decided together with the current review item."""
        groups = self.groups_alike()
        if not groups:
            self.said.emit(tr("No other review item is like this one"))
        else:
            fps, window = self._document.recording.fps, self._panel.window()
            open_alike_dialog(groups, fps, window).decided.connect(self.decide_alike)

    def decide_alike(self, items: Sequence[ReviewItem], decision: str) -> None:
        """Say "right" or "dismissed" of review items as one step, and go to the next one left."""
        session, current = self._document.session, self.queue.current
        if session is None:
            return
        labels = session.labels
        first = sorted(items, key=lambda one: current is None or one.key != current.key)
        if self._do(lambda: plan_decisions(first, decision, labels)):
            self.walk(1)

    def fix(self) -> None:
        """Begin the edit that would put the current review item right; Enter does it."""
        current = self.queue.current
        if current is None or not is_fixable(current):
            return
        self._playback.pause()
        self._select(current.tracks)
        self._playback.go(current.frame)
        self._fixing = current  # before the edit, which may be done at once
        self.fix_asked.emit(edit_named(current.fix))

    def _follow_fix(self) -> None:
        """An edit that is left, or another one, is not the one that was begun here."""
        fixing, flow = self._fixing, self._document.flow
        if fixing is None or (flow is not None and flow.spec is edit_named(fixing.fix)):
            return
        self._fixing = None

    def _settle(self, change: Change, labels: Labels) -> Change:
        """The edit with the verdict on the review item that it puts right, if it does so."""
        if self._fixing is not None:
            return with_fixed_verdict(change, self._fixing, labels)
        current = self.current
        if current is None or not settles(change, current, self._document.recording.fps):
            return change
        return with_fixed_verdict(change, current, labels)

    # what is reviewed

    def mark_watched(self, everybody: bool = False) -> None:
        """Mark the stretch just watched as reviewed, for who is selected or for everybody."""
        session, (start, end) = self._document.session, self.watching.stretch
        if session is None or end <= start:
            return
        labels, tracks = session.labels, (0,) if everybody else self._document.selection.all
        self._do(lambda: plan_mark_reviewed(labels, tracks, start, end, session.tracks))

    def unmark_watched(self) -> None:
        """Take back that the stretch just watched was reviewed, for who is selected or for all."""
        session, (start, end) = self._document.session, self.watching.stretch
        if session is None or end <= start:
            return
        labels, tracks = session.labels, self._document.selection.all or (0,)
        self._do(lambda: plan_unmark_reviewed(labels, tracks, start, end))

    def _do(self, plan: Callable[[], Change]) -> bool:
        """Plan and make an edit of labels; whether that was done."""
        try:
            change = plan()
            self._document.apply(change)
        except TrackwrightError as error:
            self.failed.emit(error)
            return False
        self.said.emit(tr("Done: {what}", what=change.text))
        self.edited.emit()
        return True

    # what is shown

    @property
    def _is_hidden(self) -> bool:
        """What is left is of the session's tracks, and those of a tracker at work are shown."""
        return self._document.is_live

    @property
    def lists_items(self) -> bool:
        """Whether there are review items to be walked."""
        return bool(self.queue.items) and not self._is_hidden

    @property
    def current(self) -> ReviewItem | None:
        """The review item that is looked at."""
        return None if self._is_hidden else self.queue.current

    @property
    def fixable(self) -> bool:
        """Whether an edit would put it right."""
        return self.current is not None and is_fixable(self.current)

    def _show(self) -> None:
        left = () if self._is_hidden else self.queue.open
        if self._marked is not left:
            self._marked = left
            self._document.take_review_items(self.queue.marks() if left else ())
        self._panel.show_scene(
            self._scenes.scene(hidden=self._is_hidden, waits=self.waits, plays=self.plays)
        )
        self._strip.show(self.current)
