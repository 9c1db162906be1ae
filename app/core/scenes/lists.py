"""What the list of commands and the first page show."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class CommandItem:
    """A command as menus, the palette and the list of shortcuts show it.

    Attributes:
        command: id, e.g. "edit.swap". title: e.g. "Swap with...".
        menu: where it stands, e.g. "File", "Correct > Delete".
        keys: in Qt's portable text, e.g. "Ctrl+Shift+Z"; the first is shown.
        why_not: said where it is not enabled. also: further words that the search finds it by.
        english: the title in English, by which it is found in any language.
    """

    command: str
    menu: str
    title: str
    keys: tuple[str, ...]
    enabled: bool
    why_not: str = ""
    checked: bool | None = None
    also: str = ""
    english: str = ""


@dataclass(frozen=True, slots=True)
class RecentItem:
    """A recording or session opened before."""

    path: str
    title: str
    detail: str
    exists: bool = True


@dataclass(frozen=True, slots=True)
class WelcomeScene:
    """The first page: what can be opened. `notice` is said above, e.g. after a crash."""

    recent: tuple[RecentItem, ...] = ()
    notice: str = ""
