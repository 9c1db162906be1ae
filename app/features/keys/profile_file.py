"""Keys in a file: a profile of the user's own, to take to another machine or person."""

from __future__ import annotations

import json
import tomllib
from collections import Counter
from collections.abc import Collection, Mapping
from pathlib import Path

from PySide6.QtGui import QKeySequence

from app.features.keys.scene import OURS, SHIPPED, OwnKeys
from tracking.errors import FormatError, explain_unreadable
from tracking.owned_files import read_file
from tracking.translation import joined, message_of, msg

_MOST_BYTES = 1 << 20
_MOST_KEYS = 8
"""Of one command."""
_PORTABLE = QKeySequence.SequenceFormat.PortableText


def read_profile(path: Path, commands: Collection[str]) -> OwnKeys:
    """The profile in a file as `profile_text` makes it.

    Args:
        commands: ids that are known here.

    Raises:
        FormatError: it cannot be read, or is no profile.
    """
    try:
        with explain_unreadable(path):
            text = read_file(path, _MOST_BYTES).decode("utf-8")
        return parse_profile(text, commands)
    except (ValueError, RecursionError) as error:
        raise FormatError(
            "{path} is no profile of keys: {why}; export one to see how it is written",
            path=path,
            why=message_of(error),
        ) from error


def parse_profile(text: str, commands: Collection[str]) -> OwnKeys:
    """The profile in a text. Raises ValueError where it is none; see `read_profile`."""
    told = tomllib.loads(text)
    profile, changes = told.get("profile", OURS), _keys_in(told)
    if not isinstance(profile, str) or profile not in SHIPPED:
        known = joined(", ", [f'"{name}"' for name in SHIPPED])
        raise ValueError(msg("known profiles to build on are {known}", known=known))
    known_here = {name: given for name, given in changes.items() if name in commands}
    return OwnKeys(profile, known_here, tuple(sorted(set(changes) - set(known_here))))


def profile_text(own: OwnKeys) -> str:
    """A profile as the text of a file."""
    lines = [f"profile = {json.dumps(own.profile)}", "", "[keys]"]
    for command, keys in sorted(own.changes.items()):
        lines.append(f"{json.dumps(command)} = {json.dumps(list(keys))}")
    return "\n".join(lines) + "\n"


def key_text(key: QKeySequence) -> str:
    """One key in Qt's portable text; "" where it is none."""
    return key.toString(_PORTABLE) if key.count() == 1 else ""


def _keys_in(told: Mapping[str, object]) -> dict[str, tuple[str, ...]]:
    table = told.get("keys")
    if not isinstance(table, dict):
        raise ValueError(msg("it has no table [keys]"))
    keys = {str(name): _given(str(name), given) for name, given in table.items()}
    counts = Counter(key for given in keys.values() for key in given)
    twice = next((key for key, count in counts.items() if count > 1), "")
    if twice:
        raise ValueError(msg("{key} is given to two commands", key=twice))
    return keys


def _given(command: str, given: object) -> tuple[str, ...]:
    if not isinstance(given, list) or len(given) > _MOST_KEYS:
        raise ValueError(
            msg("{command} needs a list of at most {n} keys", command=command, n=_MOST_KEYS)
        )
    return tuple(dict.fromkeys(_key(command, key) for key in given))


def _key(command: str, key: object) -> str:
    """A key as Qt writes it."""
    sequence = QKeySequence.fromString(key if isinstance(key, str) else "", _PORTABLE)
    text = key_text(sequence)
    if not text:
        raise ValueError(msg("{key} of {command} is no key", key=repr(key), command=command))
    return text
