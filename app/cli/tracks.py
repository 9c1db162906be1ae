"""Tracks from whatever a command is pointed at: a session, MOT text, a recording with truth."""

from __future__ import annotations

from contextlib import closing
from dataclasses import dataclass
from pathlib import Path

from app.cli.destination import is_session
from tracking.errors import FormatError
from tracking.failure import TRUE_PARTS
from tracking.formats import read_mot
from tracking.tracks import Columns

_TRUTH = "truth.txt"


@dataclass(frozen=True, slots=True)
class Tracks:
    """Tracks and what they came from.

    Attributes:
        columns: at least `frame, track`, boxes and floor positions.
        frames: length of the recording; 0 where the file does not say.
        is_text: from MOT text, whose `conf` 0 marks don't-cares in truth.
        parts: of the people's bodies, where the tracks are a session's whose tracker followed them.
        tracked: half-open range of frames a session's tracker went over; None where nobody knows.
    """

    columns: Columns
    frames: int
    is_text: bool
    parts: FollowedParts | None = None
    tracked: tuple[int, int] | None = None


@dataclass(frozen=True, slots=True)
class FollowedParts:
    """Body parts and what is to be known of the footage they are in.

    Attributes:
        columns: `frame, track, part, cx, cy, width, height`, a row each part.
        size_px, fps: of the recording.
    """

    columns: Columns
    size_px: tuple[int, int]
    fps: float


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


def _of_session(path: Path) -> Tracks:
    from tracking.session import Session, corrected_parts

    with closing(Session.open(path)) as session:
        footage, parts = session.recording, corrected_parts(session)
        followed = FollowedParts(parts, footage.size, footage.fps) if len(parts["frame"]) else None
        run, columns = session.corrected_run, session.tracks.columns()
        tracked = None if run is None else run.frames
        return Tracks(columns, footage.frame_count, is_text=False, parts=followed, tracked=tracked)


def part_truth_beside(path: Path) -> Path | None:
    """The folder with the truth of body parts that stands beside a truth; None: there is none."""
    folder = path if path.is_dir() else path.parent
    known = (path.is_dir() or not is_session(path)) and (folder / TRUE_PARTS).exists()
    return folder if known else None
