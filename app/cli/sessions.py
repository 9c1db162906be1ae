"""Sessions that a command reads, and what of them is told."""

from __future__ import annotations

import logging
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from app.cli.output import say
from tracking.errors import SessionError
from tracking.translation import N_, msg

if TYPE_CHECKING:
    from tracking.session import Session

_LOGGER = "tracking.session.notes"
"""That of `tracking.session.notes`, which takes too long to import for a page of help."""


@contextmanager
def print_notes() -> Iterator[None]:
    """What is found out of sessions while the block runs is on stderr, a line for each note.

    The only place that tells it: whatever a command reads a session by, damage is told.
    """
    log, notes = logging.getLogger(_LOGGER), _Notes()
    log.addHandler(notes)
    try:
        yield
    finally:
        log.removeHandler(notes)


def refuse_read_only(
    session: Session, path: Path, cannot: str = N_("{path} cannot be changed: {why}")
) -> None:
    """Raise SessionError, with the template `cannot`, where the session is only to be read."""
    if session.read_only:
        why = session.why_read_only.removeprefix(f"{session.path}: ")
        raise SessionError(cannot, path=path, why=why)


class _Notes(logging.Handler):
    """Says each note once, however often the command reads the session."""

    def __init__(self) -> None:
        super().__init__()
        self._said: set[str] = set()

    def emit(self, record: logging.LogRecord) -> None:
        note = record.msg  # a message
        if note not in self._said:
            self._said.add(note)
            say(msg("note: {note}", note=note))


def open_session(path: Path) -> Session:
    """The session to be read only, with the edits that wait in its journal.

    Nothing beside it is claimed or changed: another program may have it open.
    Raises SessionError as `Session.open` does.
    """
    from tracking.session import Session  # takes long to import

    return Session.look_into(path)
