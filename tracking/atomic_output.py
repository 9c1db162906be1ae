"""Output files and folders that appear whole or not at all.

A file takes the place of another one at once: a new one is written beside it under a hidden name
that nothing had, put on the disk, and renamed. So nothing is ever written through what stood
there: only a regular file is replaced, and keeps its permissions; a link, a pipe or a device is
refused.
"""

from __future__ import annotations

import contextlib
import os
import secrets
import shutil
import stat
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO, TextIO

from tracking.errors import OutputError
from tracking.owned_files import A_FILE, A_FOLDER, A_LINK, SAFE_FLAGS, kind_of, sync_folder
from tracking.translation import msg

_NAME_KEPT = 50
"""Letters of a file's name in that of its unfinished one, which must not get too long."""
_PERMISSIONS = 0o777
"""Of a file's mode: a new one never runs as its owner (setuid), whatever stood there."""
_PRIVATE = 0o600
"""Of a file while it is written: what it takes the place of may be for nobody else."""
_PRIVATE_FOLDER = 0o700
"""Of a folder meanwhile."""
_OPTION = "-o"
"""By it commands are told their file; their folder some are told without an option."""


def replace_with(path: Path, data: bytes) -> None:
    """Have the bytes at `path`, whole or not at all; what stood there before stays until then.

    Raises OutputError as `replacing`.
    """
    with part_of(path) as part, part.open("wb") as stream:
        stream.write(data)


@contextmanager
def replacing(path: Path) -> Iterator[TextIO]:
    """A text file that takes the place of `path` when the block ends without an error.

    Until then everything goes to a hidden file beside it, which is removed when the block is left
    by an error or an interruption; what stood at `path` before stays as it was.

    Raises:
        OutputError: the folder is missing or not writable, the disk is full, `path` is a folder, a
            link, a pipe or a device.
        OSError: the block's own, where it names another file or is of a closed pipe.
    """
    with (
        part_of(path) as part,
        part.open("w", encoding="utf-8", newline="\n") as stream,
    ):
        yield stream


@contextmanager
def replacing_bytes(path: Path) -> Iterator[BinaryIO]:
    """A file of bytes that takes the place of `path` in the end; see `replacing`."""
    with part_of(path) as part, part.open("wb") as stream:
        yield stream


@contextmanager
def part_of(path: Path) -> Iterator[Path]:
    """The hidden file beside `path` that takes its place in the end; see `replacing`.

    For libraries that write a file of their own; it is there already, and empty. It is put on the
    disk here, and then its name, so that neither is lost to a power cut.
    """
    check_target(path)
    part = _part_name(path)
    try:
        allowed = _new_file(part)
        yield part
        _sync(part)
        part.chmod(_permissions(path, allowed))
        part.replace(path)
        sync_folder(path.parent)
    except OSError as error:
        if not _is_of(error, part, path):
            raise
        raise _told(path, error.strerror or str(error)) from error
    finally:
        with contextlib.suppress(OSError):
            part.unlink(missing_ok=True)


@contextmanager
def replacing_folder(path: Path) -> Iterator[Path]:
    """A new folder that takes the place of `path` when the block ends without an error.

    Until then everything goes to a hidden folder beside it, which is removed when the block is
    left by an error or an interruption, and so are folders above it that were made for it. Only an
    empty folder is replaced, and keeps its permissions; a new one has those of the user's umask.

    Raises:
        OutputError: something but an empty folder is at `path`, or it cannot be written.
    """
    _check_folder(path)
    missing = [each for each in (path.parent, *path.parent.parents) if not each.exists()]
    part = _part_name(path)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        part.mkdir()
        allowed = stat.S_IMODE(part.stat().st_mode)
        part.chmod(_PRIVATE_FOLDER)
        yield part
        _finish_folder(part, path, allowed)
        for folder in missing:
            sync_folder(folder.parent)
    except OSError as error:
        if not _is_of(error, part, path):
            raise
        raise _told(path, error.strerror or str(error), option="") from error
    finally:
        shutil.rmtree(part, ignore_errors=True)
        with contextlib.suppress(OSError):  # one with something in it stays, and those above it
            for folder in missing:
                folder.rmdir()


def _check_folder(path: Path) -> None:
    try:
        found = kind_of(path)
        held = found == A_FOLDER and any(path.iterdir())
    except FileNotFoundError:
        return
    except OSError as error:
        raise _told(path, error.strerror or str(error), option="") from error
    if found != A_FOLDER:
        raise OutputError(
            "{path} is {found}, and a folder is written",
            "choose another place",
            path=path,
            found=found,
        )
    if held:
        raise OutputError("{path} is not an empty folder", "choose one that is new", path=path)


def _finish_folder(part: Path, path: Path, allowed: int) -> None:
    """Put all of a folder on the disk, then its name; allowed: the mode of a new one."""
    for folder, _, files in os.walk(part, topdown=False):
        for name in files:
            _sync(Path(folder) / name)
        sync_folder(Path(folder))
    there = path.is_dir()
    part.chmod(stat.S_IMODE(os.lstat(path).st_mode) if there else allowed)
    if sys.platform == "win32" and there:
        path.rmdir()  # a rename takes an empty folder's place elsewhere
    part.rename(path)
    sync_folder(path.parent)


def check_target(path: Path) -> None:
    """Refuse to put a file in the place of anything but a regular file.

    Raises OutputError where `path` is a folder, a link, a pipe or a device, or cannot be looked at.
    """
    try:
        found = kind_of(path)
    except FileNotFoundError:
        return
    except OSError as error:
        raise _told(path, error.strerror or str(error)) from error
    if found == A_LINK:
        raise OutputError(
            "cannot write {path}: it is a link, which is not written through",
            "name the file it leads to, or remove the link",
            path=path,
        )
    if found != A_FILE:
        raise _told(path, msg("it is {found}", found=found))


def _part_name(path: Path) -> Path:
    return path.with_name(f".{path.name[:_NAME_KEPT]}.{secrets.token_hex(8)}.part")


def _new_file(path: Path) -> int:
    """Make a file that was not there, for the user alone; gives the mode the umask asks for."""
    handle = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL | SAFE_FLAGS, 0o666)
    try:
        allowed = os.fstat(handle).st_mode & _PERMISSIONS
        if sys.platform != "win32":
            os.fchmod(handle, allowed & _PRIVATE)  # while it is empty
        return allowed
    finally:
        os.close(handle)


def _permissions(path: Path, allowed: int) -> int:
    """Who may read and write the new file: as the one it replaces; without one, as allowed."""
    try:
        return os.lstat(path).st_mode & _PERMISSIONS
    except FileNotFoundError:
        return allowed


def _sync(path: Path) -> None:
    handle = os.open(path, os.O_RDWR | SAFE_FLAGS)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def _is_of(error: OSError, part: Path, path: Path) -> bool:
    """Whether the system complains of what is written, not of another file or of whoever reads."""
    if not isinstance(error.filename, str | bytes | os.PathLike):
        return not isinstance(error, BrokenPipeError)
    named = Path(os.fsdecode(error.filename))
    return named in (part, path, *path.parents) or part in named.parents


def _told(path: Path, reason: str, option: str = _OPTION) -> OutputError:
    """A complaint, as the system's, as one line about the file the user asked for."""
    return OutputError(
        "cannot write {path}: {reason}",
        "choose another place",
        option=option,
        path=path,
        reason=reason,
    )
