"""The edits that wait in a session's journal, looked at without touching anything."""

from __future__ import annotations

import shutil
import tempfile
from pathlib import Path

from tracking.editing import History
from tracking.errors import EditError, OutputError, SessionError
from tracking.session.edited import Edited
from tracking.session.image import Stamps
from tracking.session.journal import Journal, Step
from tracking.session.reading import read_session
from tracking.session.recovery import missing_steps
from tracking.session.saving import companions
from tracking.session.store import JOURNAL, has_waiting_journal


def read_with_waiting(path: Path) -> tuple[Edited, int] | None:
    """The session as it would open now, and how many steps of it only the journal holds.

    None where nothing waits, or nothing that fits the file. Another program may have the session
    open meanwhile. Raises SessionError where the session itself cannot be read.
    """
    if not has_waiting_journal(path):
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


def _steps(path: Path, stamps: Stamps) -> list[Step]:
    """The waiting steps, of a copy: reading the journal itself would write beside it."""
    with tempfile.TemporaryDirectory() as folder:
        for file in companions(path).glob(f"{JOURNAL}*"):
            if not file.name.endswith("-shm"):
                shutil.copy(file, folder)
        journal = Journal(Path(folder) / JOURNAL)
        try:
            return missing_steps(journal, stamps)
        finally:
            journal.close()
