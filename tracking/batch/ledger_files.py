"""The files of a ledger, looked at before SQLite opens them: what lies beside it obeys them."""

from __future__ import annotations

import os
from pathlib import Path

from tracking.errors import OutputError
from tracking.owned_files import check_file, open_file

_ROLLBACK, _FOREIGN = "-journal", ("-wal", "-shm")
_SUPER_JOURNAL = bytes.fromhex("d9d505f920a163d7")
"""How a rollback journal ends that names a further file, which SQLite deletes:
https://www.sqlite.org/fileformat2.html#the_rollback_journal and `readSuperJournal` in pager.c."""


def check_ledger_files(path: Path) -> None:
    """Refuse files that no ledger leaves behind; a transaction that was cut short may lie there.

    A ledger is written to by itself and has no write-ahead log.

    Raises:
        UnsafeFileError: one is a link, another user's, or no regular file.
        OutputError: one is of another program. OSError: one cannot be looked at.
    """
    check_file(path)
    journal, *foreign = (path.with_name(f"{path.name}{end}") for end in (_ROLLBACK, *_FOREIGN))
    for file in foreign:
        if check_file(file) is not None:
            raise _of_another(file)
    if check_file(journal) is not None and _ends_with(journal, _SUPER_JOURNAL):
        raise _of_another(journal)


def _ends_with(path: Path, mark: bytes) -> bool:
    try:
        handle = open_file(path)
    except FileNotFoundError:  # whoever writes the ledger has just finished
        return False
    with os.fdopen(handle, "rb") as file:
        size = file.seek(0, os.SEEK_END)
        file.seek(max(0, size - len(mark)))
        return file.read(len(mark)) == mark


def _of_another(path: Path) -> OutputError:
    return OutputError(
        "{path}: this is of another program, not of a batch; move it away", path=path
    )
