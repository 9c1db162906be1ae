"""The files of a session's journal beside it: whether any are there, kept aside, taken away."""

from __future__ import annotations

import contextlib
import os
from pathlib import Path

from tracking.session.journal import ENDINGS, FOREIGN_ENDING
from tracking.session.saving import free_name, telling_where

JOURNAL = "journal.sqlite"


def files(folder: Path) -> list[Path]:
    """The files of the journal that may be there; the one the others belong to is the last."""
    return [folder / f"{JOURNAL}{ending}" for ending in (FOREIGN_ENDING, *ENDINGS)]


def are_there(folder: Path) -> bool:
    """Whether any of them is there. Raises OutputError where nobody can tell."""
    with telling_where(folder, "the journal of edits cannot be looked for"):
        return any(map(_lies_there, files(folder)))


def set_aside(folder: Path) -> Path:
    """Give them another name, so that a new journal can begin; gives that name.

    Raises OutputError where that fails.
    """
    aside = free_name(folder / "kept-aside-.sqlite")
    with telling_where(aside, "the journal cannot be kept aside"):
        for file in files(folder):
            if _lies_there(file):
                file.replace(folder / file.name.replace(JOURNAL, aside.name, 1))
    return aside


def remove(folder: Path) -> None:
    """Take away what may be taken away; what stays says which save it builds on."""
    with contextlib.suppress(OSError):
        for file in files(folder):
            file.unlink(missing_ok=True)


def _lies_there(file: Path) -> bool:
    """As `os.path.lexists`, which calls a disk that fails a file that is not there."""
    try:
        os.lstat(file)
    except (FileNotFoundError, NotADirectoryError):
        return False
    return True
