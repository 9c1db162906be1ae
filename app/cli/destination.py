"""Checks on where a result will go, made before the work and not after it."""

from __future__ import annotations

import shutil
import tempfile
from pathlib import Path

from tracking.atomic_output import check_target
from tracking.errors import FormatError, OutputError
from tracking.owned_files import real_path
from tracking.translation import Message, msg

_RESERVE = 8 << 20
_LOOKED_AT_BYTES = 8 << 10
_KINDS = {
    "session": msg("a session"),
    "samples": msg("a file of samples"),
    "detector": msg("a detector"),
}
"""What the program's own files are, by the end of what they say they are."""


def check_file(path: Path, needed_bytes: int = 0) -> None:
    """Refuse a file that could not be written in the end.

    A link passes where what it leads to does, as a session may be named by one; `check_replaced`
    and `check_text_replaced` refuse it for all else.

    Raises:
        OutputError: it is a folder, a pipe or a device, or its folder is missing, not writable or
            too full.
    """
    path = real_path(path)
    if path.is_dir():
        raise OutputError("{path} is a folder; name a file in it", path=path)
    check_target(path)
    check_folder(path.parent, needed_bytes)


def check_folder(folder: Path, needed_bytes: int = 0) -> None:
    """Refuse a folder in which nothing could be written.

    Raises:
        OutputError: it is missing, no folder, not writable, or has no room.
    """
    if not folder.is_dir():
        what = msg("is not a folder") if folder.exists() else msg("does not exist")
        raise OutputError(
            "folder {folder} {what}; make it or choose another place", folder=folder, what=what
        )
    try:
        with tempfile.TemporaryFile(dir=folder):
            pass
        free = shutil.disk_usage(folder).free
    except OSError as error:
        reason = error.strerror or str(error)
        raise OutputError(
            "cannot write in folder {folder}: {reason}; choose another place",
            folder=folder,
            reason=reason,
        ) from error
    if free < needed_bytes + _RESERVE:
        raise OutputError(
            "folder {folder} has {free} of free space and about {needed} are needed; make room "
            "or choose another place",
            folder=folder,
            free=_readable(free),
            needed=_readable(needed_bytes + _RESERVE),
        )


def check_replaced(path: Path, replaceable: str) -> None:
    """Refuse to lose what is neither text nor HDF5 of the kind that takes its place.

    Args:
        replaceable: root attribute `format` of what may be replaced.

    Raises:
        OutputError: what stands there is, say, a session, a video or a link; FormatError where it
            cannot be read.
    """
    check_target(path)
    _check_not_protected(path, "-o")
    if path.is_file() and (held := read_file_kind(path)) != replaceable:
        if held is not None:
            raise _would_be_lost(path, _kind_of(held), "-o")
        _check_is_text(path, "-o")


def check_text_replaced(path: Path, option: str = "-o") -> None:
    """Refuse to lose what is not text, as a session or a video, to what is exported.

    Args:
        option: with which the export is named.

    Raises:
        OutputError: what stands there is no text, a link, or a recording's own, such as its
            calibration; FormatError where it cannot be read.
    """
    check_target(path)
    _check_not_protected(path, option)
    if path.is_file():
        if (held := read_file_kind(path)) is not None or is_session(path):
            what = msg("a session") if held is None else _kind_of(held)
            raise _would_be_lost(path, what, option)
        _check_is_text(path, option)


def _check_not_protected(path: Path, option: str) -> None:
    """Refuse to lose what a recording is made of, its ground truth, or what a session keeps.

    A ground truth that an export wrote there is its own to write again.
    """
    if not path.is_file():
        return
    from app.features.files.own_files import is_own
    from app.features.files.protected_files import why_protected

    if (what := why_protected(path)) and not is_own(path):
        raise _would_be_lost(path, what, option)


def _check_is_text(path: Path, option: str) -> None:
    """Refuse a file with a zero byte near its beginning, which text has none of."""
    try:
        with path.open("rb") as stream:
            start = stream.read(_LOOKED_AT_BYTES)
    except OSError as error:
        raise FormatError(
            "cannot read {path}: {reason}; check the path", path=path, reason=error.strerror
        ) from error
    if b"\0" in start:
        raise _would_be_lost(path, msg("not a text file"), option).advising(
            "choose another name with {flag}, or remove the file first", flag=option
        )


def _would_be_lost(path: Path, what: Message, option: str) -> OutputError:
    return OutputError(
        "{path} is {what} and would be lost",
        "choose another name with {flag}",
        path=path,
        what=what,
        flag=option,
    )


def is_session(path: Path) -> bool:
    """Whether the file is meant to be a session: HDF5 inside, or an ending that says so.

    Raises FormatError where it cannot be read.
    """
    from tracking.formats import is_hdf5  # brings h5py, too

    return is_hdf5(path)


def _kind_of(held: str) -> Message:
    """What a file is that says it is that, as a sentence needs it; see `read_file_kind`."""
    what = held.rpartition("-")[2]
    known = _KINDS.get(what)
    return known or (msg("a {what}", what=what) if what else msg("an HDF5 file"))


def read_file_kind(path: Path) -> str | None:
    """What an HDF5 file says it is, "" where it says nothing; None for any other file.

    Nothing of the file is given to the HDF5 library here: a program of its own looks into it.
    """
    from tracking.formats import begins_as_hdf5  # h5py takes longer to import than most commands
    from tracking.untrusted import named_format

    try:
        return named_format(path) if begins_as_hdf5(path) else None
    except OSError:
        return ""


def _readable(size_bytes: int) -> str:
    """A size in the greatest unit of which there is one at least."""
    for shift, unit in ((20, "MB"), (10, "kB")):
        if size_bytes >> shift:
            return f"{size_bytes >> shift} {unit}"
    return f"{size_bytes} bytes"


def nearest_folder(path: Path) -> Path:
    """The folder that exists already on the way to `path`."""
    for folder in (path, *path.absolute().parents):
        if folder.exists():
            return folder
    return Path.cwd()
