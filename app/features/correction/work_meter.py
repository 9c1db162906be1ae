"""How fast somebody annotates: boxes and edits an hour, of the time they were at it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

import numpy as np

from app.core.document.document_listener import DocumentListener, Marks
from app.core.i18n import count_text, tr
from app.core.tracks.track_reader import WholeTracks
from tracking.editing import Change, History
from tracking.tracks import Columns, ReviewedRange, Source

PAUSE_S: Final = 60.0
"""A longer time without an edit is a break, and counts as so much work."""
_LEAST_S: Final = 30.0
"""No speed is stated for less time than this."""
_MADE_ELSEWHERE = ("import", "take_theirs")
"""Kinds of edits that bring boxes of others."""


class WorkMeter(DocumentListener):
    """Follows the edits of a document since it was opened, all but imports.

    Attributes:
        boxes: labelled by now: those put by hand and those interpolated, less what was undone.
        worked_s: how long that took, in seconds; undoing and doing again is work, too.
    """

    def __init__(self, seconds: Callable[[], float]) -> None:
        """`seconds` is a clock that never goes back."""
        self.boxes = 0
        self.worked_s = 0.0
        self._seconds, self._last_s = seconds, seconds()
        self._history: History | None = None
        self._was_none = False  # there was no session yet: all its edits are of this sitting
        self._position: tuple[int, int, int] | None = None
        self._before: frozenset[int] = frozenset()
        self._edits = 0

    def take_change(
        self,
        change: Change,
        tracks: WholeTracks,  # noqa: ARG002 - as all listeners are told
        marks: Marks,  # noqa: ARG002
        reviewed: tuple[ReviewedRange, ...],  # noqa: ARG002
    ) -> None:
        """Count an edit."""
        now = self._seconds()
        if change.kind in _MADE_ELSEWHERE:  # made elsewhere, in a time nobody measured
            self._last_s = now
            return
        self.worked_s += min(now - self._last_s, PAUSE_S)
        self._last_s = now
        self.boxes += _labelled(change.after.rows) - _labelled(change.before.rows)

    def edits(self, history: History | None) -> int:
        """How many edits are in force that were not yet where this history was shown first."""
        if history is None:
            self._was_none = True
            return 0
        if history is not self._history:
            begun_here = self._was_none and self._history is None
            self._history, self._position = history, None
            self._before = frozenset() if begun_here else _in_force(history)
        if (position := history.position) != self._position:
            self._position, self._edits = position, len(_in_force(history) - self._before)
        return self._edits

    def text(self, history: History | None) -> str:
        """In a line; "" before anything was done."""
        edits = self.edits(history)
        if not edits:
            return ""
        boxes = max(0, self.boxes)
        words = [count_text(boxes, "{n} box", "{n} boxes")] if boxes else []
        words.append(count_text(edits, "{n} edit", "{n} edits"))
        if self.worked_s >= _LEAST_S:
            words.append(self._pace(boxes, edits, self.worked_s / 3600))
        return "  \u00b7  ".join(words)

    def _pace(self, boxes: int, count: int, hours: float) -> str:
        edits = round(count / hours)
        if not boxes:
            return tr("{edits} edits an hour", edits=edits)
        return tr(
            "{boxes} boxes and {edits} edits an hour", boxes=round(boxes / hours), edits=edits
        )


def _in_force(history: History) -> frozenset[int]:
    entries = history.in_force
    return frozenset(entry.id for entry in entries if entry.kind not in _MADE_ELSEWHERE)


def _labelled(rows: Columns) -> int:
    """How many rows a person stands for, drawn or interpolated."""
    return int(np.count_nonzero(rows["source"] != Source.TRACKER))
