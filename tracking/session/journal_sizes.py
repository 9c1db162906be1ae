"""What the files of a journal are by their sizes and first bytes, before any of them is copied."""

from __future__ import annotations

import os
import sqlite3
from pathlib import Path

from tracking.errors import SessionError, UnsafeFileError
from tracking.owned_files import check_file, open_file
from tracking.session.journal_faults import CANNOT_READ, translate_errors
from tracking.session.journal_limits import FULL_BYTES, MOST_BYTES, TimeLimit
from tracking.session.journal_schema import check_schema

_MOST_COPIED = FULL_BYTES + (1 << 25)
"""Bytes of a full journal and of its log, as it is before it is emptied; a larger one is read by
opening the session."""
_HOLED_BYTES, _HOLED_TIMES, _BLOCK_BYTES = 1 << 24, 32, 512
"""A file of so many bytes is a hole where it takes so many times less room: disks that compress
what they hold may save some, too."""
_HEADER_BYTES, _LOG_HEADER_BYTES = 100, 32
_MAGIC = b"SQLite format 3\0"
_LOG_MAGICS = (0x377F0682, 0x377F0683)


def files_to_copy(main: Path) -> list[str]:
    """The endings of the files of a journal that hold its steps, its log first.

    Nothing is written beside it. Raises SessionError where it is no journal, or too large to be
    copied, OSError and OutputError where it cannot be read.
    """
    log = main.with_name(f"{main.name}-wal")
    endings = [ending for ending, file in (("-wal", log), ("", main)) if _size(file) is not None]
    sizes = [_size(file) or 0 for file in (log, main)]
    if not sizes[1]:  # opening the copy tells
        return [ending for ending in endings if not ending or sizes[0] <= _MOST_COPIED]
    if sum(sizes) > _MOST_COPIED:
        raise SessionError(
            "{main}: the journal of edits has {size} MiB with its log, more than is read "
            "without opening the session",
            main=main,
            size=sum(sizes) >> 20,
        )
    _check_header(main)
    if sizes[0] and _is_log(log):
        return endings  # pages of the main file may be halfway out of the log: the copy is checked
    with translate_errors(main, CANNOT_READ):
        _check_tables(main)
    return [""]  # SQLite takes no step from what is no log either; the count tells


def _size(file: Path) -> int | None:
    state = check_file(file, MOST_BYTES)
    if state is None:
        return None
    taken = getattr(state, "st_blocks", state.st_size) * _BLOCK_BYTES
    if state.st_size > _HOLED_BYTES and taken * _HOLED_TIMES < state.st_size:
        raise UnsafeFileError(
            "{file} has {size} bytes, almost all of them a hole", file=file, size=state.st_size
        )
    return state.st_size


def _check_header(main: Path) -> None:
    header = _first_bytes(main, _HEADER_BYTES)
    page = int.from_bytes(header[16:18], "big")
    if len(header) < _HEADER_BYTES or not header.startswith(_MAGIC) or page & (page - 1):
        raise SessionError(
            "{main}: this is no journal of edits (file is not a database)", main=main
        )


def _check_tables(main: Path) -> None:
    """Look at the schema as the main file has it: it has no log."""
    uri = f"{main.absolute().as_uri()}?mode=ro&immutable=1"
    base = sqlite3.connect(uri, uri=True, isolation_level=None)
    try:
        check_schema(base, main, TimeLimit())
    finally:
        base.close()


def _is_log(log: Path) -> bool:
    """Whether SQLite would look into a log at all."""
    header = _first_bytes(log, _LOG_HEADER_BYTES)
    return len(header) == _LOG_HEADER_BYTES and int.from_bytes(header[:4], "big") in _LOG_MAGICS


def _first_bytes(file: Path, count: int) -> bytes:
    with os.fdopen(open_file(file, most_bytes=MOST_BYTES), "rb") as data:
        return data.read(count)
