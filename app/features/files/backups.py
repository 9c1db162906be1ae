"""Backups of a session in words: a list, and what differs from now."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from app.core.document.edit_history import local_time
from app.core.i18n import count_text, some_of, tr
from tracking.editing import Entry
from tracking.progress import Progress
from tracking.session import Backup, list_backups
from tracking.session.backups import read_backup
from tracking.tracks import Columns, TrackTable, row_keys

_LISTED = 6
_PLACE = ("left", "top", "width", "height", "x", "y")


@dataclass(frozen=True, slots=True)
class BackupLine:
    """One backup.

    Attributes:
        number: 1 is the newest. when, edits, tracks, size: in words.
        problem: why it cannot be restored; "" where it can.
    """

    number: int
    when: str
    edits: str
    tracks: str
    size: str
    problem: str = ""


def list_backup_lines(path: Path) -> tuple[BackupLine, ...]:
    """The backups that are kept, the newest first."""
    return tuple(_line(one) for one in list_backups(path))


def what_differs(
    path: Path, number: int, now: TrackTable, entries: Sequence[Entry], report: Progress
) -> tuple[str, ...]:
    """What would be different after a backup is restored, a line each.

    Raises:
        SessionError: it cannot be read. CancelledError: by `report`.
    """
    report(0, 2)
    _, then = read_backup(path, number)
    report(1, 2)
    lines = [*then.damage, *_edits_apart(entries, then.edits), *_tracks_apart(now, then.tracks)]
    report(2, 2)
    return tuple(lines) or (tr("Nothing: it equals the session as it is now."),)


def _line(one: Backup) -> BackupLine:
    return BackupLine(
        number=one.number,
        when=local_time(one.saved) if one.saved else tr("unknown"),
        edits=count_text(one.edits, "{n} edit", "{n} edits"),
        tracks=count_text(one.tracks, "{n} track", "{n} tracks"),
        size=_size(one.size_bytes),
        problem=tr(one.problem),
    )


def _size(size_bytes: int) -> str:
    if size_bytes < 1 << 20:
        return tr("{n} kB", n=max(1, round(size_bytes / 1024)))
    return tr("{n} MB", n=f"{size_bytes / (1 << 20):.1f}")


def _edits_apart(now: Sequence[Entry], then: Sequence[Entry]) -> list[str]:
    """Edits in force on one side only."""
    here = {(one.id, one.time): one for one in now if not one.undone}
    there = {(one.id, one.time): one for one in then if not one.undone}
    gone = [one for key, one in here.items() if key not in there]
    back = [one for key, one in there.items() if key not in here]
    lines = []
    if gone:
        lines.append(count_text(len(gone), "Without {n} edit:", "Without {n} edits:"))
        lines += _named(gone)
    if back:
        lines.append(
            count_text(
                len(back),
                "With {n} edit that is undone or gone now:",
                "With {n} edits that are undone or gone now:",
            )
        )
        lines += _named(back)
    return lines


def _named(entries: Sequence[Entry]) -> list[str]:
    """The latest of some edits by their lines."""
    lines = [f"    {tr(one.text)}" for one in reversed(entries[-_LISTED:])]
    more = len(entries) - _LISTED
    return [*lines, tr("    and {n} more", n=more)] if more > 0 else lines


def _tracks_apart(now: TrackTable, then: TrackTable) -> list[str]:
    """Tracks on one side only, and how many rows stand elsewhere or belong to others."""
    here, there = set(now.track_ids), set(then.track_ids)
    lines = []
    if here - there:
        lines.append(tr("Without the tracks {ids}", ids=_ids(here - there)))
    if there - here:
        lines.append(tr("With the tracks {ids}", ids=_ids(there - here)))
    rows = _rows_apart(now.columns(), then.columns())
    if rows:
        lines.append(count_text(rows, "{n} box is different", "{n} boxes are different"))
    return lines


def _ids(tracks: set[int]) -> str:
    return tr(some_of(sorted(tracks), _LISTED))


def _rows_apart(a: Columns, b: Columns) -> int:
    """Person-frames that only one side has, or that lie elsewhere in the other."""
    here, there = _keys(a), _keys(b)
    both, at_a, at_b = np.intersect1d(here, there, assume_unique=True, return_indices=True)
    moved = np.zeros(len(both), bool)
    for name in _PLACE:
        one, other = a[name][at_a], b[name][at_b]
        moved |= (one != other) & ~(np.isnan(one) & np.isnan(other))
    return len(here) + len(there) - 2 * len(both) + int(moved.sum())


def _keys(columns: Columns) -> NDArray[np.int64]:
    """One number a person-frame."""
    return row_keys(columns["frame"], columns["track"])
