"""What people should be told of a session that is read: said here, whoever reads it and why.

Every way into a session comes upon its notes: opening it, looking into it, describing it, reading
its log or a backup. Each says them to the logger of this module as it finds them, damage as
warnings and all else as information. A program that listens there tells all of them; the window
shows those of the session it has open instead (`Session.notes`). That a session opened for reading
only is not said here: it concerns who wants to write, and is their error.
"""

from __future__ import annotations

import logging
from pathlib import Path

from tracking.translation import Message, msg

LOGGER = "tracking.session.notes"
_log = logging.getLogger(LOGGER)
_log.setLevel(logging.INFO)
_log.addHandler(logging.NullHandler())

MAY_MISS = msg("edits made after the session was saved last may be missing")


def tell(note: Message) -> Message:
    """Say a note, a line; gives it."""
    _log.info(note)
    return note


def tell_damage(note: Message) -> Message:
    """Say what is damaged or may be missing, in a line; gives it."""
    _log.warning(note)
    return note


def note_of_change(path: Path) -> Message:
    """The note on a file that is not as it was saved."""
    return msg(
        "{path} is damaged: its checksum does not hold, so names, texts or whole edits and labels "
        "in it may be wrong or missing; compare it with a copy or a backup",
        path=path,
    )


def note_of_missing_seal(path: Path) -> Message:
    """The note on a file that must have a checksum and has none."""
    return msg(
        "{path} is damaged at its end, or another program wrote into it: the checksum that every "
        "save ends with is gone, so it cannot be told whether names, texts, edits and labels in it "
        "are as they were saved; compare it with a copy or a backup",
        path=path,
    )
