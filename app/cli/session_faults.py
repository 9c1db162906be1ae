"""What keeps sessions from opening as they should: a lock that is held, edits in an old journal."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

from app.cli.installation_faults import Fault
from tracking.errors import OutputError, SessionError
from tracking.session.pending_edits import edits_wait, read_with_waiting
from tracking.session.store import is_open, lock_holder
from tracking.translation import Message, count_msg, message_of, msg

_SESSION = ".h5"


def recent_sessions() -> tuple[Path, ...]:
    """The sessions that the window opened last; none where Qt does not work."""
    try:
        from app.core.widgets.user_settings import UserSettings
    except ImportError:
        return ()
    return tuple(path for path in UserSettings().recent if path.suffix == _SESSION)


def find_session_faults(sessions: Iterable[Path]) -> Iterator[Fault]:
    """What is odd with each of them, and what to do about it; one that is gone is passed over."""
    for path in sessions:
        if path.is_file() and (said := _fault_of(path)) is not None:
            yield msg("session {name}", name=path.name), said, False


def _fault_of(path: Path) -> Message | None:
    try:
        if is_open(path):
            return msg(
                "{path} is open in {holder}; close it there first, or end that process",
                path=path,
                holder=lock_holder(path),
            )
        return _waiting(path) if edits_wait(path) else None
    except (OSError, SessionError, OutputError) as error:
        return msg("{reason}; restore a backup: trackwright restore", reason=message_of(error))


def _waiting(path: Path) -> Message | None:
    """What its journal holds that the session lacks."""
    read = read_with_waiting(path)
    if read.damage:
        return msg(
            "{path}: {damage}; open the session: the edits that fit are taken over, and the "
            "journal is kept aside",
            path=path,
            damage=read.damage[0],
        )
    if not read.waiting:
        return None
    return count_msg(
        read.waiting,
        "{path}: {n} edit is in its journal alone; open the session and save it",
        "{path}: {n} edits are in its journal alone; open the session and save it",
        path=path,
    )
