"""Whatever holds tracks, as columns."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

from tracking.errors import FormatError
from tracking.formats import Filmed, begins_as_hdf5, format_of, measurable
from tracking.library.paths import AnyPath, as_path
from tracking.recording import Recording
from tracking.session import Session
from tracking.tracks import Columns, Run, TrackTable

TRUTH = "truth.txt"
"""Beside a recording."""
Tracks = Session | Run | TrackTable | AnyPath
"""What holds tracks: a session's are the corrected ones; files are sessions and tracks of tools."""


@dataclass(frozen=True, slots=True, eq=False)
class Table:
    """Tracks.

    Attributes:
        columns: by frame then track. frames: of the footage; 0: not known.
        dont_cares: rows of confidence 0 do not count.
    """

    columns: Columns
    frames: int = 0
    dont_cares: bool = False


def table_of(tracks: Tracks | Recording) -> Table:
    """The tracks of anything that holds some; of a recording the truth beside it.

    Raises FormatError or SessionError where a file cannot be read or has invalid rows.
    """
    if isinstance(tracks, Session):
        return Table(tracks.tracks.columns(), tracks.recording.frame_count)
    if isinstance(tracks, Run):
        return Table(tracks.tracks, tracks.frames[1])
    if isinstance(tracks, TrackTable):
        return Table(tracks.columns(), tracks.frame_stop)
    if isinstance(tracks, Recording):
        return _of_file(tracks.folder / TRUTH)
    if not isinstance(tracks, str | os.PathLike):
        raise FormatError(
            "{kind} holds no tracks; give a session, a run, a table or a path",
            kind=type(tracks).__name__,
        )
    return _at(as_path(tracks))


def _at(path: Path) -> Table:
    """The tracks of a file, or of the truth in a recording's folder."""
    if (path / TRUTH).is_file():
        return _of_file(path / TRUTH)
    if not path.exists():
        raise FormatError("{path}: there is no such file; check the path", path=path)
    return _of_session(path) if _is_session(path) else _of_file(path)


def _is_session(path: Path) -> bool:
    """Whether it is HDF5 of no other tool."""
    if path.is_dir() or not begins_as_hdf5(path):
        return False
    try:
        format_of(path)
    except FormatError:
        return True
    return False


def _of_session(path: Path) -> Table:
    session = Session.look_into(path)
    try:
        return Table(session.tracks.columns(), session.recording.frame_count)
    finally:
        session.close()


def _of_file(path: Path) -> Table:
    found = measurable(path, format_of(path), Filmed()).all_of(path)
    return Table(found.columns, found.frames or 0, found.dont_cares)
