"""The review queue: which review items are left, which one is looked at, what comes next."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from app.core.colours.track_colours import ColourOf
from app.core.i18n import N_, count_text, time_text, tr
from app.core.scenes import MarkKind, TimelineMark
from app.core.scenes.queue_rows import ReviewPerson, ReviewRow
from app.features.review.reopened_items import DecidedAndOpen, count_reopened
from app.features.review.scene import Order, ReviewKind
from tracking.editing import Change, plan_verdict, with_verdict
from tracking.review import (
    KindRecord,
    ReviewFinding,
    ReviewItem,
    ReviewItemKey,
    ReviewState,
    rank,
    review_state,
)
from tracking.tracks import Labels, TrackTable, Verdict
from tracking.translation import Message, joined, msg

_KINDS: Final = {
    "exchange": N_("Likely swap"),
    "turn": N_("Directions swap"),
    "crossing": N_("Paths cross"),
    "shared": N_("Detected as one"),
    "lost": N_("Lost, then found"),
    "ended": N_("Ends midway"),
    "begun": N_("Begins midway"),
    "colour": N_("Colours change"),
    "height": N_("Height changes"),
    "jump": N_("Jumps"),
    "reversal": N_("Turns back"),
    "predicted": N_("Long predicted"),
    "drift": N_("Drifts undetected"),
    "margin": N_("Close association"),
    "spread": N_("Particles spread"),
    "split": N_("Particles split"),
    "part": N_("Part failed"),
}
_FIXES: Final = frozenset({"swap", "split", "merge", "delete"})
"""Edits that can be begun for a review item; others can only be looked at."""

_OF_TWO: Final = frozenset({"swap", "merge"})
_IDENTITY_EDITS: Final = _OF_TWO | {"split", "reassign", "delete"}


def kind_title(kind: str) -> str:
    """A kind of review item in words."""
    return tr(_title(kind))


def _title(kind: str) -> Message:
    return msg(_KINDS.get(kind) or kind.replace("_", " ").capitalize())


def is_fixable(item: ReviewItem) -> bool:
    """Whether an edit is known that would put it right."""
    return item.fix in _FIXES


@dataclass(frozen=True, slots=True)
class QueuePlace:
    """Where somebody is in the queue: the kind and order listed, and the item looked at last."""

    kind: str = ""
    order: Order = Order.WORTH
    key: ReviewItemKey | None = None


class ReviewQueue:
    """Review items less those that are decided, walked one after the other.

    The current one is kept by its key, so that it stays the same where the list is found anew. The
    likelihoods of those left follow what came of the decided ones: `tracking.review.kind_records`.

    Attributes:
        kind: the one that is listed, "" for all. order: of the list.
        state: how far the review is. is_searched: its tracks were looked through.
        reopened: how many that were decided were found in another shape by the last search, and
            so are open again.
    """

    def __init__(self, fps: float, colour_of: ColourOf) -> None:
        self.kind = ""
        self.order = Order.WORTH
        self._fps, self._colour_of = fps, colour_of
        self._finding = ReviewFinding()
        self.state = ReviewState()
        self.is_searched = False
        self.reopened = 0
        self._shown: tuple[ReviewItem, ...] = ()
        self._current: ReviewItemKey | None = None
        self._returns_to: ReviewItemKey | None = None
        self._last_place = 0
        self._table = TrackTable()
        self._names: Mapping[int, str] = {}
        self._items: tuple[ReviewRow, ...] = ()

    @property
    def open(self) -> tuple[ReviewItem, ...]:
        """All that are left, of every kind, the most worth looking at first."""
        return self.state.left

    @property
    def records(self) -> Mapping[str, KindRecord]:
        """What came of the decided items, by kind."""
        return self.state.records

    @property
    def items(self) -> tuple[ReviewRow, ...]:
        """Those of the chosen kind in the chosen order, as the panel lists them."""
        return self._items

    @property
    def current(self) -> ReviewItem | None:
        """The one that is looked at."""
        place = self.place
        return self._shown[place] if place >= 0 else None

    @property
    def place(self) -> int:
        """Where the current one stands in the list; -1: none is looked at."""
        keys = [item.key for item in self._shown]
        return keys.index(self._current) if self._current in keys else -1

    @property
    def current_key(self) -> ReviewItemKey | None:
        """The key of the one looked at last, also where it is not listed any more."""
        return self._current

    def take(self, finding: ReviewFinding, labels: Labels, table: TrackTable | None = None) -> None:
        """Take what was found in a table, less what people have decided or reviewed."""
        before = self._decided_and_left(labels)
        self._finding = finding
        self._table = TrackTable() if table is None else table
        self.is_searched = True
        self.take_labels(labels)
        self.reopened = count_reopened(before, self._decided_and_left(labels), self._fps)
        if self._returns_to is not None:
            self.return_to(self._returns_to)
            self._returns_to = None

    def _decided_and_left(self, labels: Labels) -> DecidedAndOpen:
        """The items found that are decided, but for those put right, and those that are left."""
        left = {one.key for one in self.state.left}
        fixed = {key for key, said in labels.verdicts.items() if said.decision == "fixed"}
        decided = [one for one in self.state.found if one.key not in left | fixed]
        return decided, self.state.left

    def take_labels(self, labels: Labels) -> None:
        """Take what people have decided by now, and learn from it."""
        self.state = review_state(self._finding, labels, self._table, self._fps)
        self._list()

    def forget(self) -> None:
        """The same ids are other people from now on."""
        self.take(ReviewFinding(), Labels())
        self.is_searched = False

    def learned_text(self) -> str:
        """What came of the current item's kind here; "" where nothing did."""
        current = self.current
        record = self.records.get(current.kind) if current is not None else None
        return "" if record is None or current is None else _record_text(current.kind, record)

    def learned_texts(self) -> tuple[str, ...]:
        """What came of each kind here."""
        return tuple(_record_text(kind, record) for kind, record in sorted(self.records.items()))

    def take_names(self, names: Mapping[int, str]) -> None:
        """Take what people are called."""
        if names != self._names:
            self._names = dict(names)
            self._list()

    def name_of(self, track: int) -> str:
        """A track's number, and its name where it has one."""
        return f"{track} {self._names.get(track, '')}".rstrip()

    @property
    def standing(self) -> QueuePlace:
        """Where somebody is in it."""
        return QueuePlace(self.kind, self.order, self._current)

    def resume(self, standing: QueuePlace) -> None:
        """Go on where somebody was; the item is looked at again as soon as it is found."""
        self.kind, self.order = standing.kind, standing.order
        self._list()
        if standing.key is not None:
            self.return_to(standing.key)

    def narrow(self, kind: str) -> None:
        """List one kind alone; "" for all."""
        self.kind = kind
        self._list()

    def sort(self, order: Order) -> None:
        """List in another order."""
        self.order = order
        self._list()

    def choose(self, key: ReviewItemKey | None) -> ReviewItem | None:
        """Look at one of the list; None: at none."""
        self._current, self._returns_to = key, None
        self._last_place = self.place if self.place >= 0 else self._last_place
        return self.current

    def return_to(self, key: ReviewItemKey) -> ReviewItem | None:
        """Look again at one that was edited away, also where another kind alone is listed.

        Found anew meanwhile it may lie a little beside the frame it was at, or go by another kind
        where another reason is the strongest now: it is looked for again in what is taken next.
        None where it is still to be found.
        """
        near = [
            one
            for one in self.open
            if one.tracks == key[1] and abs(one.frame - key[2]) <= self._fps
        ]
        found = min(
            near, key=lambda one: (one.kind != key[0], abs(one.frame - key[2])), default=None
        )
        if found is not None and self.kind not in ("", found.kind):
            self.narrow("")
        back = self.choose(key if found is None else found.key)
        self._returns_to = key
        return back

    def walk(self, step: int) -> ReviewItem | None:
        """Go to the next (1) or the previous (-1) one; around at the ends, None where all is done.

        Where the one that was looked at is decided by now, the next one is what took its place.
        """
        if not self._shown:
            return None
        place, count = self.place, len(self._shown)
        if place >= 0:
            following = (place + step) % count
        else:
            following = min(self._last_place, count - 1) if step > 0 else self._last_place - 1
        return self.choose(self._shown[following].key)

    def kinds(self) -> tuple[ReviewKind, ...]:
        """The kinds there are, with how many are left of each."""
        counts: dict[str, int] = {}
        for item in self.open:
            counts[item.kind] = counts.get(item.kind, 0) + 1
        titled = [ReviewKind(kind, kind_title(kind), n) for kind, n in counts.items()]
        return tuple(sorted(titled, key=lambda one: one.title))

    def marks(self) -> tuple[TimelineMark, ...]:
        """What is left as marks of the timeline, one a person."""
        return tuple(
            TimelineMark(
                MarkKind.REVIEW_ITEM, one.frame, track, f"{kind_title(one.kind)}: {tr(one.text)}"
            )
            for one in self.open
            for track in one.tracks
        )

    def colour_anew(self) -> None:
        """Tracks have other colours by now."""
        self._list()

    def _list(self) -> None:
        if self._finding.items and self.kind not in {item.kind for item in self.open}:
            self.kind = ""
        wanted = [one for one in self.open if self.kind in ("", one.kind)]
        self._shown = rank(wanted, self.order.value)
        self._items = tuple(self._item(item) for item in self._shown)

    def _item(self, item: ReviewItem) -> ReviewRow:
        return ReviewRow(
            key=item.key,
            title=kind_title(item.kind),
            people=tuple(
                ReviewPerson(track, self.name_of(track), self._colour_of(track))
                for track in item.tracks
            ),
            frame=item.frame,
            when=time_text(item.frame / self._fps),
            why=tr(item.text),
            others=tuple(map(tr, item.others)),
            likelihood=item.likelihood,
        )


def _record_text(kind: str, record: KindRecord) -> str:
    return count_text(
        record.decided,
        "{kind}: {errors} of {n} was an error here",
        "{kind}: {errors} of {n} were errors here",
        kind=kind_title(kind),
        errors=record.errors,
    )


def plan_review_verdict(item: ReviewItem, decision: str, labels: Labels) -> Change:
    """The change that keeps what a person decided about a review item.

    Raises:
        EditError: that was said already.
    """
    return plan_verdict(labels, _verdict(item, decision), _named(item))


def with_fixed_verdict(change: Change, item: ReviewItem, labels: Labels) -> Change:
    """The edit that puts a review item right, with the verdict that it did: undone together."""
    return with_verdict(change, labels, _verdict(item, "fixed"))


def settles(change: Change, item: ReviewItem, fps: float) -> bool:
    """Whether an edit by hand puts a review item right.

    It does where it is the edit that the item asks for (any of identities where that is not known),
    of its people, in the stretch that it shows or within a second of it.
    """
    both = set(item.tracks) <= set(change.tracks)
    some = not set(item.tracks).isdisjoint(change.tracks)
    concerned = both if change.kind in _OF_TWO else some
    asked = change.kind in (_IDENTITY_EDITS if item.fix == "look" else {item.fix})
    return concerned and asked and item.start - fps <= change.frame < item.end + fps


def _verdict(item: ReviewItem, decision: str) -> Verdict:
    return Verdict(item.kind, item.tracks, item.frame, decision)


def _named(item: ReviewItem) -> Message:
    who = joined(", ", item.tracks)
    return msg("{kind} {who} in frame {frame}", kind=_title(item.kind), who=who, frame=item.frame)
