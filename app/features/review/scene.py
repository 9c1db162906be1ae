"""What the review panel draws: a frozen scene like those of the other views."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from app.core.scenes.queue_rows import ReviewRow


class Order(Enum):
    """What stands first in the queue: names and values are those of `tracking.review.rank`."""

    WORTH = "worth"
    TIME = "time"


@dataclass(frozen=True, slots=True)
class ReviewKind:
    """A kind of review item that the queue can be narrowed to."""

    kind: str
    title: str
    count: int


@dataclass(frozen=True, slots=True)
class ReviewScene:
    """The queue as it stands.

    Attributes:
        items: those of the chosen kind, in the chosen order; the very same tuple while it is the
            same queue. current: place of the highlighted one among them, -1 for none.
        left: how many are undecided, of all kinds.
        kinds: what there is; kind: the chosen one, "" for all.
        plays: a stretch is played as soon as it is jumped to.
        also: further reasons of the current one. doing: what goes on, "" at rest.
        title, text: said where there is nothing to list.
        learned: what came of the current one's kind here. all_learned: of each kind, a line each.
        meter: how the review gets on. counted: what the errors are that it tells of.
        waits: nothing was looked for, as no tracker made the tracks; it is if somebody asks.
    """

    items: tuple[ReviewRow, ...] = ()
    current: int = -1
    left: int = 0
    kinds: tuple[ReviewKind, ...] = ()
    kind: str = ""
    order: Order = Order.WORTH
    plays: bool = False
    also: str = ""
    doing: str = ""
    title: str = ""
    text: str = ""
    learned: str = ""
    all_learned: str = ""
    meter: str = ""
    counted: str = ""
    waits: bool = False
