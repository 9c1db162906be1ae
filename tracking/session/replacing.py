"""An older generation in the place of a session file that cannot be read."""

from __future__ import annotations

import contextlib
import os
import shutil
import uuid
from pathlib import Path

from tracking.session.document import Session
from tracking.session.older import read_generation
from tracking.session.saving import companions, real_path, sync_folder, telling_where
from tracking.session.store import Store


def replace_damaged(path: Path, number: int) -> tuple[Session, Path]:
    """Have an older generation back where the session itself cannot be opened.

    The damaged file is kept beside it, and so are edits of a journal that builds on that file:
    they are told in the notes of the session.

    Args:
        number: 1 is the generation saved last before the damaged file.

    Returns:
        The session as it was saved then, and where the damaged file is kept.

    Raises:
        SessionError: there is no such generation, it cannot be read either, or another program has
            the session. OutputError: it cannot be written; everything is as it was.
    """
    path = real_path(path)
    file, _ = read_generation(path, number)
    store = Store.claim(path)
    try:
        kept = _set_aside(path)
        with telling_where(path, "the older generation was not put in its place"):
            _copy_over(file, path)
    finally:
        store.release(keep_journal=True)
    return Session.open(path), kept


def _set_aside(path: Path) -> Path:
    """A copy of the file under a name that nobody has; gives it."""
    folder = companions(path)
    numbers = range(1, len(list(folder.iterdir())) + 2)
    free = (folder / f"damaged-{number}{path.suffix}" for number in numbers)
    aside = next(file for file in free if not file.exists())
    with telling_where(aside, "the damaged file cannot be kept"):
        shutil.copy2(path, aside)
    return aside


def _copy_over(file: Path, path: Path) -> None:
    """Put a copy of a file in another's place, at once and for good."""
    beside = companions(path) / f"saving-{uuid.uuid4().hex}.h5"
    try:
        shutil.copyfile(file, beside)
        with beside.open("rb+") as copied:
            os.fsync(copied.fileno())
        with contextlib.suppress(OSError):  # whoever could read the damaged one, and nobody else
            shutil.copymode(path, beside)
        beside.replace(path)
    finally:
        beside.unlink(missing_ok=True)
    sync_folder(path.parent)
