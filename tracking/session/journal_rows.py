"""Steps as rows of a journal, each with a checksum that stands for it and all rows before it."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

from tracking.editing import Entry, Scope, up_to_date
from tracking.errors import EditError
from tracking.message_data import kept_message, kept_values

Act = Literal["apply", "undo", "redo"]
_ACTS = frozenset({"apply", "undo", "redo"})
Row = tuple[Any, ...]
"""A value for each of `COLUMNS`."""
COLUMNS = (
    *("number", "act", "edit", "time", "author", "kind", "text", "frame"),
    *("before", "after", "undoes", "scope", "message", "checksum"),
)
_TYPES = (int, str, int, str, str, str, str, int, str, str, int, str, str, str)
_CHECKSUM_BYTES = 8
"""Damage is found out by them, not malice."""


@dataclass(frozen=True, slots=True)
class Step:
    """One line of the journal.

    Attributes:
        number: from 1, counted since the save the journal builds on.
        act: what was done: an edit applied, or one undone or redone.
        entry: the edit; for undo and redo only its id counts.
    """

    number: int
    act: Act
    entry: Entry


@dataclass(frozen=True, slots=True)
class Contents:
    """What a journal holds.

    Attributes:
        steps: those from the first on that are as they were written.
        problem: why there are no more, in a few words; "" where nothing is damaged or missing.
    """

    steps: tuple[Step, ...]
    problem: str = ""


@dataclass(frozen=True, slots=True)
class Pieces:
    """A text that is too large to be held whole.

    Attributes:
        size_bytes: of all of it, in UTF-8.
        parts: its bytes, in order.
    """

    size_bytes: int
    parts: Iterable[bytes]


def first_checksum(session: str, save: str) -> str:
    """The checksum the first step follows on: it stands for the save a journal builds on."""
    return checksum("", (session, save))


def row_of(step: Step, before: str) -> Row:
    """The row of a step; before: the checksum of the one before it."""
    entry, applied = step.entry, step.act == "apply"
    values = (
        *(step.number, step.act, entry.id, entry.time, entry.author, entry.kind),
        *(entry.text, entry.frame),
        *((entry.before, entry.after) if applied else ("", "")),
        *(entry.undoes, entry.scope.as_text if entry.scope else ""),
        kept_values(entry.text) if applied else "",
    )
    return (*values, row_checksum(before, values))


def number_rows(rows: Iterable[Row], session: str, save: str) -> Iterator[Row]:
    """The rows with numbers from 1 on and checksums that build on another save."""
    before = first_checksum(session, save)
    for number, row in enumerate(rows, 1):
        values = (number, *row[1:-1])
        before = row_checksum(before, values)
        yield (*values, before)


def steps_of(rows: Iterable[Row], before: str) -> Iterator[Step]:
    """The steps of rows, from the first on. Raises ValueError in a few words for a damaged one."""
    for number, row in enumerate(rows, 1):
        if tuple(map(type, row)) != _TYPES or row[0] != number or row[1] not in _ACTS:
            raise ValueError(f"step {number} is damaged")
        before = row_checksum(before, row[:-1])
        if row[-1] != before:
            raise ValueError(f"step {number} is damaged: it is not what its checksum says")
        yield _step(row)


def _step(row: Row) -> Step:
    number, act, *said, undoes, scope, message, _ = row
    try:
        made = replace(Entry(*said), undoes=undoes, scope=Scope.of_text(scope))
        return Step(number, act, up_to_date(replace(made, text=kept_message(made.text, message))))
    except EditError as why:
        raise ValueError(f"step {number} is damaged: {why}") from why


def row_checksum(before: str, values: Sequence[Any]) -> str:
    """Of a step's values but its checksum.

    A message that is not there does not count: older programs, which kept none, made it so.
    """
    return checksum(before, values if values[-1] else values[:-1])


def checksum(before: str, values: Iterable[Any]) -> str:
    """Of values and all that stands before them; where one ends and the next begins counts."""
    seen = hashlib.blake2b(before.encode(), digest_size=_CHECKSUM_BYTES)
    for value in values:
        pieces = value if isinstance(value, Pieces) else _whole(value)
        seen.update(pieces.size_bytes.to_bytes(8, "little"))
        for part in pieces.parts:
            seen.update(part)
    return seen.hexdigest()


def _whole(value: object) -> Pieces:
    text = str(value).encode("utf-8", "surrogatepass")
    return Pieces(len(text), (text,))


def text_bytes(row: Row) -> int:
    """How much room the texts of a row take."""
    return sum(len(said.encode("utf-8", "surrogatepass")) for said in row if isinstance(said, str))
