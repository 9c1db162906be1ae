"""When, by whom and with what a session was made or changed."""

from __future__ import annotations

import getpass
import os
import uuid
from datetime import UTC, datetime
from importlib import metadata

AUTHOR_VARIABLE = "TRACKWRIGHT_AUTHOR"
"""The environment variable that names the author of edits."""
LONGEST_AUTHOR = 100


def now() -> str:
    """This moment: UTC, ISO 8601 to the millisecond."""
    return datetime.now(UTC).isoformat(timespec="milliseconds")


def make_id() -> str:
    """A name nothing else bears: 32 hexadecimal digits."""
    return uuid.uuid4().hex


def software() -> str:
    """This program's name and version."""
    return f"trackwright {metadata.version('trackwright')}"


def resolve_author(named: str | None) -> str:
    """The author of edits: as the caller says, else as the environment does, else the account.

    "" where none has a name. A name is one line of at most `LONGEST_AUTHOR` characters.
    """
    said = named if named is not None else os.environ.get(AUTHOR_VARIABLE, "").strip() or None
    if said is not None:
        line = " ".join(said.replace("\0", " ").split())[:LONGEST_AUTHOR]
        return line.encode("utf-8", "replace").decode("utf-8")
    try:
        return getpass.getuser()
    except (OSError, KeyError, ImportError):
        return ""
