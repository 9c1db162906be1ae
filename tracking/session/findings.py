"""Damage that was found of a session, kept in its file: saving it must not wipe the sign."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass, fields

import h5py

from tracking.session.hdf5 import text_attribute
from tracking.translation import Message, msg

CHECKSUM = msg(
    "its checksum did not hold, so names, texts or whole edits and labels in it may be wrong or "
    "missing"
)
_NAME = "damage"
_MOST, _LONGEST = 20, 500
_LONGEST_TEXT = 1 << 17


@dataclass(frozen=True, slots=True)
class Finding:
    """That a session was found damaged.

    Attributes:
        found: when; UTC, ISO 8601. what: in a line.
        kept: name of the file in the folder beside the session that is as it was found; "": none.
        accepted: when somebody took the session as it is, and it is told no more; "": not yet.
    """

    found: str
    what: str
    kept: str = ""
    accepted: str = ""

    def note(self, path: object) -> Message:
        """What is told of it at every reading of the session at `path`."""
        when = msg(" on {found} UTC", found=self.found[:19].replace("T", " ")) if self.found else ""
        kept = (
            msg(" (as it was then: {kept} in the folder beside it)", kept=self.kept)
            if self.kept
            else ""
        )
        return msg(
            "{path} was found damaged{when}: {what}{kept}; restore a backup, or accept "
            "it as it is (trackwright restore --accept-damage)",
            path=path,
            when=when,
            what=self.what,
            kept=kept,
        )


_FIELDS = tuple(field.name for field in fields(Finding))
_UNREADABLE = Finding("", msg("what it says of damage that was found before cannot be read"))


def write_findings(file: h5py.File, findings: Sequence[Finding]) -> None:
    """Keep the latest in the file; where there are none, nothing is written."""
    if findings:
        said = [asdict(one) for one in findings[-_MOST:]]
        file.attrs[_NAME] = json.dumps(said)


def read_findings(file: h5py.File) -> tuple[Finding, ...]:
    """What was found, oldest first. A record that is damaged itself is told like any other."""
    if _NAME not in file.attrs:
        return ()
    try:
        text = text_attribute(file, _NAME)
        said: list[dict[str, object]] = json.loads(text if len(text) <= _LONGEST_TEXT else "")
        return tuple(_finding(one) for one in said[-_MOST:])
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        return (_UNREADABLE,)


def _finding(said: dict[str, object]) -> Finding:
    """One as it is kept: short printable lines, for terminals and the window."""
    lines = (" ".join(str(said[name]).split())[:_LONGEST] for name in _FIELDS)
    return Finding(*("".join(s if s.isprintable() else "?" for s in line) for line in lines))
