"""Which keys run which command: what commands declare, a profile of keys, and the user's changes.

Texts that name a key ask here for it, so that they always name the one in use.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Protocol

from app.core.i18n import tr


class Keyed(Protocol):
    """What a command says of its keys."""

    @property
    def id(self) -> str:
        """E.g. "tracks.swap"."""

    @property
    def title(self) -> str:
        """English, translated when shown."""

    @property
    def keys(self) -> tuple[str, ...]:
        """Default keys, in Qt's portable text."""


@dataclass(slots=True)
class _Known:
    title: str
    keys: tuple[str, ...]


_known: dict[str, _Known] = {}


def declare(commands: Iterable[Keyed]) -> None:
    """Begin with the keys that commands declare."""
    _known.clear()
    _known.update({one.id: _Known(one.title, one.keys) for one in commands})


def use_keys(keys: Mapping[str, tuple[str, ...]]) -> None:
    """Use these keys, by the id of each command that is to have others than it has now."""
    for command, given in keys.items():
        _known[command].keys = given


def keys_of(command: str) -> tuple[str, ...]:
    """The keys of a command in use, in Qt's portable text; the first is the one to show."""
    known = _known.get(command)
    return known.keys if known is not None else ()


def first_key(command: str) -> str:
    """The key of a command to show, e.g. "Ctrl+T"; "" where it has none."""
    return next(iter(keys_of(command)), "")


def shown_key(command: str) -> str:
    """The same as keyboards name it: "Enter", not "Return"."""
    return first_key(command).replace("Return", "Enter")


def in_brackets(command: str) -> str:
    """The key of a command behind other words, e.g. " (Ctrl+T)"; "" where it has none."""
    key = shown_key(command)
    return f" ({key})" if key else ""


def key_or_title(command: str) -> str:
    """What to press for a command; where it has no key, its title in quotes."""
    known = _known.get(command)
    return shown_key(command) or tr('"{title}"', title=tr(known.title) if known else command)
