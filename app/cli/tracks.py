"""Tracks from whatever a command is pointed at: a session, MOT text, a recording with truth."""

from __future__ import annotations

from contextlib import closing
from dataclasses import dataclass
from pathlib import Path

from tracking.errors import FormatError
from tracking.formats import read_mot
from tracking.tracks import Columns

_HDF5 = b"\x89HDF\r\n\x1a\n"
_TRUTH = "truth.txt"


@dataclass(frozen=True, slots=True)
class Tracks:
    """Tracks and what they came from.

    Attributes:
        columns: at least `frame, track`, boxes and floor positions.
        frames: length of the recording; 0 where the file does not say.
        is_text: from MOT text, whose `conf` 0 marks don't-cares in truth.
    """

    columns: Columns
    frames: int
    is_text: bool


def tracks_at(path: Path) -> Tracks:
    """The tracks of a session (as corrected) or of MOT text, told apart by content.

    Raises:
        FormatError, SessionError: it is neither, or cannot be read.
    """
    if path.is_dir():
        raise FormatError(f"{path} is a folder; name a session or MOT text in it")
    if is_session(path):
        return _of_session(path)
    return Tracks(read_mot(path), 0, is_text=True)


def truth_at(path: Path) -> Tracks:
    """The same, where a recording's folder stands for its truth.

    Raises:
        FormatError: there is no truth in the folder.
    """
    if not path.is_dir():
        return tracks_at(path)
    if not (path / _TRUTH).is_file():
        raise FormatError(f"{path} has no {_TRUTH}; name a session or MOT text as truth")
    return Tracks(read_mot(path / _TRUTH), 0, is_text=True)


def is_session(path: Path) -> bool:
    """Whether the file is meant to be a session: HDF5 inside, or an ending that says so."""
    if path.suffix.lower() in (".h5", ".hdf5"):
        return True
    try:
        with path.open("rb") as stream:
            return stream.read(len(_HDF5)) == _HDF5
    except OSError as error:
        raise FormatError(f"cannot read {path}: {error.strerror}; check the path") from error


def _of_session(path: Path) -> Tracks:
    from tracking.session import Session

    with closing(Session.open(path)) as session:
        return Tracks(session.tracks.columns(), session.recording.frame_count, is_text=False)
