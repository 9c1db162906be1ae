"""The edits that wait in a session's journal, looked at without touching anything."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from tracking.editing import History
from tracking.errors import EditError, OutputError, SessionError
from tracking.session.edited import Edited
from tracking.session.image import Stamps
from tracking.session.journal import Journal, Step
from tracking.session.reading import read_session
from tracking.session.recovery import missing_steps
from tracking.session.saving import companions
from tracking.session.store import JOURNAL


def read_with_waiting(path: Path) -> tuple[Edited, int] | None:
    """The session as it would open now, and how many steps of it only the journal holds.

    None where nothing waits, or nothing that fits the file. Another program may have the session
    open meanwhile. Raises SessionError where the session itself cannot be read.
    """
    if not edits_wait(path):
        return None
    snapshot = read_session(path)
    edited = Edited(snapshot.tracks, snapshot.labels, snapshot.history())
    made = 0
    try:
        for step in _steps(path, snapshot.stamps):
            edited.replay(step.act, step.entry)
            made += 1
    except (EditError, SessionError, OutputError, OSError):
        pass  # opening the session tells of what does not fit, and keeps it aside
    return (edited, made) if made else None


def read_history(path: Path) -> History:
    """The log of edits as the session would open now, whoever has it open.

    Raises SessionError where the session cannot be read.
    """
    waiting = read_with_waiting(path)
    return read_session(path).history() if waiting is None else waiting[0].history


def edits_wait(path: Path) -> bool:
    """Whether edits may wait beside a session, in its journal or in what is left of one."""
    if not (companions(path) / JOURNAL).exists():
        return False
    try:
        with _copied(path) as journal:
            return journal.last > 0
    except (SessionError, OutputError, OSError):
        return True


def worked_on_s(path: Path) -> float:
    """When somebody saved or edited a session last, in seconds of the clock; 0: it is gone."""
    beside = companions(path) / JOURNAL
    return max(map(_written_s, (path, beside, beside.with_name(f"{JOURNAL}-wal"))))


def _written_s(file: Path) -> float:
    try:
        return file.stat().st_mtime
    except OSError:  # another window has just saved or dropped it
        return 0.0


def _steps(path: Path, stamps: Stamps) -> list[Step]:
    with _copied(path) as journal:
        return missing_steps(journal, stamps)


@contextmanager
def _copied(path: Path) -> Iterator[Journal]:
    """A copy of the session's journal: reading the journal itself would write beside it."""
    with tempfile.TemporaryDirectory() as folder:
        for file in companions(path).glob(f"{JOURNAL}*"):
            if not file.name.endswith("-shm"):
                shutil.copy(file, folder)
        journal = Journal(Path(folder) / JOURNAL)
        try:
            yield journal
        finally:
            journal.close()
