"""What the view of differences draws: a frozen scene like those of the other views."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from app.core.scenes.queue_rows import ReviewPerson


class DifferenceOrder(Enum):
    """In which order differences are listed."""

    TIME = "time"
    PERSON = "person"


@dataclass(frozen=True, slots=True)
class DifferenceItem:
    """A stretch in which two versions of the tracks are not the same.

    Attributes:
        number: of the difference, which gestures name. title: its kind in words.
        when: from the first to the last frame, in time. text: what would change, in words.
        ticked: it is to be taken. locked: why it cannot be, "" where it can.
    """

    number: int
    title: str
    people: tuple[ReviewPerson, ...]
    when: str
    text: str
    ticked: bool
    locked: str = ""


@dataclass(frozen=True, slots=True)
class Side:
    """One of the two versions that are compared.

    Attributes:
        title: of a run its number and its tracker. short: e.g. "run 2".
        can_give: stretches can be taken from it.
    """

    title: str
    short: str
    can_give: bool


@dataclass(frozen=True, slots=True)
class DifferencesScene:
    """Two versions of the tracks beside each other.

    Attributes:
        solid, dashed: which version is drawn how.
        items: those of the chosen person in the chosen order. current: place of the one that is
            looked at, -1 for none.
        people: who differences are about; person: the one the list is narrowed to, 0 for all.
        ticked, takeable, locked: how many are ticked, could be, and cannot be; of all, not of the
            listed ones alone.
        can_drop: the dashed version is a run that can be dropped.
        doing: what goes on, "" at rest. share: how much of it is done, None: not known.
        text: said where nothing differs.
    """

    solid: Side
    dashed: Side
    items: tuple[DifferenceItem, ...] = ()
    current: int = -1
    people: tuple[ReviewPerson, ...] = ()
    person: int = 0
    order: DifferenceOrder = DifferenceOrder.TIME
    ticked: int = 0
    takeable: int = 0
    locked: int = 0
    can_drop: bool = False
    doing: str = ""
    share: float | None = None
    text: str = ""
