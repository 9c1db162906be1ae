"""Reading sessions."""

from __future__ import annotations

from tracking.library.paths import AnyPath, as_path
from tracking.session import Session


def read_session(path: AnyPath, *, read_only: bool = False, author: str | None = None) -> Session:
    """Open a session file, with the edits that were made after it was saved last.

    Args:
        path: the session, NAME.h5.
        read_only: nothing beside the file is claimed: others may write it meanwhile.
        author: who the log of edits names; None: the user of this computer.

    Returns:
        The session: `tracks` with `columns()`, `runs`, `labels`, `history`; `undo()`, `redo()`,
        `save()` and `close()`.

    Raises:
        SessionError: it is missing, no session, damaged, or made by a newer program.
    """
    place = as_path(path)
    return Session.look_into(place) if read_only else Session.open(place, author=author)
