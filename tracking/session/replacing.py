"""A backup in the place of a session file that cannot be read."""

from __future__ import annotations

import contextlib
import shutil
from pathlib import Path

from tracking.owned_files import real_path, sync_folder
from tracking.session.document import Session
from tracking.session.older import read_generation
from tracking.session.saving import (
    copy_file,
    keep_damaged,
    telling_where,
    unfinished_name,
)
from tracking.session.store import Store


def replace_damaged(path: Path, number: int) -> tuple[Session, Path]:
    """Have a backup back where the session itself cannot be opened.

    The damaged file is kept beside it, and so are edits of a journal that builds on that file:
    they are told in the notes of the session.

    Args:
        number: 1 is the backup saved last before the damaged file.

    Returns:
        The session as it was saved then, and where the damaged file is kept.

    Raises:
        SessionError: there is no such backup, it cannot be read either, or another program has
            the session. OutputError: it cannot be written; everything is as it was.
    """
    path = real_path(path)
    file, _ = read_generation(path, number)
    store = Store.claim(path)
    try:
        kept = keep_damaged(path)
        try:
            with telling_where(path, "the backup was not put in its place"):
                _copy_over(file, path)
        except BaseException:
            kept.unlink(missing_ok=True)  # the file itself is still in its place
            raise
    finally:
        store.release(keep_journal=True)
    return Session.open(path), kept


def _copy_over(file: Path, path: Path) -> None:
    """Put a copy of a file in another's place, at once and for good."""
    beside = unfinished_name(path)
    try:
        copy_file(file, beside)
        with contextlib.suppress(OSError):  # whoever could read the damaged one, and nobody else
            shutil.copymode(path, beside)
        beside.replace(path)
    finally:
        beside.unlink(missing_ok=True)
    sync_folder(path.parent)
