"""Tracks and labels with the log of what people did to them, and nothing of files."""

from __future__ import annotations

from collections.abc import Callable

from tracking.editing import Change, Entry, History, apply_change
from tracking.errors import EditError
from tracking.session.journal import Act
from tracking.tracks import Labels, TrackTable


class EditedTracks:
    """The corrected table, the labels and their history, always in step with each other."""

    def __init__(self, tracks: TrackTable, labels: Labels, history: History) -> None:
        """As they were saved."""
        self.tracks = tracks
        self.labels = labels
        self.history = history

    def next(self, act: Act) -> Entry:
        """The entry undo or redo is about. Raises EditError where there is none."""
        entry = self.history.next_undo if act == "undo" else self.history.next_redo
        if entry is None:
            raise EditError("nothing to {act}", act=act)
        return entry

    def do(
        self, act: Act, entry: Entry, change: Change, keep: Callable[[Act, Entry], None]
    ) -> Entry:
        """Validate, apply, have it kept, then log it; where any of it fails, nothing has changed.

        change: the entry's own, as it was made; undo applies its inverse.
        """
        made = change.inverse if act == "undo" else change
        labels = apply_change(self.tracks, self.labels, made)
        try:
            keep(act, entry)
            logged = self._log(act, entry, change)
        except BaseException:
            apply_change(self.tracks, labels, made.inverse)
            raise
        self.labels = labels
        return logged

    def _log(self, act: Act, entry: Entry, change: Change) -> Entry:
        if act == "undo":
            return self.history.mark_undone()
        if act == "redo":
            return self.history.mark_redone()
        self.history.add(entry, change)
        return entry

    def replay(self, act: Act, entry: Entry) -> None:
        """Do again what a journal says was done.

        Raises EditError where it does not follow on what is there.
        """
        known = entry if act == "apply" else self.next(act)
        if known.id != (len(self.history) + 1 if act == "apply" else entry.id):
            raise EditError(
                "the journal is about edit {edit}, not about edit {other}",
                edit=entry.id,
                other=known.id,
            )
        self.do(act, known, known.change, _kept_already)


def _kept_already(act: Act, entry: Entry) -> None:
    """What is replayed from the journal stands in it."""
