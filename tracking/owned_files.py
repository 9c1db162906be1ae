"""Files and folders that only the user's own program makes, opened without following links.

What stands beside a session (lock, journal, backups) travels with it, in archives and on shared
disks. So none of it is trusted to be what it is called: a link there would have the program write
elsewhere, a pipe would make it wait, a device would never end. These functions open a folder or a
file only where it is a real one and the user's own.

An owner counts as the user where new files of the user's get the same one: disks that know no
owners (FAT, many network disks) show all files as one person's. Root, as programs in containers
often are, may also work in the folder of another user where what stands there is that user's.
"""

from __future__ import annotations

import contextlib
import errno
import os
import stat
import sys
import tempfile
from pathlib import Path

from tracking.errors import UnsafeFileError
from tracking.translation import Message, msg

FOLDER_MODE = 0o700
"""Of a folder for the program's own files: nobody else looks in."""
_OTHERS = 0o077
_TRIES = 100
"""Of a call that a signal interrupts, which Python itself repeats only for some."""
SAFE_FLAGS = (
    getattr(os, "O_NOFOLLOW", 0)  # a link is an error
    | getattr(os, "O_NONBLOCK", 0)  # a pipe without a writer does not make us wait
    | getattr(os, "O_NOCTTY", 0)  # a terminal does not become ours
    | getattr(os, "O_CLOEXEC", 0)
    | getattr(os, "O_BINARY", 0)
)
"""For `os.open`, where it is to open nothing but a file."""
_FOLDERS_NOT_SYNCED = frozenset(
    {
        *(errno.EINVAL, errno.EBADF, errno.EISDIR, errno.ENOSYS, errno.ENOTSUP, errno.EOPNOTSUPP),
        *(errno.EACCES, errno.EPERM),
    }
)
"""What systems say of a folder that they never sync, or that may be written to but not opened."""
_FOLDER_TRIES = 20
"""Of making a folder that another program takes away at that moment."""
A_FOLDER, A_FILE, A_LINK = msg("a folder"), msg("a file"), msg("a link")
"""What `kind_of` says of them."""
_KINDS = {
    stat.S_IFDIR: A_FOLDER,
    stat.S_IFREG: A_FILE,
    stat.S_IFLNK: A_LINK,
    stat.S_IFIFO: msg("a pipe"),
    stat.S_IFSOCK: msg("a socket"),
    stat.S_IFCHR: msg("a device"),
    stat.S_IFBLK: msg("a device"),
}


def make_folder(folder: Path) -> None:
    """Make a folder that only the user may enter, or take the one that is there.

    One that others may enter is closed to them, quietly, as older versions left them open.

    Raises:
        UnsafeFileError: what is there is a link, no folder, or another user's.
        OSError: it cannot be made.
    """
    for _ in range(_FOLDER_TRIES):
        try:
            folder.mkdir(FOLDER_MODE)
        except FileExistsError:
            try:
                check_folder(folder)
            except FileNotFoundError:  # another program takes it away while it is empty
                continue
            _close_to_others(folder)
        return
    check_folder(folder)


def check_folder(folder: Path) -> None:
    """Refuse a folder that is not a real one of the user's; nothing is changed.

    Raises:
        UnsafeFileError: it is a link, no folder, or another user's.
        OSError: it cannot be looked at; FileNotFoundError where nothing is there.
    """
    state = look_at(folder)
    _check_kind(folder, state, stat.S_IFDIR)
    if not _is_own(state, folder.parent):
        raise _foreign(folder, state)


def check_file(
    path: Path, most_bytes: int | None = None, *, is_written: bool = True
) -> os.stat_result | None:
    """Refuse what is not a regular file of the user's under one name only; None: nothing is there.

    For files that a library opens by their name, such as SQLite. Their folder must have been
    checked, so that nobody else can change what is there meanwhile.

    Args:
        path: the file.
        most_bytes: the largest size to take; None: any.
        is_written: False: it is only read, which changes no other file: it may have further names
            (hard links), as programs make them that keep many copies of a folder.

    Raises:
        UnsafeFileError: it is a link, no regular file, has further names, is another user's or is
            too large.
        OSError: it cannot be looked at.
    """
    try:
        state = look_at(path)
    except FileNotFoundError:
        return None
    _check_state(path, state, most_bytes, is_written=is_written)
    return state


def look_at(path: Path) -> os.stat_result:
    """What stands at a path, links not followed; a disk that is interrupted is asked again.

    Raises OSError where it cannot be looked at, FileNotFoundError where nothing is there.
    """
    for _ in range(_TRIES):
        with contextlib.suppress(InterruptedError):
            return os.lstat(path)
    return os.lstat(path)


def open_file(
    path: Path, flags: int = os.O_RDONLY, mode: int = 0o600, most_bytes: int | None = None
) -> int:
    """Open a file by `os.open` that `check_file` has nothing against; gives the handle.

    Neither a link nor a pipe or a device is ever opened. O_TRUNC is no use: it would empty a file
    before it is checked; call `os.ftruncate` on the handle.

    Args:
        path: the file.
        flags: as of `os.open`.
        mode: of a file that is made; the process's umask does not count.
        most_bytes: see `check_file`.

    Raises:
        UnsafeFileError: as `check_file`.
        OSError: it cannot be opened.
    """
    if flags & os.O_TRUNC:
        raise ValueError("a file is checked before it is emptied")
    is_new = check_file(path, most_bytes) is None
    handle = os.open(path, flags | SAFE_FLAGS, mode)
    try:
        state = os.fstat(handle)
        _check_state(path, state, most_bytes)
        if is_new and flags & os.O_CREAT and sys.platform != "win32":
            with contextlib.suppress(OSError):  # a disk that knows no permissions
                os.fchmod(handle, mode)
    except BaseException:
        os.close(handle)
        raise
    return handle


def read_file(path: Path, most_bytes: int) -> bytes:
    """All bytes of a file that `check_file` has nothing against.

    Raises:
        UnsafeFileError: as `check_file`.
        OSError: it cannot be read; FileNotFoundError where nothing is there.
    """
    with os.fdopen(open_file(path, most_bytes=most_bytes), "rb") as file:
        return file.read(most_bytes)


def real_path(path: Path) -> Path:
    """The file itself where a path is a link to it; links that lead nowhere in a circle stay.

    So does a path that cannot be looked at: whoever opens it tells.
    """
    try:
        is_link = stat.S_ISLNK(look_at(path).st_mode)
    except (OSError, ValueError):
        is_link = False
    return Path(os.path.realpath(path)) if is_link else path


def kind_of(path: Path) -> Message:
    """What stands at a path, as a sentence needs it: "a file", "a link", "a device" and so on.

    Raises OSError where it cannot be looked at, FileNotFoundError where nothing is there.
    """
    return _kind_of(look_at(path))


def permissions_of(path: Path) -> int:
    """Who may read and write a file, for files beside it; only the user where it is not there."""
    try:
        return stat.S_IMODE(path.stat().st_mode) & 0o666 | 0o600
    except OSError:
        return 0o600


def sync_folder(folder: Path) -> None:
    """Make a folder's new names last through a power cut.

    Windows does so by itself, and some network disks cannot: there is nothing to do about either.
    Raises OSError where the disk fails: the names may not last.
    """
    if sys.platform == "win32":
        return
    try:
        handle = os.open(folder, os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)
    except OSError as why:
        if why.errno not in _FOLDERS_NOT_SYNCED:
            raise


def _check_state(
    path: Path, state: os.stat_result, most_bytes: int | None, *, is_written: bool = True
) -> None:
    _check_kind(path, state, stat.S_IFREG)
    if not _is_own(state, path.parent):
        raise _foreign(path, state)
    if is_written and state.st_nlink > 1:  # 0: it was removed a moment ago, and is ours alone
        raise UnsafeFileError(
            "{path} has {count} names (hard links), so writing it would change another file",
            "put a copy in its place",
            path=path,
            count=state.st_nlink,
        )
    if most_bytes is not None and state.st_size > most_bytes:
        raise UnsafeFileError(
            "{path} has {size} bytes; at most {most_bytes} are read",
            "move it away",
            path=path,
            size=state.st_size,
            most_bytes=most_bytes,
        )


def _check_kind(path: Path, state: os.stat_result, kind: int) -> None:
    found = _kind_of(state)
    if found == A_LINK:
        raise UnsafeFileError("{path} is a link, which is not followed", "remove it", path=path)
    if found != _KINDS[kind]:
        raise UnsafeFileError(
            "{path} is {found}, not {kind}",
            "move it away",
            path=path,
            found=found,
            kind=_KINDS[kind],
        )


def _kind_of(state: os.stat_result) -> Message:
    if _is_reparse_point(state):
        return A_LINK
    return _KINDS.get(stat.S_IFMT(state.st_mode), msg("something else"))


def _is_reparse_point(state: os.stat_result) -> bool:
    """Windows: whether it leads elsewhere, as junctions do, which are no symbolic links."""
    if sys.platform == "win32":
        tags = (stat.IO_REPARSE_TAG_SYMLINK, stat.IO_REPARSE_TAG_MOUNT_POINT)
        return state.st_reparse_tag in tags
    return False


def _is_own(state: os.stat_result, folder: Path) -> bool:
    """Whether what stands in a folder is the user's own; Windows goes by access rights alone."""
    if sys.platform == "win32":
        return True
    user = os.geteuid()
    if state.st_uid == user or (user == 0 and state.st_uid == folder.stat().st_uid):
        return True
    return state.st_uid == _owner_of_new_files(folder)


def _owner_of_new_files(folder: Path) -> int | None:
    """Whose a file is that this user makes in a folder; None where none can be made."""
    with contextlib.suppress(OSError), tempfile.TemporaryFile(dir=folder) as probe:
        return os.fstat(probe.fileno()).st_uid
    return None


def _foreign(path: Path, state: os.stat_result) -> UnsafeFileError:
    return UnsafeFileError(
        "{path} belongs to {owner}, not to you",
        "save the session under another name, or in a folder of your own",
        path=path,
        owner=_user_name(state.st_uid),
    )


def _user_name(user: int) -> str:
    if sys.platform != "win32":
        import pwd

        with contextlib.suppress(KeyError, OSError):
            return msg("the user {name}", name=pwd.getpwuid(user).pw_name)
    return msg("the user with the number {user}", user=user)


def _close_to_others(folder: Path) -> None:
    """Take others' access to a folder away where it is the user's to do so."""
    if sys.platform == "win32":
        return
    with contextlib.suppress(OSError):  # a disk that knows no permissions
        handle = os.open(folder, os.O_RDONLY | os.O_DIRECTORY | SAFE_FLAGS)
        try:
            state = os.fstat(handle)
            if state.st_uid == os.geteuid() and state.st_mode & _OTHERS:
                os.fchmod(handle, stat.S_IMODE(state.st_mode) & ~_OTHERS)
        finally:
            os.close(handle)
