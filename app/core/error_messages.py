"""What went wrong, in words for the user: the one place where errors become messages."""

from __future__ import annotations

import logging

from app.core.i18n import sentence, strip_full_stop, tr
from tracking.errors import TrackwrightError, told_by_system
from tracking.session import RecordingMissing
from tracking.translation import Message, joined, msg

_log = logging.getLogger(__name__)


def explain(error: BaseException) -> str:
    """The message for an error.

    Those raised on purpose say what, where and what to do themselves; what the system says of a
    file is told with what to do. Anything else is a bug of the program: it is logged with where
    it came from, and the user is told that the edits are safe.
    """
    return tr(_reason(error))


def explain_in_sentence(error: BaseException) -> str:
    """The same as a sentence of its own; names of files at its beginning stay as they are."""
    return sentence(_reason(error))


def _reason(error: BaseException) -> Message:
    if isinstance(error, RecordingMissing):
        return msg(error.reason)
    if isinstance(error, TrackwrightError):
        # Without the option of the command line, which is no help in a window.
        return joined("; ", filter(None, (error.reason, error.to_do)))
    if told := told_by_system(error):
        _log.warning("unforeseen: %s", told, exc_info=error)
        return msg(told)
    _log.error("unexpected error", exc_info=error)
    return msg(
        "A bug in trackwright: {kind}: {error}. Your edits are safe on disk; save, and start the "
        "program again if it misbehaves.",
        kind=type(error).__name__,
        error=strip_full_stop(str(error)),
    )
