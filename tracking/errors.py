"""The errors this library raises on purpose.

Every message says in one line what is wrong, where, and what to do about it. An error is raised
with a template and values; the sentence in the user's language is made of its `message` where it
is shown. Whatever else a library below raises is converted at the boundary where it is called.
"""

from __future__ import annotations

import errno
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Self

from tracking.translation import N_, Message, joined, msg

_TO_DO = {
    errno.EACCES: N_("choose another place, or have its owner let you"),
    errno.EPERM: N_("choose another place, or have its owner let you"),
    errno.ENOENT: N_("check the path"),
    errno.ENOTDIR: N_("a part of the path is no folder; check it"),
    errno.EISDIR: N_("name a file in it"),
    errno.ELOOP: N_("its links lead round in a circle; name the file itself"),
    errno.ENAMETOOLONG: N_("give a shorter one"),
    errno.ENOSPC: N_("make room"),
    errno.EDQUOT: N_("make room"),
    errno.EFBIG: N_("choose another disk"),
    errno.EROFS: N_("choose another place"),
    errno.EIO: N_("check the disk, and bring a copy of what is on it"),
    errno.EMFILE: N_("close other programs and try again"),
}
_OF_NO_FILE = (
    *(errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EROFS, errno.EIO, errno.EMFILE),
    *(errno.EACCES, errno.EPERM),
)
"""What the system says of writing without naming the file, and is no mistake of the program."""


_BEGINNING, _END = 2000, 900
"""Letters that a reason keeps where it is longer than both: a file may hold a value of any size."""


class TrackwrightError(Exception):
    """Root of all errors a user can do something about.

    Attributes:
        reason: what is wrong, and where; the middle of a very long one is left out.
        to_do: what to do about it, for whoever knows another way; "" where the reason says it all.
        option: of the command line, by which it is done there; "" where there is none.
        message: all of this; `str` of the error is the same in English.
    """

    def __init__(
        self, reason: str = "", to_do: str = "", /, *, option: str = "", **values: object
    ) -> None:
        """Reason and to_do are templates with {named} places for the values, or messages."""
        self.reason: Message = msg(reason, **values)
        if len(self.reason) > _BEGINNING + _END:
            self.reason = self.reason.cut_by(_without_middle)
        self.to_do: Message = msg(to_do, **values)
        self.option = option
        self.message: Message = joined("; ", filter(None, (self.reason, self.to_do)))
        if option:
            self.message = joined(" ", (self.message, f"({option})"))
        super().__init__(self.message)

    def advising(self, to_do: str, /, *, option: str = "", **values: object) -> Self:
        """The same error with something else to do about it."""
        return type(self)(self.reason, msg(to_do, **values), option=option)


def _without_middle(text: str) -> str:
    cut = len(text) > _BEGINNING + _END
    return f"{text[:_BEGINNING]} ... {text[-_END:]}" if cut else text


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


class PluginError(TrackwrightError):
    """A plug-in cannot be loaded, or failed at its work; the message names it."""


class CancelledError(TrackwrightError):
    """The user stopped long work; nothing half-done was kept."""


@contextmanager
def explain_unreadable(path: Path) -> Iterator[None]:
    """Turn what the system says of a file that cannot be read into one line, a FormatError."""
    try:
        yield
    except OSError as error:
        raise FormatError(
            "cannot read {path}: {reason}; check the path", path=path, reason=error.strerror
        ) from error


def told_by_system(error: BaseException) -> Message:
    """What the system says of a file, as a line a user can act on; "" where it is of none.

    For errors that nothing below foresaw: it names the file, not what it was wanted for.
    """
    if not isinstance(error, OSError) or error.errno is None:
        return Message()
    names = [
        os.fsdecode(name)
        for name in (error.filename, error.filename2)
        if isinstance(name, str | bytes | os.PathLike)
    ]
    if not names and error.errno not in _OF_NO_FILE:
        return Message()
    return msg(
        "cannot use {names}: {reason}; {to_do}" if names else "cannot go on: {reason}; {to_do}",
        names=joined(" and ", names),
        reason=error.strerror or type(error).__name__,
        to_do=msg(_TO_DO.get(error.errno, N_("check the path and its disk"))),
    )
