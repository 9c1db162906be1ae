"""Folders of reports: made whole or not at all, and never in the place of something else."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from contextlib import ExitStack
from pathlib import Path

from tracking.atomic_output import replacing
from tracking.errors import OutputError
from tracking.owned_files import SAFE_FLAGS
from tracking.pages.templates import is_page

_HEAD_BYTES = 2048


def check_report_folder(folder: Path, names: Iterable[str], kind: str) -> None:
    """Refuse a folder that holds anything but an earlier report of the same kind.

    Args:
        folder: may be missing. names: of a report's files, its page first. kind: of its page.

    Raises:
        OutputError: it is no folder, cannot be read, or something in it is no report's.
    """
    known = list(names)
    if not folder.exists() and not folder.is_symlink():
        return
    try:
        held = sorted(each.name for each in folder.iterdir())
    except OSError as error:
        reason = error.strerror or str(error)
        raise OutputError(
            "cannot use folder {folder}: {reason}; choose another", folder=folder, reason=reason
        ) from error
    held = [each for each in held if not _is_left_over(each, known)]
    foreign = [each for each in held if each not in known]
    if foreign:
        raise _kept(folder, foreign[0])
    if held and not (known[0] in held and is_page(_head(folder / known[0]), kind)):
        raise _kept(folder, held[0])


def write_report_folder(folder: Path, files: Mapping[str, str], kind: str) -> None:
    """Write a report's files, the page first, or none of them.

    Raises:
        OutputError: as `check_report_folder`, or it cannot be written.
    """
    check_report_folder(folder, files, kind)
    made = _make(folder)
    try:
        with ExitStack() as stack:
            # All are written out before the first takes its place.
            for name, text in files.items():
                stream = stack.enter_context(replacing(folder / name))
                stream.write(text)
                stream.flush()
                os.fsync(stream.fileno())
    except OSError as error:
        _take_away(made)
        reason = error.strerror or str(error)
        raise OutputError(
            "cannot write in {folder}: {reason}; choose another", folder=folder, reason=reason
        ) from error
    except BaseException:
        _take_away(made)
        raise


def _make(folder: Path) -> list[Path]:
    """Make the folder and those above it; the ones that were missing, innermost first."""
    missing = [each for each in (folder, *folder.parents) if not each.exists()]
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        reason = error.strerror or str(error)
        raise OutputError(
            "cannot make folder {folder}: {reason}; choose another", folder=folder, reason=reason
        ) from error
    return missing


def _take_away(made: Iterable[Path]) -> None:
    for folder in made:
        try:
            folder.rmdir()
        except OSError:
            return


def _kept(folder: Path, name: str) -> OutputError:
    return OutputError(
        "{folder} holds {name}, which is no earlier report; choose an empty or a new folder",
        folder=folder,
        name=name,
    )


def _is_left_over(name: str, known: Iterable[str]) -> bool:
    """Whether a file was being written when the program was ended."""
    return name.endswith(".part") and any(name.startswith(f".{each}.") for each in known)


def _head(path: Path) -> str:
    try:
        with os.fdopen(os.open(path, os.O_RDONLY | SAFE_FLAGS), "rb") as stream:
            return stream.read(_HEAD_BYTES).decode("utf-8", "replace")
    except OSError:
        return ""
