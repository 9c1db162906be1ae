"""Sessions that a batch must not replace: somebody corrected them, or has them open."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

from tracking.batch.signature import file_state
from tracking.errors import OutputError, SessionError
from tracking.file_lock import SessionLock
from tracking.translation import Message, msg

NO_STATE = (0, 0, 0)
"""The state of a session that is not there."""


def state_of(session: Path) -> tuple[int, int, int]:
    """As `file_state`; `NO_STATE` where there is none."""
    return file_state(session) or NO_STATE


def why_protected(session: Path, *, own: bool) -> Message | None:
    """Why the session that stands there must not be replaced; None: it may.

    own: the batch made it, so that one that is damaged is made again.
    """
    if not session.exists():
        return None
    if session.is_symlink() or not session.is_file():
        return msg("{place} is no regular file", place=session.name)
    if _is_open(session):
        return msg("{place} is open; close it and run again", place=session.name)
    return _why_of_content(session, own=own)


def why_changed(session: Path, seen: tuple[int, ...]) -> Message | None:
    """Why a session must not be replaced though it was allowed before tracking; None: it may.

    seen: its state then, as `state_of`; (): it is replaced whatever became of it (`--force`).
    """
    if not seen:
        return None
    changed = msg(
        "{place} was changed or is open while it was tracked; run again", place=session.name
    )
    if state_of(session) != seen:
        return changed
    if seen == NO_STATE:
        return None
    from tracking.session.pending_edits import edits_wait  # takes long to import

    if _is_open(session):
        return changed
    return changed if edits_wait(session) and _why_of_content(session, own=True) else None


def _is_open(session: Path) -> bool:
    """Whether a program has the session open, or nobody can tell."""
    from tracking.session.session_writer import companions  # takes long to import

    try:
        return SessionLock(companions(session) / "lock").is_held
    except (OSError, SessionError):
        return True


def _why_of_content(place: Path, *, own: bool) -> Message | None:
    from tracking.session import Session  # takes long to import

    try:
        with closing(Session.look_into(place)) as session:
            if len(session.history):
                return msg(
                    "{place} was corrected, and is of other files or settings; move it away, "
                    "or replace it with --force",
                    place=place.name,
                )
            if len(session.runs) > 1:
                return msg(
                    "{place} has several runs; move it away, or replace it with --force",
                    place=place.name,
                )
    except (SessionError, OutputError) as error:
        if own:
            return None
        return msg("{place} is there and cannot be read: {why}", place=place.name, why=error)
    return None
