"""The edits that wait in a session's journal, looked at without touching anything."""

from __future__ import annotations

import contextlib
import os
import shutil
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from tracking.editing import History
from tracking.errors import EditError, OutputError, SessionError, UnsafeFileError
from tracking.owned_files import check_folder, open_file
from tracking.session.edited_tracks import EditedTracks
from tracking.session.image import Snapshot, Stamps
from tracking.session.journal import ENDINGS, Journal, Step
from tracking.session.journal_files import JOURNAL, NEXT, are_there, find_main, list_set_aside
from tracking.session.journal_limits import MOST_BYTES, MOST_COUNT_BYTES
from tracking.session.journal_sizes import files_to_copy
from tracking.session.notes import MAY_MISS, tell_damage
from tracking.session.recovery import MissingSteps, explain_misfit, find_missing_steps
from tracking.session.session_reader import read_session
from tracking.session.session_writer import companions, file_state
from tracking.translation import Message, count_msg, msg

_MOST_KEPT = 5
"""Journals kept aside that are looked through when a session is opened."""
_TRIES = 5
"""Looks at a journal that another program is writing to, before it counts as damaged."""


@dataclass(frozen=True, slots=True)
class ReadSession:
    """A session as it would open now.

    Attributes:
        snapshot: as it was saved; its tables are those of `edited`.
        edited: with the steps that only the journal holds. waiting: how many these are.
        damage: what may be missing of them, in lines that were told (see `notes`).
    """

    snapshot: Snapshot
    edited: EditedTracks
    waiting: int = 0
    damage: tuple[Message, ...] = ()


def notes_on_kept(path: Path, stamps: Stamps, history: History) -> dict[Path, Message]:
    """A line for each journal kept aside that holds edits of this save that the history lacks.

    Of a journal that cannot be read nothing is said: that was told when it was kept aside.
    """
    beside = list_set_aside(companions(path), _MOST_KEPT)
    known = {(one.id, one.time, one.author, one.text) for one in history} if beside else set()
    notes: dict[Path, Message] = {}
    for kept in beside:
        with (
            contextlib.suppress(SessionError, OutputError, OSError),
            _copied(kept) as journal,
        ):
            made = [
                one.entry for one in find_missing_steps(journal, stamps).steps if one.act == "apply"
            ]
            lost = sum((one.id, one.time, one.author, one.text) not in known for one in made)
            if lost:
                notes[kept] = count_msg(
                    lost,
                    "{n} edit made after the last save of {path} is not in it, but kept aside as "
                    "{kept}",
                    "{n} edits made after the last save of {path} are not in it, but kept aside as "
                    "{kept}",
                    path=path,
                    kept=kept,
                )
    return notes


def read_with_waiting(path: Path) -> ReadSession:
    """The session as it would open now; another program may have it open meanwhile.

    Raises SessionError where the session itself cannot be read, OutputError where the disk refuses
    to give the edits that wait, or to take a copy of them: that is no damage.
    """
    for tries_left in reversed(range(_TRIES)):
        before = _states(path)
        try:
            read = _read(path)
        except OutputError:
            if not tries_left or _states(path) == before:
                raise
            continue
        if not read.damage or _states(path) == before:  # else another program just wrote there
            break
    for note in read.damage:
        tell_damage(note)
    return read


def _read(path: Path) -> ReadSession:
    snapshot = read_session(path)
    edited = EditedTracks(snapshot.tracks, snapshot.labels, snapshot.history())
    steps: Sequence[Step] = ()
    made = 0
    try:
        missing = _missing(path, snapshot.stamps)
        steps, problem = missing.steps, missing.problem
        for step in steps:
            edited.replay(step.act, step.entry)
            made += 1
        note = (
            msg(
                "the journal of edits is damaged ({problem}): {may_miss}",
                problem=problem,
                may_miss=MAY_MISS,
            )
            if problem
            else Message()
        )
    except EditError as why:
        note = msg(
            "{misfit} ({why}): {may_miss}",
            misfit=explain_misfit(steps[made:]),
            why=why,
            may_miss=MAY_MISS,
        )
    except SessionError as why:
        note = msg("{reason}: {may_miss}", reason=why.reason, may_miss=MAY_MISS)
    except OSError as why:
        raise OutputError(
            "{path}: the edits that wait in its journal cannot be read ({reason})",
            "make room in the folder for temporary files, then try again",
            path=path,
            reason=why.strerror or why,
        ) from why
    return ReadSession(snapshot, edited, made, (note,) if note else ())


def may_wait(path: Path, stamps: Stamps) -> bool:
    """Whether edits, or what is left of a journal that had some, wait beside a session."""
    try:
        missing = _missing(path, stamps)
    except (SessionError, OutputError, OSError):
        return True
    return bool(missing.steps or missing.problem)


def read_history(path: Path) -> History:
    """The log of edits as the session would open now, whoever has it open.

    Raises SessionError and OutputError as `read_with_waiting`.
    """
    return read_with_waiting(path).edited.history


def edits_wait(path: Path) -> bool:
    """Whether edits may wait beside a session, in its journal or in what is left of one.

    They may, too, where the folder there is another user's, or a link, which nobody follows.
    """
    try:
        if not _lies_beside(path):
            return False
        with _copied(find_main(companions(path))) as journal:
            return journal.may_have_steps
    except (SessionError, OutputError, OSError):
        return True


def last_worked_on_s(path: Path) -> float:
    """When somebody saved or edited a session last, in seconds of the clock; 0: it is gone."""
    beside = companions(path) / JOURNAL
    return max(map(_written_s, (path, beside, beside.with_name(f"{JOURNAL}-wal"))))


def _written_s(file: Path) -> float:
    try:
        return file.stat().st_mtime
    except OSError:  # another window has just saved or dropped it
        return 0.0


def _missing(path: Path, stamps: Stamps) -> MissingSteps:
    """The steps that wait. Raises SessionError, OutputError or OSError where nobody can tell."""
    if not _lies_beside(path):
        return MissingSteps()
    with _copied(find_main(companions(path))) as journal:
        return find_missing_steps(journal, stamps)


def _lies_beside(path: Path) -> bool:
    """Whether files of a journal lie beside a session, in a folder of the user's own."""
    try:
        check_folder(companions(path))
    except FileNotFoundError:
        return False
    return are_there(companions(path))


def _states(path: Path) -> list[tuple[int, int, int] | None]:
    """What changes when another program saves the session or writes into its journal."""
    beside = companions(path)
    files = [beside / f"{name}{ending}" for name in (JOURNAL, NEXT) for ending in ENDINGS]
    return [file_state(file) for file in (path, *files)]


@contextmanager
def _copied(main: Path) -> Iterator[Journal]:
    """A copy of a journal beside a session: reading the journal itself would write beside it."""
    check_folder(main.parent)
    endings = files_to_copy(main)
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / JOURNAL
        # It must not count steps that the log comes to after it, so it is first.
        with contextlib.suppress(UnsafeFileError):
            _copy(main, copy, "-count", MOST_COUNT_BYTES)
        for ending in endings:
            _copy(main, copy, ending, MOST_BYTES)
        try:
            with contextlib.closing(Journal(copy)) as journal:
                yield journal
        except (SessionError, OutputError) as why:  # of the copy, which nobody knows

            def named(value: object) -> object:
                of_file = isinstance(value, str | Path)
                return str(value).replace(str(copy), str(main)) if of_file else value

            raise type(why)(why.reason.with_values(named), why.to_do) from why


def _copy(main: Path, copy: Path, ending: str, most_bytes: int) -> None:
    """Copy a file of the journal, of a size that such a one has, where it is there."""
    with contextlib.suppress(FileNotFoundError):
        handle = open_file(main.with_name(f"{main.name}{ending}"), most_bytes=most_bytes)
        target = copy.with_name(f"{copy.name}{ending}")
        with os.fdopen(handle, "rb") as source, target.open("wb") as file:
            shutil.copyfileobj(source, file)
