"""Ranges of somebody's track as another person made them, in place of what stands there."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from tracking.editing.boxes.stretches import compare_windows
from tracking.editing.core.change import Change, State
from tracking.editing.core.scope import Scope, check_scope, scope_text, tracks_text
from tracking.editing.core.selection import select_rows, stack_rows
from tracking.errors import EditError
from tracking.tracks import Columns, TrackTable
from tracking.translation import msg


def plan_take_range(
    table: TrackTable, taken: Mapping[int, Columns], start: int, end: int, source: str
) -> Change:
    """Put other rows of some tracks in place of all they have in a range of frames.

    Args:
        taken: `CORRECTED_COLUMNS` by track, of frames in the range; the track in the rows does not
            count. No rows: the track stands nowhere in the range.
        start, end: half-open. source: what the rows are called, as the log tells it.

    Raises EditError for a range that is none, and where nothing would change.
    """
    check_scope(start, end)
    sides = [_compared(table, track, rows, start, end) for track, rows in sorted(taken.items())]
    before, after = (_by_frame([side[at] for side in sides]) for at in (0, 1))
    if not len(before["frame"]) and not len(after["frame"]):
        raise EditError(
            "nothing to take: {source} says the same {where}",
            source=source,
            where=scope_text(start, end),
        )
    text = msg(
        "Take {who} {where} from {source}",
        who=tracks_text(sorted(taken)),
        where=scope_text(start, end),
        source=" ".join(source.split()),
    )
    scope = Scope(start, end)
    return Change("take_theirs", text, start, State(rows=before), State(rows=after), scope)


def _compared(
    table: TrackTable, track: int, rows: Columns, start: int, end: int
) -> tuple[Columns, Columns]:
    inside = (rows["frame"] >= start) & (rows["frame"] < end)
    own = dict(select_rows(rows, inside))
    own["track"] = np.full_like(own["track"], track)
    return compare_windows(table.of_track(track, start, end), own)


def _by_frame(parts: list[Columns]) -> Columns:
    rows = stack_rows(parts)
    return select_rows(rows, np.lexsort((rows["track"], rows["frame"])))
