"""A command: one declared value that menus, palette, keys and the cheat sheet are made from."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic, TypeVar

AppT = TypeVar("AppT", contravariant=True)


def _always(_: object) -> str:
    return ""


@dataclass(frozen=True)  # no slots: Python 3.11 cannot name the type of such a generic
class Command(Generic[AppT]):
    """One command of an application, which gives it what it needs.

    Attributes:
        id: e.g. "tracks.swap". title: English, translated when shown.
        menu: one of `MENUS`, with a submenu after a slash, e.g. "Correct/Delete".
        keys: default keys, in Qt's portable text.
        enabled: why it cannot be done now, in words; "" where it can.
        run: does it; what it gives is not looked at.
        checked: whether it is on; None: it is no switch.
        separated: a line stands above it, or above the submenu that begins with it.
        icon: of the drawings that ship with the program; "" for none.
        note: what stands in brackets behind the title, e.g. a file in use; "" for nothing.
        also: further words that the search finds it by.
        title_one_camera: the title where the recording has one camera; "" for the same.
    """

    id: str
    title: str
    menu: str
    keys: tuple[str, ...] = ()
    enabled: Callable[[AppT], str] = _always
    run: Callable[[AppT], object] = _always
    checked: Callable[[AppT], bool] | None = None
    separated: bool = False
    icon: str = ""
    note: Callable[[AppT], str] = _always
    also: str = ""
    title_one_camera: str = ""
