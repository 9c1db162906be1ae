"""A session file is never edited: a new one is written beside it, verified, and takes its place."""

from __future__ import annotations

import contextlib
import errno
import filecmp
import itertools
import os
import re
import shutil
import stat
import sys
import time
import uuid
from collections.abc import Callable, Iterator
from pathlib import Path

from tracking.atomic_output import check_target
from tracking.errors import OutputError, UnsafeFileError
from tracking.owned_files import SAFE_FLAGS, check_file, check_folder, sync_folder
from tracking.session.image_file import ImageFile
from tracking.translation import msg

MAX_BACKUPS = 5
UNLIMITED = 999_999
"""Backups kept while one of them is restored: none is dropped then."""
_TRIES, _PAUSE_S = 20, 0.1


def file_state(path: Path) -> tuple[int, int, int] | None:
    """What changes when another file takes a path's place; None where there is none."""
    try:
        state = path.stat()
    except OSError:
        return None
    return state.st_ino, state.st_size, state.st_mtime_ns


def companions(path: Path) -> Path:
    """The folder beside a session that holds its lock, journal and backups."""
    return path.with_name(f".{path.name}.trackwright")


def find_backups(path: Path) -> tuple[Path, ...]:
    """The backups of a session that are kept, the newest first.

    None where the folder beside the session is not the user's own. Before one is read,
    `check_backup_file` says whether it is a file that was kept here.
    """
    try:
        check_folder(companions(path))
    except (UnsafeFileError, OSError):
        return ()
    return tuple(_backup_path(path, age) for age in _ages(path))


def check_backup_file(path: Path, backup: Path) -> None:
    """Refuse a backup of the session at `path` that is not a file of the user's own.

    It is only read, so it may have further names, as in copies of the folder by hard links.

    Raises UnsafeFileError where it, or the folder it stands in, is a link, a pipe, a device or
    another user's.
    """
    with contextlib.suppress(FileNotFoundError):  # which reading it tells
        check_folder(companions(path))
        if not _is_same(backup, path):  # as after a save that failed once it had kept it
            check_file(backup, is_written=False)


def replace_verified(
    path: Path, write: Callable[[ImageFile], None], most: int = MAX_BACKUPS
) -> None:
    """Put what `write` writes in the session's place; the file that was there becomes a backup.

    At every moment a whole file stands under the name: the old one until the new one is on the
    disk and read back equal. Of the older ones the newest are kept, so many at most.
    Raises OutputError, with the old file untouched, or, where the disk fails at the very last, with
    the new one in its place that a power cut may undo.
    """
    folder = companions(path)
    beside = name_unfinished(path)
    with explain_file_errors(path):
        check_target(path)
        check_folder(folder)
        try:
            with contextlib.closing(ImageFile(beside)) as image:
                write(image)
                image.seal()
                image.finish()
                image.verify()
            with contextlib.suppress(OSError):  # whoever could read the old one, and nobody else
                shutil.copymode(path, beside)
            _keep_backup(path)
            _replace(beside, path)
            _drop_oldest(path, most)
        finally:
            with contextlib.suppress(OSError):
                beside.unlink(missing_ok=True)
        sync_folder(folder)
        sync_folder(path.parent)


def name_unfinished(path: Path) -> Path:
    """Where to write a file that is to take the session's place."""
    return companions(path) / f"saving-{uuid.uuid4().hex}.h5"


def free_name(path: Path) -> Path:
    """A name that nothing has: the path's with the first free number, from 1, after its stem."""
    names = (path.with_name(f"{path.stem}{number}{path.suffix}") for number in itertools.count(1))
    return next(name for name in names if not os.path.lexists(name))


def keep_damaged(path: Path, file: Path | None = None) -> Path:
    """Keep a damaged file of a session for good, under a name that nothing has; gives it.

    file: which one, as a backup; None: the session's own. It stays where it is, too.
    Raises OutputError where that fails.
    """
    file = path if file is None else file
    kept = free_name(companions(path) / f"damaged-{path.suffix}")
    with explain_file_errors(kept, msg("the damaged file cannot be kept")):
        try:
            os.link(file, kept)
        except OSError:  # a disk without second names
            copy_file(file, kept)
        sync_folder(kept.parent)
    return kept


def copy_file(source: Path, target: Path) -> None:
    """Have a file's bytes in a new file, on the disk when this returns, or nothing.

    The copy may be read and written by whoever may do so with the source.
    Raises OSError where either fails, FileExistsError where anything has the name already.
    """
    with os.fdopen(os.open(source, os.O_RDONLY | SAFE_FLAGS), "rb") as read:
        state = os.fstat(read.fileno())
        if not stat.S_ISREG(state.st_mode):
            raise OSError(errno.EINVAL, "what is to be copied is not a regular file")
        new = os.O_WRONLY | os.O_CREAT | os.O_EXCL | SAFE_FLAGS
        with os.fdopen(os.open(target, new, stat.S_IMODE(state.st_mode) & 0o666), "wb") as written:
            try:
                shutil.copyfileobj(read, written)
                written.flush()
                os.fsync(written.fileno())
            except BaseException:
                target.unlink()
                raise


def clear_leftovers(path: Path) -> None:
    """Take away what a save that was cut short left beside the session.

    The folder has been checked: a link to another one is never looked into.
    """
    for file in companions(path).glob("saving-*.h5"):
        with contextlib.suppress(OSError):
            file.unlink()


@contextlib.contextmanager
def explain_file_errors(path: Path, failed: str = "the session was not saved") -> Iterator[None]:
    """Turn what the system says about a file into one line a user can act on."""
    try:
        yield
    except OSError as why:
        reason = {
            errno.ENOSPC: msg("no space is left on the disk; make room"),
            errno.EDQUOT: msg("your share of the disk is used up; make room"),
            errno.EFBIG: msg("it would be larger than a file may be here; choose another disk"),
            errno.EACCES: msg("you may not write there; choose another folder"),
            errno.EPERM: msg("you may not write there; choose another folder"),
            errno.EROFS: msg("the disk is read-only; choose another folder"),
            errno.ENOENT: msg("its folder does not exist; choose another"),
        }.get(why.errno or 0, msg("{reason}; try another place", reason=why.strerror or why))
        raise OutputError(
            "{path}: {failed}: {reason}", path=path, failed=failed, reason=reason
        ) from why


def _replace(new: Path, path: Path) -> None:
    """Put a file in another's place at once.

    Windows refuses while somebody reads the old one, which the window does for moments: wait.
    """
    for _ in range(_TRIES - 1 if sys.platform == "win32" else 0):
        with contextlib.suppress(PermissionError):
            os.replace(new, path)  # noqa: PTH105 - says that it is atomic
            return
        time.sleep(_PAUSE_S)
    os.replace(new, path)  # noqa: PTH105


def _keep_backup(path: Path) -> None:
    """Give the present file a second name, as the newest backup; the others grow older.

    A save that failed later on may have kept it already: saving again and again on a disk that
    refuses must not push the older ones out.
    """
    if not path.exists() or _is_kept(path):
        return
    ages = _ages(path)
    in_a_row = [age for place, age in enumerate(ages, 1) if age == place]
    for age in reversed(in_a_row):
        _backup_path(path, age).replace(_backup_path(path, age + 1))
    newest = _backup_path(path, 1)
    try:
        os.link(path, newest)
    except OSError:  # a disk without second names
        unfinished = name_unfinished(path)
        try:
            copy_file(path, unfinished)
            unfinished.replace(newest)
        finally:
            unfinished.unlink(missing_ok=True)


def _drop_oldest(path: Path, most: int) -> None:
    for age in _ages(path)[most:]:
        with contextlib.suppress(OSError):  # it goes with the next save
            _backup_path(path, age).unlink()


def _is_kept(path: Path) -> bool:
    """Whether the newest backup is the present file."""
    newest = _backup_path(path, 1)
    if _is_same(newest, path):
        return True
    try:
        is_file = check_file(newest, is_written=False) is not None
    except UnsafeFileError:  # it says nothing about what was kept
        return False
    return is_file and filecmp.cmp(newest, path, shallow=False)


def _is_same(backup: Path, path: Path) -> bool:
    """Whether a backup is a second name of the session's file; a link to it is not."""
    try:
        kept, present = os.lstat(backup), path.stat()
    except OSError:
        return False
    return (kept.st_ino, kept.st_dev) == (present.st_ino, present.st_dev)


def _ages(path: Path) -> list[int]:
    """The ages of the backups that are kept, ascending from 1."""
    names = re.compile(rf"{re.escape(path.stem)}\.([1-9]\d{{0,5}}){re.escape(path.suffix)}")
    try:
        found = [names.fullmatch(file.name) for file in companions(path).iterdir()]
    except OSError:  # nothing was ever kept, or may be looked at
        return []
    return sorted(int(match[1]) for match in found if match)


def _backup_path(path: Path, age: int) -> Path:
    return companions(path) / f"{path.stem}.{age}{path.suffix}"
