"""Tracks from what a command is pointed at: a session, any file of tracks, a recording's truth."""

from __future__ import annotations

from contextlib import closing
from dataclasses import dataclass
from pathlib import Path

from app.cli.destination import is_session
from app.cli.sessions import open_session
from tracking.errors import FormatError
from tracking.formats import FORMATS, Filmed, TrackFormat, format_of, measurable
from tracking.tracks import Columns, CountingLine
from tracking.translation import Message, msg
from tracking.truth import TRUE_PARTS

_TRUTH = "truth.txt"


@dataclass(frozen=True, slots=True)
class Tracks:
    """Tracks and what they came from.

    Attributes:
        columns: at least `frame, track`, boxes and floor positions.
        frames: length of the recording; 0 where the file does not say.
        is_text: from a file of tracks; else a session.
        path: of the file.
        parts: of the people's bodies, where the tracks are a session's whose tracker followed them.
        tracked: half-open range of frames a session's tracker went over; None where nobody knows.
        fps, size_px: of the recording, where the file tells.
        lines: counting lines drawn in a session.
        notes: what the user should know of a file, a line each.
        dont_cares: in a truth, rows of confidence 0 are not counted.
        recording, tracker: names a session has them by.
        detections: the files of another program's detections that a session's tracker was given.
        rough: metres come from a rough calibration.
    """

    columns: Columns
    frames: int
    is_text: bool
    path: Path
    parts: FollowedParts | None = None
    tracked: tuple[int, int] | None = None
    fps: float | None = None
    size_px: tuple[int, int] | None = None
    lines: tuple[CountingLine, ...] = ()
    notes: tuple[Message, ...] = ()
    dont_cares: bool = False
    recording: str | None = None
    tracker: str | None = None
    detections: tuple[str, ...] = ()
    rough: bool = False


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


def tracks_at(path: Path, filmed: Filmed | None = None) -> Tracks:
    """The tracks of a session (as corrected) or of a file of tracks, told apart by content.

    A folder of a format that keeps a file a frame is one file of tracks.

    Args:
        filmed: what is known of the recording, and what the user says of a text of places.

    Raises:
        FormatError, SessionError: it is neither, or cannot be read.
    """
    kind = _format_of(path)
    if kind is None and path.is_dir():
        raise FormatError("{path} is a folder; name a session or a file of tracks in it", path=path)
    if kind is None and is_session(path):
        return _of_session(path)
    # What nobody knows is read as MOT text, which says what is wrong with it.
    return _of_file(path, kind or FORMATS["mot"], filmed or Filmed())


def truth_at(path: Path, filmed: Filmed | None = None) -> Tracks:
    """The same, where a recording's folder stands for its truth.

    Raises:
        FormatError: there is no truth in the folder.
    """
    if (path / _TRUTH).is_file():
        return _of_file(path / _TRUTH, FORMATS["mot"], Filmed())
    if path.is_dir() and _format_of(path) is None:
        raise FormatError(
            "{path} has no {file}; name a session or a file of tracks as ground truth",
            path=path,
            file=_TRUTH,
        )
    return tracks_at(path, filmed)


def is_in_percent(path: Path) -> bool:
    """Whether it is a file of tracks whose boxes are told in percent of the pictures."""
    kind = _format_of(path)
    return kind is not None and kind.in_percent and not (path / _TRUTH).is_file()


def _format_of(path: Path) -> TrackFormat | None:
    """The format of a file or folder of tracks; None for sessions and what nobody knows."""
    try:
        return format_of(path)
    except FormatError:
        return None


def _of_file(path: Path, kind: TrackFormat, filmed: Filmed) -> Tracks:
    """The tracks of a file. Raises FormatError also where a single row is invalid."""
    found = measurable(path, kind, filmed).all_of(path)
    return Tracks(
        found.columns,
        found.frames or 0,
        is_text=True,
        path=path,
        fps=found.fps,
        size_px=found.size_px,
        notes=found.notes,
        dont_cares=found.dont_cares,
    )


def _of_session(path: Path) -> Tracks:
    from tracking.session import corrected_parts

    with closing(open_session(path)) as session:
        footage, parts = session.recording, corrected_parts(session)
        followed = FollowedParts(parts, footage.size, footage.fps) if len(parts["frame"]) else None
        run, columns = session.corrected_run, session.tracks.columns()
        tracked = None if run is None else run.frames
        return Tracks(
            columns,
            footage.frame_count,
            is_text=False,
            path=path,
            parts=followed,
            tracked=tracked,
            fps=footage.fps,
            size_px=footage.size,
            lines=tuple(session.labels.lines),
            recording=footage.name,
            tracker=None if run is None else run.tracker,
            detections=tuple(given.file for given in session.detections_input),
            rough=footage.is_rough,
            notes=(rough_note(),) if footage.is_rough else (),
        )


def rough_note() -> Message:
    """What is said wherever metres of a rough calibration are shown."""
    return msg("rough calibration: metres may be off by a tenth and more")


def part_truth_beside(path: Path) -> Path | None:
    """The folder with the truth of body parts that stands beside a truth; None: there is none."""
    folder = path if path.is_dir() else path.parent
    known = (path.is_dir() or not is_session(path)) and (folder / TRUE_PARTS).exists()
    return folder if known else None
