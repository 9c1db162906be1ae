"""A snapshot: how a part of the window is brought to be seen, and what is seen of it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from enum import Enum, auto

from PySide6.QtWidgets import QWidget

from tests.pictures.snapshots.stage import Stage

Show = Callable[[Stage], Iterator[QWidget]]
"""Brings a widget to be seen, gives it once, and takes back what the stage would not."""


class On(Enum):
    """What is open in the window."""

    NOTHING = auto()
    SESSION = auto()
    PROJECT = auto()


@dataclass(frozen=True, slots=True)
class Snapshot:
    """One part of the window.

    Attributes:
        name, group: of the picture, and of the sheet that it is on.
        covers: classes of widgets that are seen in it; questions ("module:function") asked in it;
            edits ("edit:name").
    """

    name: str
    group: str
    on: On
    covers: tuple[type[QWidget] | str, ...]
    show: Show

    @property
    def classes(self) -> tuple[type[QWidget], ...]:
        """The classes among what is covered."""
        return tuple(one for one in self.covers if isinstance(one, type))


_DECLARED: list[Snapshot] = []


def snapshot(
    group: str, on: On, *covers: type[QWidget] | str, name: str = ""
) -> Callable[[Show], Show]:
    """Declares a function as a snapshot; its name is the picture's unless another is given."""

    def declare(show: Show) -> Show:
        called = (name or getattr(show, "__name__", "")).replace("_", "-").replace(" ", "-")
        _DECLARED.append(Snapshot(called, group, on, covers, show))
        return show

    return declare


def declared() -> tuple[Snapshot, ...]:
    """All that were declared so far."""
    return tuple(_DECLARED)
