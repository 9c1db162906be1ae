"""The files of a session's journal beside it: whether any are there, kept aside, taken away.

A journal that is replaced is never missed, whenever the program or the power ends: the new one is
whole and on the disk under a name of its own before the old one is moved, and an opening that finds
it there finishes what was begun.
"""

from __future__ import annotations

import contextlib
import errno
import itertools
import uuid
from collections.abc import Sequence
from pathlib import Path

from tracking.owned_files import look_at, sync_folder
from tracking.session.journal import ENDINGS, FOREIGN_ENDING, Journal, Step
from tracking.session.session_writer import explain_file_errors
from tracking.translation import msg

JOURNAL = "journal.sqlite"
NEXT = "journal-next.sqlite"
"""A journal, whole and on the disk, that is to take the place of the one that is kept aside."""
_BEING_MADE = "journal-making-"
_ASIDE = "kept-aside-"
_OTHERS = (FOREIGN_ENDING, *(ending for ending in ENDINGS if ending))
"""Of the names of files that belong to the main one."""


def find_main(folder: Path) -> Path:
    """The main file of the journal that counts. Raises OSError where nobody can tell."""
    new = folder / NEXT
    return new if _lies_there(new) else folder / JOURNAL


def are_there(folder: Path) -> bool:
    """Whether any file of a journal is there. Raises OutputError where nobody can tell."""
    names = (NEXT, *(f"{JOURNAL}{ending}" for ending in ("", *_OTHERS)))
    with explain_file_errors(folder, msg("the journal of edits cannot be looked for")):
        return any(_lies_there(folder / name) for name in names)


def set_aside(folder: Path) -> Path:
    """Give the journal's files another name, so that a new one can begin; gives that name.

    Raises OutputError where that fails.
    """
    finish_replacing(folder)
    with explain_file_errors(folder / JOURNAL, msg("the journal cannot be kept aside")):
        return _moved_aside(folder)


def replace(
    folder: Path, session: str, save: str, mode: int, steps: Sequence[Step]
) -> tuple[Journal, Path]:
    """A new journal on this save, with these steps, in the place of what is there.

    mode: the permissions of new files. Gives the new journal, and the name that what was there is
    kept aside as. Raises OutputError where that fails.
    """
    made = folder / f"{_BEING_MADE}{uuid.uuid4().hex}.sqlite"
    try:
        Journal.begun(made, session, save, mode, steps).close()
        with explain_file_errors(made, msg("the journal of edits cannot be made anew")):
            if _lies_there(made.with_name(f"{made.name}-wal")):
                raise OSError(errno.EIO, "its log could not be emptied")
            made.replace(folder / NEXT)
            sync_folder(folder)
    finally:
        _clear(folder)
    aside = finish_replacing(folder)
    assert aside is not None
    journal = Journal(folder / JOURNAL, mode)
    journal.say_count()
    return journal, aside


def finish_replacing(folder: Path) -> Path | None:
    """Put the next journal in its place, where one is ready; None: none is.

    Gives the name that the journal before is kept aside as. Raises OutputError where that fails.
    """
    _clear(folder)
    with explain_file_errors(folder / JOURNAL, msg("the journal cannot be kept aside")):
        if not _lies_there(folder / NEXT):
            return None
        aside = _moved_aside(folder)
        (folder / NEXT).replace(folder / JOURNAL)
        sync_folder(folder)
    return aside


def list_set_aside(folder: Path, most: int) -> list[Path]:
    """So many journals that were kept aside, the latest; [] where nobody can tell."""
    with contextlib.suppress(OSError):
        kept = folder.glob(f"{_ASIDE}*.sqlite")
        return sorted(kept, key=lambda file: look_at(file).st_mtime_ns)[-most:]
    return []


def remove(folder: Path) -> None:
    """Take away what may be taken away; what stays says which save it builds on."""
    with contextlib.suppress(OSError):
        for ending in (*_OTHERS, ""):
            (folder / f"{JOURNAL}{ending}").unlink(missing_ok=True)


def _moved_aside(folder: Path) -> Path:
    """Move the main file first: without it the others say nothing, while it would say too little.

    Where that was cut short, the others go to the same name.
    """
    others = [ending for ending in _OTHERS if _lies_there(folder / f"{JOURNAL}{ending}")]
    if _lies_there(folder / JOURNAL):
        aside = _free_name(folder)
        (folder / JOURNAL).replace(aside)
        sync_folder(folder)  # otherwise a power cut may undo this and keep what follows
    else:
        aside = _last_aside(folder, others) or _free_name(folder)
    for ending in others:
        (folder / f"{JOURNAL}{ending}").replace(folder / f"{aside.name}{ending}")
    if others:
        sync_folder(folder)
    return aside


def _free_name(folder: Path) -> Path:
    """The first name, counted from 1, that nothing has, nor anything that would belong to it."""
    names = (folder / f"{_ASIDE}{number}.sqlite" for number in itertools.count(1))
    return next(
        name
        for name in names
        if not any(_lies_there(folder / f"{name.name}{ending}") for ending in ("", *_OTHERS))
    )


def _last_aside(folder: Path, endings: Sequence[str]) -> Path | None:
    """The main file that was kept aside last, where it lacks files of these endings."""
    kept = list(folder.glob(f"{_ASIDE}*.sqlite"))
    last = max(kept, key=lambda file: look_at(file).st_ctime_ns, default=None)
    if last is None or any(_lies_there(folder / f"{last.name}{ending}") for ending in endings):
        return None
    return last


def _clear(folder: Path) -> None:
    """Take away what a program left that ended while it made a journal."""
    with contextlib.suppress(OSError):  # it harms nobody
        for file in folder.glob(f"{_BEING_MADE}*"):
            file.unlink()


def _lies_there(file: Path) -> bool:
    """As `os.path.lexists`, which calls a disk that fails a file that is not there."""
    try:
        look_at(file)
    except (FileNotFoundError, NotADirectoryError):
        return False
    return True
