"""The edits that wait in a session's journal, looked at without touching anything."""

from __future__ import annotations

import contextlib
import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from tracking.editing import History
from tracking.errors import EditError, OutputError, SessionError
from tracking.owned_files import check_folder, open_file
from tracking.session.edited import Edited
from tracking.session.image import Stamps
from tracking.session.journal import ENDINGS, Journal, Step
from tracking.session.journal_files import JOURNAL, present
from tracking.session.journal_schema import MOST_BYTES
from tracking.session.reading import read_session
from tracking.session.recovery import missing_steps
from tracking.session.saving import companions


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
    """Whether edits may wait beside a session, in its journal or in what is left of one.

    They may, too, where the folder there is another user's, or a link, which nobody follows.
    """
    try:
        check_folder(companions(path))
        if not os.path.lexists(present(companions(path))):
            return False
        with _copied(path) as journal:
            return journal.last > 0
    except FileNotFoundError:
        return False
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


def _steps(path: Path, stamps: Stamps) -> tuple[Step, ...]:
    with _copied(path) as journal:
        return missing_steps(journal, stamps).steps


@contextmanager
def _copied(path: Path) -> Iterator[Journal]:
    """A copy of the session's journal: reading the journal itself would write beside it."""
    beside = companions(path)
    check_folder(beside)
    main = present(beside)
    with tempfile.TemporaryDirectory() as folder:
        for ending in ENDINGS:
            if ending != "-shm":
                _copy(beside / f"{main.name}{ending}", Path(folder) / f"{JOURNAL}{ending}")
        journal = Journal(Path(folder) / JOURNAL)
        try:
            yield journal
        finally:
            journal.close()


def _copy(file: Path, copy: Path) -> None:
    """Copy a file of the user's own, of a size that a journal has, where it is there."""
    with contextlib.suppress(FileNotFoundError):
        handle = open_file(file, most_bytes=MOST_BYTES)
        with os.fdopen(handle, "rb") as source, copy.open("wb") as target:
            shutil.copyfileobj(source, target)
