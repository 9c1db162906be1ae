"""Correcting tracks."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Final

from tracking.editing import (
    Change,
    Entry,
    plan_delete,
    plan_mark_reviewed,
    plan_merge_tracks,
    plan_reassign,
    plan_rename,
    plan_split,
    plan_swap,
)
from tracking.errors import EditError
from tracking.session import Session
from tracking.translation import joined

Plan = Callable[..., Change]
_OF_TRACKS: Final[Mapping[str, Plan]] = {
    "swap": plan_swap,
    "split": plan_split,
    "reassign": plan_reassign,
    "delete": plan_delete,
}
"""What is planned from the table alone."""


def _merge(session: Session, into: int, *others: int, **wish: Any) -> Change:
    return plan_merge_tracks(session.tracks, into, list(others), labels=session.labels, **wish)


def _rename(session: Session, track: int, name: str) -> Change:
    return plan_rename(session.tracks, session.labels, track, name)


def _reviewed(session: Session, track: int, start: int, end: int) -> Change:
    return plan_mark_reviewed(session.labels, track, start, end, session.tracks)


_OF_SESSIONS: Final[Mapping[str, Plan]] = {
    "merge": _merge,
    "rename": _rename,
    "mark-reviewed": _reviewed,
}
KINDS: Final = (*_OF_TRACKS, *_OF_SESSIONS)
"""The kinds of edits that `edit` knows by name."""


def edit(session: Session, kind: str | Change, /, *what: Any, **more: Any) -> Entry:
    """Correct a session's tracks; the edit is in its log, and can be undone (`session.undo()`).

    Frames count from 0, ranges are half-open; an end that is left out is the track's last frame.

    - `edit(s, "swap", a, b, start, end)`: two people exchange their ids from a frame on.
    - `edit(s, "split", track, frame)`: from a frame on it is somebody new.
    - `edit(s, "reassign", track, to, start, end)`: rows of one person are another's.
    - `edit(s, "merge", into, other, ...)`: they are one person.
    - `edit(s, "delete", track, start, end)`: nobody was there.
    - `edit(s, "rename", track, name)`: who it is.
    - `edit(s, "mark-reviewed", track, start, end)`: a person has looked, and it is right.

    Args:
        session: open for writing. With a path, the edit is on disk when this returns.
        kind: of edit; or a `Change` that a planner of `tracking.editing` made.
        what, more: as above.

    Returns:
        The entry of the log: its number, time, author and text.

    Raises:
        EditError: it does not apply to the tracks as they are; nothing is changed then.
        OutputError: it cannot be put on disk; nothing is changed then.
    """
    if isinstance(kind, Change):
        return session.apply(kind)
    if kind in _OF_TRACKS:
        plan, first = _OF_TRACKS[kind], session.tracks
        return session.apply(_planned(kind, plan, first, *what, **more))
    if kind in _OF_SESSIONS:
        return session.apply(_planned(kind, _OF_SESSIONS[kind], session, *what, **more))
    raise EditError(
        "edit {kind!r} is unknown; choose one of: {kinds}", kind=kind, kinds=joined(", ", KINDS)
    )


def _planned(kind: str, plan: Plan, *what: Any, **more: Any) -> Change:
    """The change. Raises EditError where numbers are missing or not understood."""
    try:
        return plan(*what, **more)
    except TypeError as error:
        raise EditError(
            "edit {kind!r}: {error}; see help(tracking.edit)", kind=kind, error=error
        ) from error
