"""Planner of what can be seen of people."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from tracking.editing.core.change import Change, State
from tracking.editing.core.scope import Scope, check_scope, check_tracks, scope_text, tracks_text
from tracking.editing.core.selection import select_rows, stack_rows
from tracking.errors import EditError
from tracking.tracks import TrackTable


def plan_mark_occluded(
    table: TrackTable,
    tracks: Iterable[int],
    start: int = 0,
    end: int | None = None,
    occluded: bool = True,
) -> Change:
    """Say that people are hidden (visibility 0) or in full view (1) in frames start to end.

    end None: from there on. Their boxes and where these come from stay as they are.
    Raises EditError where none of them stands in the range, or it is said already.
    """
    chosen = check_tracks(table, tracks)
    check_scope(start, end)
    rows = stack_rows(table.of_track(track, start, end) for track in chosen)
    who, where = tracks_text(chosen), scope_text(start, end)
    if not len(rows["frame"]):
        raise EditError(f"{who}: no rows to mark {where}; choose another range")
    wanted = np.float32(0.0 if occluded else 1.0)
    old = select_rows(rows, rows["visibility"] != wanted)
    state = "occluded" if occluded else "visible"
    if not len(old["frame"]):
        raise EditError(f"{who}: marked as {state} {where} already")
    new = select_rows(old, slice(None))
    new["visibility"][:] = wanted
    text = f"Mark {who} as {state} {where}"
    frame, scope = int(old["frame"][0]), Scope(start, end)
    return Change("occluded", text, frame, State(rows=old), State(rows=new), scope)
