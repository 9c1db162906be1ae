"""Backups of a session: what was saved before, listed and restored."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import h5py
import numpy as np

from tracking.errors import SessionError, UnsafeFileError
from tracking.owned_files import check_folder
from tracking.session import session_reader
from tracking.session.hdf5 import open_readonly, text_attribute
from tracking.session.image import Snapshot
from tracking.session.runs import StoredRun
from tracking.session.session_writer import check_backup_file, companions, find_backups
from tracking.translation import msg


@dataclass(frozen=True, slots=True)
class Backup:
    """A session as it was saved before.

    Attributes:
        number: 1 is the one saved last before the present file.
        path, size_bytes: the file.
        saved: when; UTC, ISO 8601; "" where the file cannot be read.
        edits, undone_edits: how many of each the log has, as `trackwright info` counts them.
        tracks: how many corrected tracks.
        problem: why the file cannot be read; "" where it can.
        damage: what is damaged of one that can be read, in a line; "": nothing is known to be.
    """

    number: int
    path: Path
    size_bytes: int
    saved: str = ""
    edits: int = 0
    undone_edits: int = 0
    tracks: int = 0
    problem: str = ""
    damage: str = ""


def list_backups(path: Path) -> tuple[Backup, ...]:
    """The backups that are kept beside a session, the newest first.

    No table is read; one that is damaged, or no file of the user's own, is listed with its problem.
    Raises UnsafeFileError where the folder they stand in is a link or another user's.
    """
    _check_folder(path)
    files = find_backups(path)
    found = _found(path, files)
    return tuple(
        replace(_described(number, file, problem), damage=damage)
        for number, (file, (problem, damage)) in enumerate(zip(files, found, strict=True), 1)
    )


def check_backup(path: Path, number: int) -> None:
    """Raise SessionError where no backup of that number is kept, or none can be."""
    _check_folder(path)
    count = len(find_backups(path))
    if not 1 <= number <= count:
        kept = (
            msg("there are {count}, 1 is the newest", count=count)
            if count
            else msg("none is kept yet")
        )
        raise SessionError(
            "{path} has no backup {number} ({kept})", path=path, number=number, kept=kept
        )


def read_backup(path: Path, number: int) -> tuple[Path, Snapshot]:
    """The file of a backup and what it says; what is damaged of it is told.

    Raises SessionError where there is none of that number, where it cannot be read, and where a
    newer program made it.
    """
    check_backup(path, number)
    files = find_backups(path)
    check_backup_file(path, files[number - 1])
    snapshot = session_reader.read_session(files[number - 1])
    if snapshot.newer:
        raise SessionError(
            "{files} was made by a newer trackwright; update to restore it", files=files[number - 1]
        )
    return files[number - 1], snapshot


def with_runs_from(snapshot: Snapshot, file: Path) -> Snapshot:
    """The snapshot with its runs still in a file, wherever that was renamed to."""
    runs = tuple(StoredRun(file, number) for number in range(len(snapshot.runs)))
    return replace(snapshot, runs=runs)


def _check_folder(path: Path) -> None:
    with contextlib.suppress(FileNotFoundError):  # nothing was ever kept
        check_folder(companions(path))


def _found(path: Path, files: Sequence[Path]) -> list[tuple[str, str]]:
    """Why each of the files cannot be read, else what is damaged of it; "" where it is sound."""
    problems = [_problem(path, file) for file in files]
    own = [file for file, problem in zip(files, problems, strict=True) if not problem]
    checked = dict(zip(own, session_reader.check_files(own), strict=True))
    return [
        (problem, "") if problem else checked[file]
        for file, problem in zip(files, problems, strict=True)
    ]


def _problem(path: Path, file: Path) -> str:
    """Why a file is none that was kept here; "" where it is one."""
    try:
        check_backup_file(path, file)
    except UnsafeFileError as why:
        return str(why)
    return ""


def _described(number: int, file: Path, problem: str) -> Backup:
    size = os.lstat(file).st_size if os.path.lexists(file) else 0
    if problem:
        return Backup(number, file, size, problem=problem)
    try:
        with open_readonly(file) as held:
            undone = held["edits/undone"][()]
            return Backup(
                *(number, file, size, text_attribute(held, "modified")),
                edits=int(np.count_nonzero(~undone)),
                undone_edits=int(np.count_nonzero(undone)),
                tracks=_tracks(held["tracks"]),
            )
    except SessionError as why:
        return Backup(number, file, size, problem=str(why))


def _tracks(group: h5py.Group) -> int:
    """How many tracks; format 1.0 does not say, so they are counted."""
    said = group.attrs.get("count")
    return len(np.unique(group["track"][()])) if said is None else int(said)
