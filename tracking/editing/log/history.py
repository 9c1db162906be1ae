"""The log of edits with undo and redo without limit."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from tracking.editing.core.change import Change
from tracking.editing.core.scope import Scope
from tracking.editing.log.edit_footprint import ROWS, differing_fields, footprint_of
from tracking.editing.log.text import state_as_text, state_from_text
from tracking.editing.log.touch_index import TouchIndex
from tracking.editing.log.traces import Trace, parts_at_its_frame
from tracking.errors import EditError
from tracking.tracks import Labels, TrackLabel
from tracking.translation import Message, msg

UNDO = "undo"
"""The kind of a change that takes one old edit back."""
_LONGEST_TEXT = 200


@dataclass(frozen=True, slots=True)
class Entry:
    """One edit in the log.

    Attributes:
        id: from 1, in the order the edits were made.
        time: UTC, ISO 8601 to the millisecond.
        author: who made it.
        kind, text, frame: of the change; one word, what is done, where to look at it.
        before, after: the two sides of the change as text (see `state_as_text`).
        undone: whether it is taken back.
        abandoned: taken back, and then something else was done: it cannot be redone.
        undoes: the older edit that this one takes back alone; 0: none, it is an edit of its own.
        scope: the frames it was made for; None: none, or a program that did not keep it made it.
    """

    id: int
    time: str
    author: str
    kind: str
    text: Message
    frame: int
    before: str
    after: str
    undone: bool = False
    abandoned: bool = False
    undoes: int = 0
    scope: Scope | None = None

    @property
    def change(self) -> Change:
        """What was done. It is kept as text and read anew each time: a log may be long.

        Raises EditError where the text is no change, as in a damaged file.
        """
        before, after = state_from_text(self.before), state_from_text(self.after)
        return Change(self.kind, self.text, self.frame, before, after, self.scope)


@dataclass(frozen=True, slots=True, eq=False)
class StoredChange:
    """A change with its two sides as the log keeps them.

    Of hundreds of thousands of rows that takes a while, and any thread may do it ahead.

    Attributes:
        change: the change. before, after: see `state_as_text`.
    """

    change: Change
    before: str
    after: str

    @classmethod
    def of(cls, change: Change) -> StoredChange:
        """Write it. Raises EditError where it is more than the log can keep."""
        return cls(change, state_as_text(change.before), state_as_text(change.after))


class History:
    """Entries in order. It keeps books only; whoever applies a change tells it."""

    def __init__(self, entries: Iterable[Entry] = (), touches: TouchIndex | None = None) -> None:
        """Take up a log as it was saved, with what its edits touch where that is known.

        Raises EditError for a log that cannot be.
        """
        self._entries = list(entries)
        self._touches = TouchIndex() if touches is None else touches
        self._traces: dict[int, Trace] = {}
        if [entry.id for entry in self._entries] != list(range(1, len(self._entries) + 1)):
            raise EditError("the log of edits is not numbered from 1 on without gaps")
        if any(not 0 <= entry.undoes < entry.id for entry in self._entries):
            raise EditError("the log of edits has an edit that undoes a later one")
        self._done = [at for at, entry in enumerate(self._entries) if not entry.undone]
        self._undone = [
            at
            for at, entry in reversed(list(enumerate(self._entries)))
            if entry.undone and not entry.abandoned
        ]
        if self._done and self._undone and self._undone[-1] < self._done[-1]:
            raise EditError("the log of edits has an undone edit before one that is in force")
        self._takers: dict[int, int] = {}
        for entry in reversed(self._entries):
            if entry.undoes and not entry.undone and entry.id not in self._takers:
                self._takers[entry.undoes] = entry.id

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

    def entry(self, number: int) -> Entry:
        """The entry with that id. Raises EditError where there is none."""
        if not 1 <= number <= len(self._entries):
            raise EditError(
                "there is no edit {number}; the log has {count}",
                number=number,
                count=len(self._entries),
            )
        return self._entries[number - 1]

    @property
    def next_undo(self) -> Entry | None:
        """The edit undo takes back next."""
        return self._entries[self._done[-1]] if self._done else None

    @property
    def next_redo(self) -> Entry | None:
        """The edit redo makes again next."""
        return self._entries[self._undone[-1]] if self._undone else None

    @property
    def touches(self) -> dict[str, NDArray[np.int64]]:
        """What the edits touch, as far as that was worked out: see `TouchIndex.columns`."""
        return self._touches.columns

    @property
    def touched_rows(self) -> NDArray[np.int64]:
        """(k, 4) edit, track, start, end of the rows that edits touch, as far as in `touches`."""
        known = self.touches
        columns = [known[name] for name in ("edit", "of", "start", "end")]
        rows: NDArray[np.int64] = np.column_stack(columns)
        return np.asarray(rows[known["kind"] == ROWS])

    def trace(self, number: int) -> Trace:
        """What an edit left on rows; worked out once, and kept.

        Raises EditError where there is no such edit, or its line of the log is damaged.
        """
        found = self._traces.get(number)
        if found is None:
            entry = self.entry(number)
            is_cut = parts_at_its_frame(entry.kind, entry.scope)
            found = Trace.of_texts(entry.before, entry.after, is_cut=is_cut)
            found = self._traces[number] = found or Trace.of(entry.change)
        return found

    def snapshot(self) -> History:
        """The log as it is now, for another thread; what is known of its edits is shared.

        What it says of an edit to undo alone is worked out anew.
        """
        copy = History(self._entries)
        copy._traces = self._traces
        return copy

    # An old edit alone

    def taken_back_by(self, number: int) -> int:
        """The later edit in force that takes this one back alone; 0: none does."""
        return self._takers.get(number, 0)

    @property
    def in_force(self) -> Iterator[Entry]:
        """The edits whose effect is there, oldest first: neither undone nor taken back alone.

        An edit that takes one back is none of them: both together are nothing.
        """
        return (
            one
            for one in self._entries
            if not one.undone and not one.undoes and one.id not in self._takers
        )

    @property
    def position(self) -> tuple[int, int, int]:
        """Another one after each edit that is made, undone or done again."""
        undo, redo = self.next_undo, self.next_redo
        return len(self), undo.id if undo else 0, redo.id if redo else 0

    def why_not_alone(self, number: int) -> str:
        """Why an edit cannot be undone alone, in one line; "" where it can.

        It can where no later edit in force touches what it touched: rows of the same tracks in the
        same frames, the same label. Raises EditError where there is no such edit.
        """
        entry = self.entry(number)
        if entry.undone:
            return msg("edit {number} is undone already", number=number)
        if taker := self.taken_back_by(number):
            return msg(
                "edit {number} is undone already, by edit {taker}", number=number, taker=taker
            )
        try:
            standing = self._standing_on(number)
        except EditError as why:  # a damaged line of the log
            return why.message
        if not standing:
            return Message()
        last = self._entries[standing[-1] - 1]
        others = len(standing) - 1
        return msg(
            '"{text}" (edit {edit}) was made on top of it: undo that first, then {others} more'
            if others
            else '"{text}" (edit {edit}) was made on top of it: undo that first',
            text=last.text,
            edit=last.id,
            others=others,
        )

    def _standing_on(self, number: int) -> list[int]:
        """The later edits that touch what an edit touched, ascending.

        An edit and the later one that takes it back are together nothing, unless only one of them
        is later.
        """
        if self._touches.edits < len(self._entries):
            self._look_up([at + 1 for at in self._done[bisect_left(self._done, number) :]])
        own = footprint_of(self.entry(number).change)
        return [
            edit
            for edit in self._touches.later(number, own)
            if not self._entries[edit - 1].undone
            and edit not in self._takers
            and not self._entries[edit - 1].undoes > number
        ]

    def _look_up(self, edits: Iterable[int]) -> None:
        """Work out what edits touch whose lines came from a file that does not say so."""
        for edit in edits:
            if edit not in self._touches:
                self._touches.add(edit, footprint_of(self._entries[edit - 1].change))

    # Keeping books

    def draft(
        self,
        change: Change,
        time: str,
        author: str,
        undoes: int = 0,
        written: StoredChange | None = None,
    ) -> Entry:
        """The entry a change will have once it is added; written: of this change, or of another."""
        if written is None or written.change is not change:
            written = StoredChange.of(change)
        number, what = len(self._entries) + 1, (change.kind, change.text, int(change.frame))
        return Entry(
            *(number, time, author, *what, written.before, written.after),
            undoes=undoes,
            scope=change.scope,
        )

    def add(self, entry: Entry, change: Change | None = None) -> None:
        """Log a change that was made; what was undone before cannot be redone any more.

        change: the entry's, where it is at hand.
        """
        if entry.id != len(self._entries) + 1 or entry.undone:
            raise EditError("edit {edit} is not the next of the log", edit=entry.id)
        # What may take much memory is first: where it does not suffice, nothing has changed.
        boxes = footprint_of(entry.change if change is None else change)
        abandoned = [(at, replace(self._entries[at], abandoned=True)) for at in self._undone]
        self._touches.add(entry.id, boxes)
        for at, older in abandoned:
            self._entries[at] = older
        self._undone.clear()
        self._done.append(len(self._entries))
        self._entries.append(entry)
        self._take_back(entry, in_force=True)

    def mark_undone(self) -> Entry:
        """Log that the last edit in force was taken back."""
        if not self._done:
            raise EditError("nothing to undo")
        at = self._done.pop()
        self._undone.append(at)
        self._entries[at] = replace(self._entries[at], undone=True)
        self._take_back(self._entries[at], in_force=False)
        return self._entries[at]

    def mark_redone(self) -> Entry:
        """Log that the edit taken back last was made again."""
        if not self._undone:
            raise EditError("nothing to redo")
        at = self._undone.pop()
        self._done.append(at)
        self._entries[at] = replace(self._entries[at], undone=False)
        self._take_back(self._entries[at], in_force=True)
        return self._entries[at]

    def _take_back(self, entry: Entry, *, in_force: bool) -> None:
        """Note what an edit that undoes another one alone means for that one, and so on."""
        while entry.undoes:
            if in_force:
                self._takers[entry.undoes] = entry.id
            else:
                self._takers.pop(entry.undoes, None)
            entry, in_force = self._entries[entry.undoes - 1], not in_force


def _undo_text(entry: Entry) -> Message:
    """What taking an edit back is called; an edit that undoes one that undoes one ... is cut."""
    whole = msg("Undo edit {number} alone: {text}", number=entry.id, text=entry.text)
    if len(whole) <= _LONGEST_TEXT:
        return whole
    kept = len(entry.text) - (len(whole) - _LONGEST_TEXT) - 1
    return msg("Undo edit {number} alone: {text}", number=entry.id, text=f"{entry.text[:kept]}…")


def plan_undo_alone(history: History, labels: Labels, number: int) -> Change:
    """Take one edit of the log back, and leave in force what was done after it.

    The tables and labels are then what they would be had all edits in force been made but that
    one. Raises EditError that names the later edit which stands on it (see
    `History.why_not_alone`).
    """
    why = history.why_not_alone(number)
    if why:
        raise EditError(why)
    entry = history.entry(number)
    old = entry.change.inverse
    before, after = _as_labelled_now(old.before.labels.tracks, old.after.labels.tracks, labels)
    return Change(
        UNDO,
        _undo_text(entry),
        entry.frame,
        replace(old.before, labels=replace(old.before.labels, tracks=before)),
        replace(old.after, labels=replace(old.after.labels, tracks=after)),
        entry.scope,
    )


def _as_labelled_now(
    before: Mapping[int, TrackLabel], after: Mapping[int, TrackLabel], labels: Labels
) -> tuple[dict[int, TrackLabel], dict[int, TrackLabel]]:
    """Both sides with the fields the change does not touch as they are now."""
    now = {track: labels.of_track(track) for track in before}
    return now, {track: _with_fields(now[track], before[track], after[track]) for track in now}


def _with_fields(now: TrackLabel, before: TrackLabel, after: TrackLabel) -> TrackLabel:
    """The label of now with those fields of after in which it differs from before."""
    fields = set(differing_fields(before, after))
    attributes = {
        key: value for key, value in now.attributes.items() if f"attribute {key}" not in fields
    }
    said = {key: value for key, value in after.attributes.items() if f"attribute {key}" in fields}
    return TrackLabel(
        after.name if "name" in fields else now.name,
        dict(sorted({**attributes, **said}.items())),
        after.notes if "notes" in fields else now.notes,
    )
