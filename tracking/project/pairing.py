"""Which session is of which recording, and what a project's list says of both."""

from __future__ import annotations

import os
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from tracking.batch.outcome import Outcome
from tracking.project.fact_store import KnownFacts
from tracking.project.facts import NO_MESSAGE, RecordingFacts, SessionFacts
from tracking.project.folder_scan import FolderScan, ScannedFile
from tracking.translation import Message, msg


@dataclass(frozen=True, slots=True)
class SessionRow:
    """A session of a project.

    Attributes:
        file: of it. facts: None: they are still to be read.
        worked_on_s: when somebody saved or edited it last, by the clock; 0: not known.
        holder: who has it open; "": nobody.
        note: what is odd about it, in words.
    """

    file: ScannedFile
    facts: SessionFacts | None = None
    worked_on_s: float = 0.0
    holder: str = ""
    note: Message = NO_MESSAGE

    @property
    def path(self) -> Path:
        """Of its file."""
        return self.file.path

    @property
    def is_readable(self) -> bool:
        """Whether it was read, and could be."""
        return self.facts is not None and not self.facts.problem


@dataclass(frozen=True, slots=True)
class ProjectRow:
    """A recording of a project with its sessions; or a session whose recording is elsewhere.

    Attributes:
        name: where it lies below the project's folder; unlike all others.
        recording: None: it is not in the folder.
        facts: of the recording; None: they are still to be read.
        sessions: the one to open first, see `ordered`.
        batch: what a batch in the folder says of it; None: nothing.
    """

    name: str
    recording: ScannedFile | None
    facts: RecordingFacts | None
    sessions: tuple[SessionRow, ...] = ()
    batch: Outcome | None = None

    @property
    def session(self) -> SessionRow | None:
        """The session that the list shows."""
        return self.sessions[0] if self.sessions else None

    @property
    def path(self) -> Path:
        """What is opened: the session where there is one that can be read, else the recording."""
        session = self.session
        if session is not None and (session.is_readable or self.recording is None):
            return session.path
        assert self.recording is not None
        return self.recording.path

    @property
    def is_read(self) -> bool:
        """Whether all is known of it that is to be known."""
        read = self.recording is None or self.facts is not None
        return read and all(one.facts is not None for one in self.sessions)

    @property
    def problem(self) -> Message:
        """Why something of it cannot be used; empty: all can."""
        if self.facts is not None and self.facts.problem:
            return self.facts.problem
        for one in self.sessions:
            if one.facts is not None and one.facts.problem:
                return msg("{name}: {why}", name=one.path.name, why=one.facts.problem)
        if self.batch is not None and not self.batch.is_done:
            return self.batch.why
        return Message()


@dataclass(frozen=True, slots=True)
class LedgerEntry:
    """What a batch knows. Attributes: session: its file. path: of the recording."""

    session: Path
    path: Path
    outcome: Outcome


def guess(scan: FolderScan, entries: Iterable[LedgerEntry]) -> dict[Path, Path]:
    """Which recording each session is probably of, before anything was read of it."""
    named = _Named(scan.recordings)
    known = {entry.session: entry.path for entry in entries}
    found: dict[Path, Path] = {}
    for file in scan.sessions:
        place = known.get(file.path) or named.around(file.path) or named.called(file.path.stem)
        if place is not None and place in named.paths:
            found[file.path] = place
    return found


def match_sessions(
    scan: FolderScan, known: Mapping[Path, KnownFacts], entries: Iterable[LedgerEntry]
) -> dict[Path, Path]:
    """Which recording each session is of; without sessions whose recording is elsewhere.

    First by the place that the session names; then as a batch says, by the folder it lies in or
    by its name, where the images are those; then by the images alone.
    """
    named = _Named(scan.recordings)
    by_footage = _by_footage(scan.recordings, known)
    by_batch = {entry.session: entry.path for entry in entries}
    unread = guess(scan, ())
    found: dict[Path, Path] = {}
    for file in scan.sessions:
        facts = _session_facts(known, file.path)
        if facts is None or facts.problem:
            place = by_batch.get(file.path) or unread.get(file.path)
        else:
            place = named.at(file.path.parent, facts) or next(
                (
                    one
                    for one in (by_batch.get(file.path), unread.get(file.path))
                    if _is_like(one, facts, known)
                ),
                by_footage.get(facts.footage),
            )
        if place is not None and place in named.paths:
            found[file.path] = place
    return found


def pair(
    scan: FolderScan,
    known: Mapping[Path, KnownFacts],
    entries: Sequence[LedgerEntry],
    sessions: Mapping[Path, SessionRow],
    author: str,
) -> list[ProjectRow]:
    """The rows of a project's list, by name.

    Args:
        scan: what is in the folder. known: what was read of it. entries: of batches.
        sessions: the rows of sessions by their paths.
        author: whose session of several is shown.
    """
    of_session = match_sessions(scan, known, entries)
    by_recording: defaultdict[Path, list[SessionRow]] = defaultdict(list)
    alone: list[SessionRow] = []
    for file in scan.sessions:
        row = sessions[file.path]
        place = of_session.get(file.path)
        if place is None:
            alone.append(row)
        else:
            by_recording[place].append(_with_note(row, _recording_facts(known, place)))
    outcomes = {entry.path: entry.outcome for entry in entries}
    rows = [
        ProjectRow(
            _name(scan.folder, file.path),
            file,
            _recording_facts(known, file.path),
            ordered(by_recording[file.path], author),
            outcomes.get(file.path),
        )
        for file in scan.recordings
        if by_recording[file.path] or not _is_clip(known, file.path)
    ]
    rows += [ProjectRow(_name(scan.folder, row.path), None, None, (row,)) for row in alone]
    return sorted(rows, key=lambda row: row.name.casefold())


def ordered(sessions: Iterable[SessionRow], author: str) -> tuple[SessionRow, ...]:
    """Sessions with the one to open first: readable, one that you edited, worked on last."""

    def rank(row: SessionRow) -> tuple[bool, bool, float, str]:
        authors = row.facts.authors if row.facts is not None else ()
        own = bool(author) and author in authors
        return not row.is_readable, not own, -row.worked_on_s, str(row.path)

    return tuple(sorted(sessions, key=rank))


def _with_note(row: SessionRow, recording: RecordingFacts | None) -> SessionRow:
    facts = row.facts
    if facts is None or facts.problem or recording is None or recording.problem:
        return row
    if facts.footage == recording.footage:
        return row
    note = msg("the images are not those that the session was made of")
    return SessionRow(row.file, facts, row.worked_on_s, row.holder, note)


class _Named:
    """Recordings by where they are."""

    def __init__(self, recordings: Sequence[ScannedFile]) -> None:
        self.paths = {file.path for file in recordings}
        self._by_stem: defaultdict[str, list[Path]] = defaultdict(list)
        self._in_folder: defaultdict[Path, list[Path]] = defaultdict(list)
        for path in self.paths:
            self._by_stem[path.stem.casefold()].append(path)
            self._in_folder[path.parent].append(path)

    def around(self, session: Path) -> Path | None:
        """The recording in whose folder a session lies."""
        return session.parent if session.parent in self.paths else None

    def called(self, stem: str) -> Path | None:
        """The only recording of a name."""
        return _only(self._by_stem.get(stem.casefold(), ()))

    def at(self, folder: Path, facts: SessionFacts) -> Path | None:
        """The recording at the place that a session in a folder names; the path is not opened."""
        try:
            place = Path(os.path.normpath(folder / facts.place))
        except ValueError:
            return None
        if place in self.paths:
            return place
        here = [one for one in self._in_folder.get(place, ()) if one.stem == facts.name]
        return _only(here)


def _only(paths: Sequence[Path]) -> Path | None:
    return paths[0] if len(paths) == 1 else None


def _is_like(place: Path | None, facts: SessionFacts, known: Mapping[Path, KnownFacts]) -> bool:
    """Whether the images that are known to be at a place are a session's."""
    there = None if place is None else _recording_facts(known, place)
    return there is not None and there.footage == facts.footage


def _by_footage(
    recordings: Sequence[ScannedFile], known: Mapping[Path, KnownFacts]
) -> dict[str, Path]:
    """Recordings whose images no other one has."""
    found: defaultdict[str, list[Path]] = defaultdict(list)
    for file in recordings:
        facts = _recording_facts(known, file.path)
        if facts is not None and facts.footage:
            found[facts.footage].append(file.path)
    return {footage: paths[0] for footage, paths in found.items() if len(paths) == 1}


def _recording_facts(known: Mapping[Path, KnownFacts], path: Path) -> RecordingFacts | None:
    facts = known[path].facts if path in known else None
    return facts if isinstance(facts, RecordingFacts) else None


def _is_clip(known: Mapping[Path, KnownFacts], path: Path) -> bool:
    facts = _recording_facts(known, path)
    return facts is not None and facts.is_clip


def _session_facts(known: Mapping[Path, KnownFacts], path: Path) -> SessionFacts | None:
    facts = known[path].facts if path in known else None
    return facts if isinstance(facts, SessionFacts) else None


def _name(folder: Path, path: Path) -> str:
    return path.name if path == folder else path.relative_to(folder).as_posix()
