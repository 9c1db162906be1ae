"""The review queue: which suspicions are left, which one is looked at, what comes next."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final

from app.presenters.i18n import time_text, tr
from app.presenters.reviewing.review_scene import Order, ReviewItem, ReviewKind, ReviewPerson
from app.presenters.scenes import MarkKind, TimelineMark
from app.presenters.track_colours import ColourOf
from tracking.editing import Change, plan_verdict, with_verdict
from tracking.review import Suspicion, SuspicionKey, open_suspicions, ranked
from tracking.tracks import Labels, TrackTable, Verdict

_KINDS: Final = {
    "exchange": "Likely swap",
    "turn": "Ways change over",
    "crossing": "Ways cross",
    "shared": "Seen as one",
    "lost": "Lost and found",
    "ended": "Ends midway",
    "begun": "Begins midway",
    "colour": "Colours change",
    "height": "Height changes",
    "jump": "Jumps",
    "reversal": "Turns back",
    "predicted": "Long out of sight",
    "drift": "Goes on unseen",
    "margin": "Close choice",
    "spread": "Particles spread",
    "split": "Particles split",
    "part": "Part failed",
}
_FIXES: Final = frozenset({"swap", "split", "merge", "delete"})
"""Edits that can be begun for a suspicion; others can only be looked at."""


def kind_title(kind: str) -> str:
    """A kind of suspicion in words."""
    known = _KINDS.get(kind)
    return tr(known) if known else kind.replace("_", " ").capitalize()


def is_fixable(suspicion: Suspicion) -> bool:
    """Whether an edit is known that would put it right."""
    return suspicion.fix in _FIXES


class ReviewQueue:
    """Suspicions less those that are decided, walked one after the other.

    The current one is kept by its key, so that it stays the same where the list is found anew.
    """

    def __init__(self, fps: float, colour_of: ColourOf) -> None:
        self.kind = ""
        self.order = Order.WORTH
        self._fps, self._colour_of = fps, colour_of
        self._found: tuple[Suspicion, ...] = ()
        self._open: tuple[Suspicion, ...] = ()
        self._shown: tuple[Suspicion, ...] = ()
        self._current: SuspicionKey | None = None
        self._returns_to: SuspicionKey | None = None
        self._last_place = 0
        self._table: TrackTable | None = None
        self._names: Mapping[int, str] = {}
        self._items: tuple[ReviewItem, ...] = ()

    @property
    def open(self) -> tuple[Suspicion, ...]:
        """All that are left, of every kind, the most worth looking at first."""
        return self._open

    @property
    def items(self) -> tuple[ReviewItem, ...]:
        """Those of the chosen kind in the chosen order, as the panel lists them."""
        return self._items

    @property
    def current(self) -> Suspicion | None:
        """The one that is looked at."""
        place = self.place
        return self._shown[place] if place >= 0 else None

    @property
    def place(self) -> int:
        """Where the current one stands in the list; -1: none is looked at."""
        keys = [suspicion.key for suspicion in self._shown]
        return keys.index(self._current) if self._current in keys else -1

    @property
    def current_key(self) -> SuspicionKey | None:
        """The key of the one looked at last, also where it is not listed any more."""
        return self._current

    def take(
        self, found: Sequence[Suspicion], labels: Labels, table: TrackTable | None = None
    ) -> None:
        """Take what was found in a table, less what people have decided or reviewed."""
        self._found, self._table = tuple(found), table
        self.take_labels(labels)
        if self._returns_to is not None:
            self.return_to(self._returns_to)
            self._returns_to = None

    def take_labels(self, labels: Labels) -> None:
        """Take what people have decided by now."""
        self._open = open_suspicions(self._found, labels, self._fps, self._table)
        self._list()

    def take_names(self, names: Mapping[int, str]) -> None:
        """Take what people are called."""
        if names != self._names:
            self._names = dict(names)
            self._list()

    def narrow(self, kind: str) -> None:
        """List one kind alone; "" for all."""
        self.kind = kind
        self._list()

    def sort(self, order: Order) -> None:
        """List in another order."""
        self.order = order
        self._list()

    def choose(self, key: SuspicionKey | None) -> Suspicion | None:
        """Look at one of the list; None: at none."""
        self._current, self._returns_to = key, None
        self._last_place = self.place if self.place >= 0 else self._last_place
        return self.current

    def return_to(self, key: SuspicionKey) -> Suspicion | None:
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

    def walk(self, step: int) -> Suspicion | None:
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
        for suspicion in self._open:
            counts[suspicion.kind] = counts.get(suspicion.kind, 0) + 1
        titled = [ReviewKind(kind, kind_title(kind), n) for kind, n in counts.items()]
        return tuple(sorted(titled, key=lambda one: one.title))

    def marks(self) -> tuple[TimelineMark, ...]:
        """What is left as marks of the timeline, one a person."""
        return tuple(
            TimelineMark(
                MarkKind.SUSPICION, one.frame, track, f"{kind_title(one.kind)}: {one.text}"
            )
            for one in self._open
            for track in one.tracks
        )

    def colour_anew(self) -> None:
        """Tracks have other colours by now."""
        self._list()

    def _list(self) -> None:
        if self.kind not in {suspicion.kind for suspicion in self._open}:
            self.kind = ""
        wanted = [one for one in self._open if self.kind in ("", one.kind)]
        self._shown = ranked(wanted, self.order.value)
        self._items = tuple(self._item(suspicion) for suspicion in self._shown)

    def _item(self, suspicion: Suspicion) -> ReviewItem:
        return ReviewItem(
            key=suspicion.key,
            title=kind_title(suspicion.kind),
            people=tuple(
                ReviewPerson(
                    track, f"{track} {self._names.get(track, '')}".rstrip(), self._colour_of(track)
                )
                for track in suspicion.tracks
            ),
            frame=suspicion.frame,
            when=time_text(suspicion.frame / self._fps),
            why=suspicion.text,
            others=suspicion.others,
            likelihood=suspicion.likelihood,
        )


def verdict_on(suspicion: Suspicion, decision: str, labels: Labels) -> Change:
    """The change that keeps what a person decided about a suspicion.

    Raises:
        EditError: that was said already.
    """
    return plan_verdict(labels, _verdict(suspicion, decision), _named(suspicion))


def settled(change: Change, suspicion: Suspicion, labels: Labels) -> Change:
    """The edit that puts a suspicion right, with the verdict that it did: undone together."""
    return with_verdict(change, labels, _verdict(suspicion, "fixed"))


def _verdict(suspicion: Suspicion, decision: str) -> Verdict:
    return Verdict(suspicion.kind, suspicion.tracks, suspicion.frame, decision)


def _named(suspicion: Suspicion) -> str:
    who = ", ".join(str(track) for track in suspicion.tracks)
    return f"{kind_title(suspicion.kind)} {who} in frame {suspicion.frame}"
