"""Which item of the review queue was looked at when an edit was made, and what was corrected."""

from __future__ import annotations

from collections.abc import Collection

from app.features.review.review_meter import is_correction
from tracking.editing import History
from tracking.review import ReviewItemKey


class EditedItems:
    """Remembers the item of each edit of this sitting, so that undo goes back to it.

    Attributes:
        corrected: the items at which tracks of theirs were corrected, by edits in force.
    """

    def __init__(self) -> None:
        self._item_of: dict[int, ReviewItemKey | None] = {}
        self._last = 0
        self.corrected: frozenset[ReviewItemKey] = frozenset()

    def begin(self, history: History) -> None:
        """Another session: its earlier edits have no item."""
        self._item_of, self._last = {}, _last_in_force(history)
        self.corrected = frozenset()

    def follow(
        self, history: History, current: ReviewItemKey | None, tracks: Collection[int]
    ) -> ReviewItemKey | None:
        """Call after each edit, undo and redo; the item of the edit that was undone, if any.

        None also where several edits were undone at once, and where the edit had nothing to do
        with the item's people.

        Args:
            current: the item that is looked at.
            tracks: whom the edit touched, which was made last.
        """
        last, self._last = self._last, _last_in_force(history)
        if self._last > last and self._last not in self._item_of:
            related = current is not None and (not tracks or set(tracks) & set(current[1]))
            self._item_of[self._last] = current if related else None
        if self._last != last:
            self.corrected = self._corrected(history)
        redo = history.next_redo
        undone = self._last < last and redo is not None and redo.id == last
        return self._item_of.get(last) if undone else None

    def _corrected(self, history: History) -> frozenset[ReviewItemKey]:
        found = (
            self._item_of.get(entry.id) for entry in history.in_force if is_correction(entry.kind)
        )
        return frozenset(key for key in found if key is not None)


def _last_in_force(history: History) -> int:
    return history.next_undo.id if history.next_undo is not None else 0
