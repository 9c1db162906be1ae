"""Keys as the user has chosen them, and what the dialog of keys shows of them."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field
from importlib.resources import files
from typing import Final

OURS: Final = ""
"""The profile without changes: what commands declare."""
SHIPPED: Final = {OURS: "trackwright", "cvat": "CVAT", "sleap": "SLEAP"}
"""Titles of the profiles that can be chosen, by name."""

Keys = Mapping[str, tuple[str, ...]]
"""Keys in Qt's portable text, by command."""


@dataclass(frozen=True, slots=True)
class OwnKeys:
    """What a user has chosen.

    Attributes:
        profile: one of `SHIPPED`, by name. changes: what differs from it.
        unknown: commands of a file that this program does not have; they are left out.
    """

    profile: str = OURS
    changes: Keys = field(default_factory=dict)
    unknown: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class KeyRow:
    """A command and its keys.

    Attributes:
        command: id. menu, title: as they stand in the menus. changed: by the user.
    """

    command: str
    menu: str
    title: str
    keys: tuple[str, ...]
    changed: bool


def profile_keys(name: str) -> Keys:
    """What a profile that ships changes, by command. Raises KeyError where there is none."""
    if name not in SHIPPED:
        raise KeyError(name)
    if name == OURS:
        return {}
    text = (files("resources") / "keys" / f"{name}.toml").read_text(encoding="utf-8")
    return {command: tuple(keys) for command, keys in tomllib.loads(text)["keys"].items()}


def resolved(defaults: Keys, own: OwnKeys) -> dict[str, tuple[str, ...]]:
    """The keys of every command.

    A change wins over the profile, and the profile over what commands declare: a key that one of
    them gives to a command is taken from whoever else has it.
    """
    keys = dict(defaults)
    for layer in (profile_keys(own.profile), own.changes):
        taken = {key for given in layer.values() for key in given}
        keys = {name: tuple(k for k in had if k not in taken) for name, had in keys.items()}
        keys |= {name: given for name, given in layer.items() if name in keys}
    return keys
