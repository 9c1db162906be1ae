"""Keys while they are edited: what the dialog shows, and what a change leads to."""

from __future__ import annotations

from collections.abc import Iterable

from app.core.scenes import CommandItem
from app.features.keys.scene import KeyRow, Keys, OwnKeys, resolved


class KeysPresenter:
    """The keys of all commands.

    Attributes:
        own: what the user has chosen so far. keys: of each command, as that makes them.
    """

    def __init__(self, items: Iterable[CommandItem], declared: Keys, own: OwnKeys) -> None:
        """items: all commands, in the order of the menus. declared: their own keys."""
        self._items = tuple(items)
        self._declared = declared
        self._titles = {item.command: item.title for item in self._items}
        self.choose(own)

    def choose(self, own: OwnKeys) -> None:
        """Another profile was chosen, or read from a file."""
        self.own = own
        self.keys = resolved(self._declared, own)
        self._usual = resolved(self._declared, OwnKeys(own.profile))

    def rows(self, typed: str = "") -> tuple[KeyRow, ...]:
        """The commands that what is typed names, those first of which it is a key.

        It may be of the title, of the menu, of a key, or of another tool's word for the command.
        """
        wanted = typed.strip().lower()
        found = [
            self._row(item)
            for item in self._items
            if wanted in f"{item.title} {item.menu} {item.also} {self._keys_of(item)}".lower()
        ]
        return tuple(sorted(found, key=lambda row: wanted not in map(str.lower, row.keys)))

    def _keys_of(self, item: CommandItem) -> str:
        return " ".join(self.keys[item.command])

    def owner(self, command: str, key: str) -> str:
        """The title of another command that has the key; "" where it is free."""
        return self._titles.get(self._other(command, key), "")

    def add(self, command: str, key: str) -> None:
        """Give a command one more key, the one to show; who else had it has it no longer."""
        changes = dict(self.own.changes)
        other = self._other(command, key)
        if other:
            changes[other] = tuple(k for k in self.keys[other] if k != key)
        changes[command] = tuple(dict.fromkeys((key, *self.keys[command])))
        self._change(changes)

    def remove(self, command: str, key: str) -> None:
        """Take a key from a command."""
        left = tuple(k for k in self.keys[command] if k != key)
        self._change({**self.own.changes, command: left})

    def reset(self, command: str) -> None:
        """Give a command the keys of the profile again; who has one of them loses it."""
        changes = {name: keys for name, keys in self.own.changes.items() if name != command}
        for key in self._usual[command]:
            other = self._other(command, key)
            if other:
                changes[other] = tuple(k for k in self.keys[other] if k != key)
        self._change(changes)

    def reset_all(self) -> None:
        """The profile as it ships."""
        self.choose(OwnKeys(self.own.profile))

    def is_changed(self, command: str) -> bool:
        """Whether its keys are not those of the profile."""
        return self.keys[command] != self._usual[command]

    def _row(self, item: CommandItem) -> KeyRow:
        keys = self.keys[item.command]
        return KeyRow(item.command, item.menu, item.title, keys, self.is_changed(item.command))

    def _other(self, command: str, key: str) -> str:
        having = (name for name, keys in self.keys.items() if key in keys and name != command)
        return next(having, "")

    def _change(self, changes: dict[str, tuple[str, ...]]) -> None:
        """Keep only what differs from the profile."""
        kept = {name: keys for name, keys in changes.items() if keys != self._usual[name]}
        self.choose(OwnKeys(self.own.profile, kept))
