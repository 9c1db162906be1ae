"""A run laid over the corrected table: both sides' rows in a range, under the same ids."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Flags
from tracking.editing.core.scope import check_scope
from tracking.editing.core.selection import Rows, select_rows, stack_rows
from tracking.editing.tracking_again.counterparts import Places, counterparts, mates, same_keys
from tracking.editing.tracking_again.protection import Protection
from tracking.editing.tracking_again.run_identities import map_identities
from tracking.errors import EditError
from tracking.tracks import CORRECTED_COLUMNS, Columns, Run, Source, TrackTable, between

Indices = NDArray[np.int64]

_BEFORE = 25
"""Frames before the range in which a run of its own shows who its people are."""


@dataclass(frozen=True, slots=True, eq=False)
class Alignment:
    """What the table says and what a run would say instead.

    Attributes:
        frames: half-open range that both are about.
        corrected: `CORRECTED_COLUMNS` of the table there.
        found: `CORRECTED_COLUMNS` of the run there, with corrected ids.
        own: (found,) the corrected row of the same id and frame; -1: none.
        mate: (found,) the corrected row of the same person, that is at the same place; -1: none.
        same: (found,) whether that one has the same id, and is where it was.
        guarded: (corrected,) protected. barred: (found,) protected against it: the track's
            absence, or nobody's presence where people deleted somebody.
    """

    frames: tuple[int, int]
    corrected: Columns
    found: Columns
    own: Indices
    mate: Indices
    same: Flags
    guarded: Flags
    barred: Flags


def align(
    table: TrackTable, run: Run, frames: tuple[int, int] | None, protection: Protection
) -> Alignment:
    """The run laid over the table in a range of frames; None: all it was run over.

    Raises EditError where the run was not run over any of these frames.
    """
    start, end = _range(run, frames)
    early = start if run.known_tracks else max(start - _BEFORE, run.frames[0], 0)
    corrected, found = rows_of_table(table, early, end), rows_of_run(run, early, end)
    names = map_identities(
        corrected, found, (start, end), run.known_tracks, table.highest_track, protection
    )
    found["track"] = names.track
    inside = corrected["frame"] >= start, found["frame"] >= start
    corrected, found = (
        select_rows(corrected, inside[0]),
        stack_rows([select_rows(found, inside[1])]),
    )
    own = same_keys(found, corrected)
    mate, same = mates(found, corrected, own)
    guarded = protection.covers(corrected["track"], corrected["frame"])
    barred = protection.covers(found["track"], found["frame"])
    barred |= np.isin(found["track"], names.fresh) & _on_deleted(found, protection)
    return Alignment((start, end), corrected, found, own, mate, same, guarded, barred)


@dataclass(frozen=True, slots=True, eq=False)
class Exchange:
    """Which rows a take exchanges.

    Attributes:
        leaves: (corrected,) rows that go. enters: (found,) rows that come.
    """

    leaves: Flags
    enters: Flags


def exchangeable(
    found: Alignment, leaves: Flags | None = None, enters: Flags | None = None
) -> Exchange:
    """What may be exchanged of the rows asked for: all where nothing is said.

    Nothing protected changes; no track has two rows in a frame and no person two tracks. Where a
    row of the run cannot come, the corrected row of the same person does not go either: taking a
    part of what a run says leaves nobody without a track.
    """
    leaves = ~found.guarded if leaves is None else leaves & ~found.guarded
    asked = ~found.barred if enters is None else enters & ~found.barred
    while True:
        stays = np.append(~leaves, False)  # one more, which those without a row (-1) look up
        enters = asked & ~stays[found.own] & ~stays[found.mate]
        left = found.mate[~enters & (found.mate >= 0)]
        if not leaves[left].any():
            return Exchange(leaves, enters)
        leaves = leaves.copy()
        leaves[left] = False


def rows_of_table(table: TrackTable, start: int, end: int) -> Rows:
    """All tracks' rows in a range of frames, sorted by frame then track."""
    parts = [table.of_track(track, start, end) for track in table.track_ids]
    return stack_rows(parts)


def rows_of_run(run: Run, start: int, end: int) -> Rows:
    """A run's rows in a range of frames, as rows of a corrected table."""
    inside = between(run.tracks["frame"], start, end)
    rows = {n: column[inside].copy() for n, column in run.tracks.items() if n in CORRECTED_COLUMNS}
    rows["source"] = np.full(len(rows["frame"]), Source.TRACKER, np.uint8)
    return rows


def _range(run: Run, frames: tuple[int, int] | None) -> tuple[int, int]:
    start, end = frames or run.frames
    check_scope(start, end)
    first, stop = max(start, run.frames[0]), min(end, run.frames[1])
    if first >= stop:
        raise EditError(
            "frames {start} to {end} are not in the run, which is over frames {first} to "
            "{last}; choose a range within",
            start=start,
            end=end - 1,
            first=run.frames[0],
            last=run.frames[1] - 1,
        )
    return first, stop


def _on_deleted(found: Columns, protection: Protection) -> Flags:
    """(found,) whether somebody stood there whom people deleted."""
    return counterparts(Places.of(found), Places.of(protection.deleted)) >= 0
