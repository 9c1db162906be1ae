"""Where a truth comes from, and how it is read."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import closing
from dataclasses import dataclass
from enum import Enum
from pathlib import Path

import numpy as np

from app.core.document.recording_match import refuse_other_recording
from app.core.document.track_sources import name_of_run
from app.core.i18n import tr
from tracking.errors import FormatError, SessionError
from tracking.formats import FORMATS, Filmed, Measurable, format_of, is_hdf5, measurable
from tracking.formats.read_result import in_order, positive_ids, with_all_columns
from tracking.formats.track_format import HEAD_BYTES
from tracking.recording import Recording
from tracking.scoring import ScoringTable
from tracking.session import Session
from tracking.tracks import Columns, TrackTable
from tracking.translation import Message, count_msg, msg


class TruthKind(Enum):
    """What a truth is."""

    BESIDE = "beside"
    FILE = "file"
    RUN = "run"


@dataclass(frozen=True, slots=True)
class TruthSource:
    """Where a truth comes from. Two that are equal are the same truth.

    Attributes:
        kind: BESIDE the recording, a FILE that somebody chose, or a RUN of the session.
        path: of the file. run: number of the run.
        changed_ns: when the file was written last; another one is another truth.
    """

    kind: TruthKind
    path: Path | None = None
    run: int = -1
    changed_ns: int = 0

    @classmethod
    def of_file(cls, path: Path, kind: TruthKind = TruthKind.FILE) -> TruthSource:
        """A file as it is by now."""
        try:
            changed_ns = path.stat().st_mtime_ns
        except OSError:
            changed_ns = 0  # reading it tells why
        return cls(kind, path, changed_ns=changed_ns)

    @property
    def is_run(self) -> bool:
        """Whether it is one of the session's own runs."""
        return self.kind is TruthKind.RUN


@dataclass(frozen=True, slots=True, eq=False)
class Truth:
    """A truth that was read.

    Attributes:
        source: where from. table: for scoring. people: those that count, to be drawn.
        notes: what the user should know of it, a line each.
    """

    source: TruthSource
    table: ScoringTable
    people: TrackTable
    notes: tuple[Message, ...] = ()


def capture_truth(
    source: TruthSource, recording: Recording, own: Session | None
) -> Callable[[], Truth]:
    """Takes hold of what is asked of the open document; what it gives may run on any thread.

    It raises FormatError or SessionError where there is no truth in the file.
    """
    if source.is_run and own is not None:
        run = own.runs[source.run]
        return lambda: _truth(source, run.tracks)
    path, reference = source.path, own.recording if own is not None else None
    assert path is not None
    filmed = Filmed(recording.frame_count, recording.fps, recording.size, recording.view)

    def read() -> Truth:
        try:
            kind = format_of(path)
        except FormatError:
            if _is_blank(path):
                return _of_file(source, measurable(path, FORMATS["mot"], filmed))
            if not is_hdf5(path):
                raise
            with closing(Session.open(path)) as session:
                if reference is not None:
                    refuse_other_recording(reference, session.recording, path.name)
                return _truth(source, session.tracks.snapshot().columns())
        return _of_file(source, measurable(path, kind, filmed))

    return read


def _is_blank(path: Path) -> bool:
    """Whether nothing is written in a file: MOT text in which nobody is, as on the command line."""
    try:
        return path.stat().st_size <= HEAD_BYTES and not path.read_bytes().strip()
    except OSError:
        return False  # why it cannot be read is told by whoever finds its format


def _of_file(source: TruthSource, found: Measurable) -> Truth:
    """What does not count stays out of the people."""
    notes = list(found.notes)
    if found.bad_count:
        first = found.bad_rows[0]
        left_out = count_msg(found.bad_count, "{n} row is left out", "{n} rows are left out")
        notes.append(
            msg(
                "{left_out}: {place}: {reason}",
                left_out=left_out,
                place=first.place,
                reason=first.reason,
            )
        )
    if found.bad_count and not len(found.columns["frame"]):
        raise FormatError(
            "{path} has no rows that can be read; choose another ground truth", path=source.path
        )
    return _truth(source, found.columns, tuple(notes), dont_cares=found.dont_cares)


def _truth(
    source: TruthSource,
    columns: Columns,
    notes: tuple[Message, ...] = (),
    *,
    dont_cares: bool = False,
) -> Truth:
    """A truth of rows by frame; of ids from 0 the 0 becomes the one after the highest."""
    columns = {**columns, "track": positive_ids(columns["track"])[0]}
    table = ScoringTable.from_columns(columns, dont_cares=dont_cares)
    if dont_cares:
        people = {name: np.asarray(column)[table.counted] for name, column in columns.items()}
        columns = with_all_columns(people)
    return Truth(source, table, TrackTable(in_order(columns)), notes)


def name_of(source: TruthSource, session: Session | None) -> str:
    """What the source is called."""
    if source.is_run:
        runs = session.runs if session is not None else ()
        tracker = runs[source.run].tracker if source.run < len(runs) else ""
        return name_of_run(source.run, tracker)
    name = source.path.name if source.path is not None else ""
    if source.kind is TruthKind.BESIDE:
        return tr("{name} beside the recording", name=name)
    return name


def refuse_own(path: Path, own: Session) -> None:
    """A session is no truth for itself.

    Raises:
        SessionError: the file is the open session.
    """
    if own.path is not None and path.resolve() == own.path.resolve():
        raise SessionError(
            "{name} is the open session itself; choose another ground truth", name=path.name
        )
