"""Taking what a run found, in place of what the corrected tracks say, where nobody touched them."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Flags
from tracking.editing.core.change import Change, State, Stretches
from tracking.editing.core.scope import Scope, scope_text, tracks_text
from tracking.editing.core.selection import Rows, rows_differ, select_rows
from tracking.editing.log.history import History
from tracking.editing.tracking_again.alignment import Alignment, align, exchangeable
from tracking.editing.tracking_again.counterparts import same_keys
from tracking.editing.tracking_again.differences import Difference
from tracking.editing.tracking_again.protection import (
    Protection,
    find_protected,
    join_stretches,
)
from tracking.errors import EditError
from tracking.tracks import Columns, Labels, Run, TrackTable
from tracking.translation import Message, msg


def plan_take(
    table: TrackTable,
    labels: Labels,
    history: History,
    run: Run,
    frames: tuple[int, int] | None,
    tracks: Collection[int] | None = None,
    *,
    only: Sequence[Difference] | None = None,
    fps: float | None = None,
) -> Change:
    """Take a run's rows in a range of frames in place of the corrected tracks' there.

    What is protected (`find_protected`) stays to the bit. A person of the run is left out in
    the frames in which they stand on a row that stays under another id, and a row stays where the
    run's row of that person cannot be taken: nobody is there twice, and nobody is lost. Two
    tracks that change over are therefore taken together or not at all. Ids, names and labels
    stay; people nobody knew get ids above the highest.

    Args:
        frames: half-open; None: all the run was run over.
        tracks: take these tracks only, by their ids in the corrected table; None: all.
        only: take these differences only, as `differences` told them of the same run and frames.
        fps: frames a second, of protected margins.

    Raises EditError where there is nothing to take, because the run says the same, or all it says
    is protected, or none of it is of the tracks asked for.
    """
    protection = find_protected(table, labels, history, fps=fps)
    found = align(table, run, frames, protection)
    chosen = _chosen(tracks, only)
    taken = exchangeable(found, _is_in(found.corrected, chosen), _is_in(found.found, chosen))
    before = select_rows(found.corrected, taken.leaves)
    before, after = _without_same(before, select_rows(found.found, taken.enters))
    where = _where(found, table)
    if not len(before["frame"]) and not len(after["frame"]):
        raise EditError("nothing to take {where}: {why}", where=where, why=_why(found))
    text = _text(run, np.union1d(before["track"], after["track"]).tolist(), where)
    first = min(int(rows["frame"][0]) for rows in (before, after) if len(rows["frame"]))
    return Change("take", text, first, State(rows=before), State(rows=after), Scope(*found.frames))


def _chosen(
    tracks: Collection[int] | None, only: Sequence[Difference] | None
) -> tuple[NDArray[np.int64] | None, Stretches | None]:
    """The tracks and the stretches asked for; None: all."""
    ids = None if tracks is None else np.array(sorted(tracks), np.int64)
    if only is None:
        return ids, None
    parts = [(track, one.start, one.end) for one in only for track in one.tracks]
    return ids, join_stretches(np.array(parts, np.int64).reshape(-1, 3))


def _is_in(rows: Columns, chosen: tuple[NDArray[np.int64] | None, Stretches | None]) -> Flags:
    """(n,) whether each row is asked for."""
    ids, stretches = chosen
    asked = np.ones(len(rows["frame"]), bool)
    if ids is not None:
        asked &= np.isin(rows["track"], ids)
    if stretches is not None:
        asked &= Protection(stretches).covers(rows["track"], rows["frame"])
    return asked


def _without_same(before: Rows, after: Rows) -> tuple[Rows, Rows]:
    """Both sides without the rows that are the same to the bit on the other one."""
    place = same_keys(after, before)
    both = np.flatnonzero(place >= 0)
    both = both[~rows_differ(select_rows(before, place[both]), select_rows(after, both))]
    goes, comes = np.ones(len(before["frame"]), bool), np.ones(len(after["frame"]), bool)
    goes[place[both]], comes[both] = False, False
    return select_rows(before, goes), select_rows(after, comes)


def _where(found: Alignment, table: TrackTable) -> str:
    start, end = found.frames
    return scope_text(start, None if end >= table.frame_stop else end)


def _text(run: Run, tracks: Sequence[int], where: str) -> Message:
    """What is done, as the log keeps it."""
    again = msg("as tracked again by") if run.known_tracks else msg("from the run of")
    return msg(
        "Take {who} {where}, {again} {tracker}",
        who=tracks_text(tracks),
        where=where,
        again=again,
        tracker=run.tracker,
    )


def _why(found: Alignment) -> str:
    """Why there is nothing to take."""
    if found.guarded.any() or found.barred.any():
        return msg("what the run says otherwise is protected, or not of the tracks asked for")
    return msg("the run says the same there, or nothing of the tracks asked for")
