"""The log of edits with undo and redo without limit."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

from tracking.editing.change import Change
from tracking.editing.text import state_as_text, state_from_text
from tracking.errors import EditError


@dataclass(frozen=True, slots=True)
class Entry:
    """One edit in the log.

    Attributes:
        id: from 1, in the order the edits were made.
        time: UTC, ISO 8601 to the millisecond.
        author: who made it.
        kind, text, frame: of the change; one word, a line as people read it, where to look at it.
        before, after: the two sides of the change as text (see `state_as_text`).
        undone: whether it is taken back.
        abandoned: taken back, and then something else was done: it cannot be redone.
    """

    id: int
    time: str
    author: str
    kind: str
    text: str
    frame: int
    before: str
    after: str
    undone: bool = False
    abandoned: bool = False

    @property
    def change(self) -> Change:
        """What was done. It is kept as text and read anew each time: a log may be long.

        Raises EditError where the text is no change, as in a damaged file.
        """
        before, after = state_from_text(self.before), state_from_text(self.after)
        return Change(self.kind, self.text, self.frame, before, after)


class History:
    """Entries in order. It keeps books only; whoever applies a change tells it."""

    def __init__(self, entries: Iterable[Entry] = ()) -> None:
        """Take up a log as it was saved."""
        self._entries = list(entries)
        if [entry.id for entry in self._entries] != list(range(1, len(self._entries) + 1)):
            raise EditError("the log of edits is not numbered from 1 on without gaps")
        self._done = [at for at, entry in enumerate(self._entries) if not entry.undone]
        self._undone = [
            at
            for at, entry in reversed(list(enumerate(self._entries)))
            if entry.undone and not entry.abandoned
        ]
        if self._done and self._undone and self._undone[-1] < self._done[-1]:
            raise EditError("the log of edits has an undone edit before one that is in force")

    def __len__(self) -> int:
        """The number of entries, undone ones too."""
        return len(self._entries)

    def __iter__(self) -> Iterator[Entry]:
        """All entries, oldest first."""
        return iter(self._entries)

    @property
    def entries(self) -> tuple[Entry, ...]:
        """All entries, oldest first."""
        return tuple(self._entries)

    @property
    def next_undo(self) -> Entry | None:
        """The edit undo takes back next."""
        return self._entries[self._done[-1]] if self._done else None

    @property
    def next_redo(self) -> Entry | None:
        """The edit redo makes again next."""
        return self._entries[self._undone[-1]] if self._undone else None

    def draft(self, change: Change, time: str, author: str) -> Entry:
        """The entry a change will have once it is added."""
        before, after = state_as_text(change.before), state_as_text(change.after)
        number = len(self._entries) + 1
        return Entry(number, time, author, change.kind, change.text, change.frame, before, after)

    def add(self, entry: Entry) -> None:
        """Log a change that was made; what was undone before cannot be redone any more."""
        if entry.id != len(self._entries) + 1 or entry.undone:
            raise EditError(f"edit {entry.id} is not the next of the log")
        for at in self._undone:
            self._entries[at] = replace(self._entries[at], abandoned=True)
        self._undone.clear()
        self._done.append(len(self._entries))
        self._entries.append(entry)

    def mark_undone(self) -> Entry:
        """Log that the last edit in force was taken back."""
        if not self._done:
            raise EditError("nothing to undo")
        at = self._done.pop()
        self._undone.append(at)
        self._entries[at] = replace(self._entries[at], undone=True)
        return self._entries[at]

    def mark_redone(self) -> Entry:
        """Log that the edit taken back last was made again."""
        if not self._undone:
            raise EditError("nothing to redo")
        at = self._undone.pop()
        self._done.append(at)
        self._entries[at] = replace(self._entries[at], undone=False)
        return self._entries[at]
