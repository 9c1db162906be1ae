"""The review queue: which review items are left, which one is looked at, what comes next."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Final

from app.core.colours.track_colours import ColourOf
from app.core.i18n import N_, count_text, time_text, tr
from app.core.scenes import MarkKind, TimelineMark
from app.core.scenes.queue_rows import ReviewPerson, ReviewRow
from app.features.review.reopened_items import count_reopened
from app.features.review.scene import Order, ReviewKind
from tracking.editing import Change, plan_verdict, with_verdict
from tracking.review import (
    DecidedItems,
    KindRecord,
    ReviewItem,
    ReviewItemKey,
    filter_undecided,
    rank,
    records_of,
    with_learned_likelihoods,
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
Outcome = tuple[ReviewItemKey, float, bool]
"""A decided item, what was stated of it, and whether it was an error."""
_UNKNOWN: Final = 0.5
"""Likelihood of a decided item of a kind that is not found any more."""


def kind_title(kind: str) -> str:
    """A kind of review item in words."""
    return tr(_title(kind))


def _title(kind: str) -> Message:
    return msg(_KINDS.get(kind) or kind.replace("_", " ").capitalize())


def is_fixable(item: ReviewItem) -> bool:
    """Whether an edit is known that would put it right."""
    return item.fix in _FIXES


@dataclass(frozen=True, slots=True)
class QueueFigures:
    """How far the queue is.

    Attributes:
        found: how many items there are. decided: those of them that are decided or reviewed.
        outcome: what came of decided items. stated: sum of the likelihoods, as found, of all items,
            those put right among them. stated_left: of those left.
    """

    found: int = 0
    decided: tuple[ReviewItem, ...] = ()
    outcome: DecidedItems = field(default_factory=DecidedItems)
    stated: float = 0.0
    stated_left: float = 0.0


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
        records: what came of the decided items, by kind. figures: how far the queue is.
        reopened: how many that were decided were found in another shape by the last search, and
            so are open again.
    """

    def __init__(self, fps: float, colour_of: ColourOf) -> None:
        self.kind = ""
        self.order = Order.WORTH
        self._fps, self._colour_of = fps, colour_of
        self._found: tuple[ReviewItem, ...] = ()
        self._learned: tuple[ReviewItem, ...] = ()
        self._stated: dict[ReviewItemKey, float] = {}
        self._corrected: frozenset[ReviewItemKey] = frozenset()
        self.records: Mapping[str, KindRecord] = {}
        self.figures = QueueFigures()
        self.reopened = 0
        self._open: tuple[ReviewItem, ...] = ()
        self._shown: tuple[ReviewItem, ...] = ()
        self._current: ReviewItemKey | None = None
        self._returns_to: ReviewItemKey | None = None
        self._last_place = 0
        self._table: TrackTable | None = None
        self._names: Mapping[int, str] = {}
        self._items: tuple[ReviewRow, ...] = ()

    @property
    def open(self) -> tuple[ReviewItem, ...]:
        """All that are left, of every kind, the most worth looking at first."""
        return self._open

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

    def take(
        self, found: Sequence[ReviewItem], labels: Labels, table: TrackTable | None = None
    ) -> None:
        """Take what was found in a table, less what people have decided or reviewed."""
        self._found = self._learned = tuple(found)
        self._table = table
        self._stated |= {one.key: one.likelihood for one in found}
        self.records = {}
        decided, known = self.figures.decided, self._open
        self.take_labels(labels)
        self.reopened = count_reopened(
            (decided, known), (self.figures.decided, self._open), self._fps
        )
        if self._returns_to is not None:
            self.return_to(self._returns_to)
            self._returns_to = None

    def take_labels(self, labels: Labels) -> None:
        """Take what people have decided by now, and learn from it."""
        outcomes = tuple(self._outcomes(labels))
        records = records_of((kind, stated, error) for (kind, *_), stated, error in outcomes)
        if records != self.records:
            self.records = records
            self._learned = with_learned_likelihoods(self._found, records)
        self._open = filter_undecided(self._learned, labels, self._fps, self._table)
        self.figures = self._figures_of(outcomes)
        self._list()

    def _figures_of(self, outcomes: Sequence[Outcome]) -> QueueFigures:
        every = {key: stated for key, stated, _ in outcomes}
        every |= {one.key: one.likelihood for one in self._found}
        left = {one.key for one in self._open}
        return QueueFigures(
            found=len(self._found),
            decided=tuple(one for one in self._found if one.key not in left),
            outcome=DecidedItems(
                sum(stated for _, stated, _ in outcomes), sum(error for *_, error in outcomes)
            ),
            stated=sum(every.values()),
            stated_left=sum(every[key] for key in left),
        )

    def take_corrected(self, corrected: frozenset[ReviewItemKey], labels: Labels) -> None:
        """Take at which items tracks were corrected by hand in this sitting: they were errors."""
        if corrected != self._corrected:
            self._corrected = corrected
            self.take_labels(labels)

    def forget(self) -> None:
        """The same ids are other people from now on."""
        self._stated, self._corrected = {}, frozenset()
        self.take((), Labels())

    def _outcomes(self, labels: Labels) -> Iterator[Outcome]:
        """What came of each decided item.

        What was dismissed says nothing. Where an item was put right before it was found here, it
        is taken for one like the others of its kind.
        """
        errors = dict.fromkeys(self._corrected, True)
        for key, verdict in labels.verdicts.items():
            if verdict.decision != "dismissed":
                errors[key] = verdict.decision == "fixed"
        if not errors:
            return
        usual = self._usual_likelihoods()
        for key, error in errors.items():
            yield key, self._stated.get(key, usual.get(key[0], _UNKNOWN)), error

    def _usual_likelihoods(self) -> dict[str, float]:
        """By kind, the mean of what was stated."""
        sums: dict[str, list[float]] = {}
        for key, stated in self._stated.items():
            sums.setdefault(key[0], []).append(stated)
        return {kind: sum(every) / len(every) for kind, every in sums.items()}

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
            for one in self._open
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
        for item in self._open:
            counts[item.kind] = counts.get(item.kind, 0) + 1
        titled = [ReviewKind(kind, kind_title(kind), n) for kind, n in counts.items()]
        return tuple(sorted(titled, key=lambda one: one.title))

    def marks(self) -> tuple[TimelineMark, ...]:
        """What is left as marks of the timeline, one a person."""
        return tuple(
            TimelineMark(
                MarkKind.REVIEW_ITEM, one.frame, track, f"{kind_title(one.kind)}: {tr(one.text)}"
            )
            for one in self._open
            for track in one.tracks
        )

    def colour_anew(self) -> None:
        """Tracks have other colours by now."""
        self._list()

    def _list(self) -> None:
        if self._found and self.kind not in {item.kind for item in self._open}:
            self.kind = ""
        wanted = [one for one in self._open if self.kind in ("", one.kind)]
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


def _verdict(item: ReviewItem, decision: str) -> Verdict:
    return Verdict(item.kind, item.tracks, item.frame, decision)


def _named(item: ReviewItem) -> Message:
    who = joined(", ", item.tracks)
    return msg("{kind} {who} in frame {frame}", kind=_title(item.kind), who=who, frame=item.frame)
