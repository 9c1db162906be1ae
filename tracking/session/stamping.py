"""When, by whom and with what a session was made or changed."""

from __future__ import annotations

import getpass
import uuid
from datetime import UTC, datetime
from importlib import metadata


def now() -> str:
    """This moment: UTC, ISO 8601 to the millisecond."""
    return datetime.now(UTC).isoformat(timespec="milliseconds")


def made_up() -> str:
    """A name nothing else bears: 32 hexadecimal digits."""
    return uuid.uuid4().hex


def software() -> str:
    """This program's name and version."""
    return f"trackwright {metadata.version('trackwright')}"


def author_named(named: str | None) -> str:
    """The author of edits as the caller says, else the account's name; "" where it has none."""
    if named is not None:
        return named
    try:
        return getpass.getuser()
    except (OSError, KeyError, ImportError):
        return ""
