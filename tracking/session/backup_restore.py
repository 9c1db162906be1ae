"""A backup in the place of a session file that cannot be read."""

from __future__ import annotations

import contextlib
import shutil
from pathlib import Path

from tracking.owned_files import real_path, sync_folder
from tracking.session.backups import read_backup
from tracking.session.document import Session
from tracking.session.session_writer import (
    copy_file,
    explain_file_errors,
    file_state,
    keep_damaged,
    name_unfinished,
)
from tracking.session.store import Store


def replace_damaged(path: Path, number: int) -> tuple[Session, Path]:
    """Restore a backup where the session itself cannot be opened.

    The damaged file is kept beside it, and so are edits of a journal that builds on that file:
    they are told in the notes of the session.

    Args:
        number: 1 is the backup saved last before the damaged file.

    Returns:
        The session as it was saved then, and where the damaged file is kept.

    Raises:
        SessionError: there is no such backup, it cannot be read either, or another program has
            the session. OutputError: it cannot be written; everything is as it was, or the damaged
            file is kept and the backup is in its place, where its name may not last.
    """
    path = real_path(path)
    store = Store.claim(path)
    try:
        file, _ = read_backup(path, number)
        damaged, kept = file_state(path), keep_damaged(path)
        try:
            with explain_file_errors(path, "the backup was not put in its place"):
                _copy_over(file, path)
        except BaseException:
            if file_state(path) == damaged:  # otherwise this is the only one
                with contextlib.suppress(OSError):
                    kept.unlink()
            raise
    finally:
        store.release(keep_journal=True)
    return Session.open(path), kept


def _copy_over(file: Path, path: Path) -> None:
    """Put a copy of a file in another's place, at once and for good."""
    beside = name_unfinished(path)
    try:
        copy_file(file, beside)
        with contextlib.suppress(OSError):  # whoever could read the damaged one, and nobody else
            shutil.copymode(path, beside)
        beside.replace(path)
    finally:
        with contextlib.suppress(OSError):
            beside.unlink(missing_ok=True)
    sync_folder(path.parent)
