"""An edit as a value: what was, what will be, and one function that makes it so."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from tracking.editing.core.label_state import LabelState as LabelState
from tracking.editing.core.label_state import apply_label_state
from tracking.editing.core.scope import Scope
from tracking.errors import EditError
from tracking.tracks import CORRECTED_COLUMNS, Columns, Labels, TrackTable, empty
from tracking.translation import Message

Stretches = NDArray[np.int64]
_NO_ROWS: Columns = MappingProxyType(empty(CORRECTED_COLUMNS))


def no_rows() -> Columns:
    """No rows of the corrected table; of the many changes that touch none, all share them."""
    return _NO_ROWS


def no_stretches() -> Stretches:
    """No stretches."""
    return np.zeros((0, 3), np.int64)


@dataclass(frozen=True, slots=True, eq=False)
class State:
    """What a change touches, on one side of it: before or after.

    Attributes:
        stretches: (k, 3) track, start, end: the rows in that half-open range of frames belong to
            that track. Row i of one side and row i of the other have the same range.
        rows: `CORRECTED_COLUMNS` of the rows that stand only on this side.
        labels: the labels on this side.
    """

    stretches: Stretches = field(default_factory=no_stretches)
    rows: Columns = field(default_factory=no_rows)
    labels: LabelState = field(default_factory=LabelState)


@dataclass(frozen=True, slots=True, eq=False)
class Change:
    """One reversible edit.

    Attributes:
        kind: one word, e.g. "swap".
        text: what is done, e.g. "Swap 4 and 7 from frame 834 on"; translated where it is shown.
        frame: where to look at it.
        before, after: the two sides.
        scope: the frames it was made for; None: it is about no stretch of frames.
    """

    kind: str
    text: Message
    frame: int
    before: State
    after: State
    scope: Scope | None = None

    @property
    def inverse(self) -> Change:
        """The change that undoes this one exactly."""
        return replace(self, before=self.after, after=self.before)

    @property
    def tracks(self) -> tuple[int, ...]:
        """The tracks it touches, ascending."""
        touched: set[int] = set()
        for side in (self.before, self.after):
            touched.update(side.stretches[:, 0].tolist(), np.unique(side.rows["track"]).tolist())
            touched.update(side.labels.tracks)
            touched.update(label.track for label in side.labels.parts)
            touched.update(seen.track for seen in side.labels.reviewed if seen.track)
        return tuple(sorted(touched))


def apply_change(table: TrackTable, labels: Labels, change: Change) -> Labels:
    """Change the table in place and return the new labels: all of it or nothing.

    The only way tables and labels change. Raises EditError where the table or the labels are not
    as they were when the change was planned.
    """
    changed = apply_label_state(labels, change.before.labels, change.after.labels)
    moves = _moves(change)
    rows_out, rows_in = change.before.rows, change.after.rows
    if len(moves) or len(rows_out["frame"]) or len(rows_in["frame"]):
        table.rewrite(rows_out, moves, rows_in)
    return changed


def _moves(change: Change) -> Stretches:
    before, after = change.before.stretches, change.after.stretches
    if before.shape != after.shape or not np.array_equal(before[:, 1:], after[:, 1:]):
        raise EditError("{text}: the two sides name different ranges of frames", text=change.text)
    return np.column_stack([before[:, 0], after[:, 0], before[:, 1:]])
