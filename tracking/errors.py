"""The errors this library raises on purpose.

Every message says in one line what is wrong, where, and what to do about it. Whatever else a
library below raises is converted at the boundary where it is called.
"""

from __future__ import annotations

import errno
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Self

_TO_DO = {
    errno.EACCES: "choose another place, or have its owner let you",
    errno.EPERM: "choose another place, or have its owner let you",
    errno.ENOENT: "check the path",
    errno.ENOTDIR: "a part of the path is no folder; check it",
    errno.EISDIR: "name a file in it",
    errno.ELOOP: "its links lead round in a circle; name the file itself",
    errno.ENAMETOOLONG: "give a shorter one",
    errno.ENOSPC: "make room",
    errno.EDQUOT: "make room",
    errno.EFBIG: "choose another disk",
    errno.EROFS: "choose another place",
    errno.EIO: "check the disk, and bring a copy of what is on it",
    errno.EMFILE: "close other programs and try again",
}
_OF_NO_FILE = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EROFS, errno.EIO, errno.EMFILE)
"""What the system says of writing without naming the file, and is no mistake of the program."""


_BEGINNING, _END = 2000, 900
"""Letters that a reason keeps where it is longer than both: a file may hold a value of any size."""


class TrackwrightError(Exception):
    """Root of all errors a user can do something about.

    Attributes:
        reason: what is wrong, and where; the middle of a very long one is left out.
        to_do: what to do about it, for whoever knows another way; "" where the reason says it all.
    """

    def __init__(self, reason: str = "", to_do: str = "") -> None:
        """The message is the reason, then what to do."""
        if len(reason) > _BEGINNING + _END:
            reason = f"{reason[:_BEGINNING]} ... {reason[-_END:]}"
        super().__init__(f"{reason}; {to_do}" if to_do else reason)
        self.reason, self.to_do = reason, to_do

    def advising(self, to_do: str) -> Self:
        """The same error with something else to do about it."""
        return type(self)(self.reason, to_do)


class RecordingError(TrackwrightError):
    """A recording cannot be opened or a frame of it cannot be read."""


class CalibrationError(TrackwrightError):
    """A calibration is missing, unreadable or does not fit the recording."""


class SettingsError(TrackwrightError):
    """A tracker's setting is unknown or out of range."""


class SessionError(TrackwrightError):
    """A session file cannot be read or written."""


class UnsafeFileError(SessionError):
    """A file or folder beside a session is not one that this program would have made there."""


class EditError(TrackwrightError):
    """An edit does not apply to the tracks as they are."""


class FormatError(TrackwrightError):
    """A file of another format cannot be read or written."""


class UnitUnsaidError(FormatError):
    """A text does not say the unit of its lengths; whoever knows it may state it."""


class CountingError(TrackwrightError):
    """People cannot be counted the way that was asked for."""


class TrainingError(TrackwrightError):
    """The samples are too few or too alike to train a detector from."""


class OutputError(TrackwrightError):
    """A result cannot be written where it was asked for."""


class CancelledError(TrackwrightError):
    """The user stopped long work; nothing half-done was kept."""


@contextmanager
def explain_unreadable(path: Path) -> Iterator[None]:
    """Turn what the system says of a file that cannot be read into one line, a FormatError."""
    try:
        yield
    except OSError as error:
        raise FormatError(f"cannot read {path}: {error.strerror}; check the path") from error


def told_by_system(error: BaseException) -> str:
    """What the system says of a file, as a line a user can act on; "" where it is of none.

    For errors that nothing below foresaw: it names the file, not what it was wanted for.
    """
    if not isinstance(error, OSError) or error.errno is None:
        return ""
    names = [
        os.fsdecode(name)
        for name in (error.filename, error.filename2)
        if isinstance(name, str | bytes | os.PathLike)
    ]
    if not names and error.errno not in _OF_NO_FILE:
        return ""
    what = f"use {' and '.join(names)}" if names else "go on"
    to_do = _TO_DO.get(error.errno, "check the path and its disk")
    return f"cannot {what}: {error.strerror or type(error).__name__}; {to_do}"
