"""Sessions opened for a command, which says what is damaged of them."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from app.cli.output import say

if TYPE_CHECKING:
    from tracking.session import Session


def opened_session(path: Path) -> Session:
    """The session, with a line on stderr for everything that is damaged or may be missing.

    Raises SessionError as `Session.open` does.
    """
    from tracking.session import Session  # takes long to import

    session = Session.open(path)
    for note in session.damage:
        say(f"note: {note}")
    return session
