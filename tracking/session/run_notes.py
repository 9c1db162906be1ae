"""What a tracker told of its work, kept with its run."""

from __future__ import annotations

import json
from collections.abc import Sequence

import h5py

from tracking.session.hdf5 import text_attribute
from tracking.translation import Message

MOST_NOTES, LONGEST_NOTE = 20, 500
_NAME = "notes"
_LONGEST_TEXT = 1 << 20


def write_notes(group: h5py.Group, notes: Sequence[str]) -> None:
    """Keep a run's notes in its group; where there are none, nothing is written."""
    if notes:
        group.attrs[_NAME] = json.dumps(_within(notes), ensure_ascii=False)


def read_notes(group: h5py.Group) -> tuple[Message, ...]:
    """The notes of a run, a printable line each; none where the file has none.

    Of more or longer ones than are ever written the rest is left out. Raises ValueError where the
    file has something else there.
    """
    if _NAME not in group.attrs:
        return ()
    text = text_attribute(group, _NAME)
    notes = json.loads(text) if len(text) <= _LONGEST_TEXT else None
    if not isinstance(notes, list) or not all(isinstance(note, str) for note in notes):
        raise ValueError(f"attribute {_NAME} of {group.name} is no list of lines")
    return tuple(Message("{text}", text=note) for note in _within(notes))


def _within(notes: Sequence[str]) -> list[str]:
    """Printable lines in the bounds of what is kept: they are put on terminals as they are."""
    return [_printable(" ".join(note.split())[:LONGEST_NOTE]) for note in notes[:MOST_NOTES]]


def _printable(line: str) -> str:
    """A line with "?" for what steers terminals, or is no sign at all."""
    return "".join(sign if sign.isprintable() else "?" for sign in line)
