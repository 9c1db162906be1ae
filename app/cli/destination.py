"""Checks on where a result will go, made before the work and not after it."""

from __future__ import annotations

import shutil
import tempfile
from pathlib import Path

from tracking.errors import OutputError

_RESERVE = 8 << 20


def check_file(path: Path, needed_bytes: int = 0) -> None:
    """Refuse a file that could not be written in the end.

    Raises:
        OutputError: it is a folder, or its folder is missing, not writable or too full.
    """
    if path.is_dir():
        raise OutputError(f"{path} is a folder; name a file in it")
    check_folder(path.parent, needed_bytes)


def check_folder(folder: Path, needed_bytes: int = 0) -> None:
    """Refuse a folder in which nothing could be written.

    Raises:
        OutputError: it is missing, no folder, not writable, or has no room.
    """
    if not folder.is_dir():
        what = "is not a folder" if folder.exists() else "does not exist"
        raise OutputError(f"folder {folder} {what}; make it or choose another place")
    try:
        with tempfile.TemporaryFile(dir=folder):
            pass
        free = shutil.disk_usage(folder).free
    except OSError as error:
        reason = error.strerror or str(error)
        raise OutputError(
            f"cannot write in folder {folder}: {reason}; choose another place"
        ) from error
    if free < needed_bytes + _RESERVE:
        raise OutputError(
            f"folder {folder} has {_readable(free)} of free space and about "
            f"{_readable(needed_bytes + _RESERVE)} are needed; make room or choose another place"
        )


def _readable(size_bytes: int) -> str:
    """A size in the greatest unit of which there is one at least."""
    for shift, unit in ((20, "MiB"), (10, "KiB")):
        if size_bytes >> shift:
            return f"{size_bytes >> shift} {unit}"
    return f"{size_bytes} bytes"


def nearest_folder(path: Path) -> Path:
    """The folder that exists already on the way to `path`."""
    for folder in (path, *path.absolute().parents):
        if folder.exists():
            return folder
    return Path.cwd()
