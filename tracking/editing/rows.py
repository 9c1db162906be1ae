"""Planners of edits that add, change or delete rows. They only look; nothing changes here."""

from __future__ import annotations

import numpy as np

from tracking.editing.change import Change, State
from tracking.errors import EditError
from tracking.tracks import (
    CORRECTED_COLUMNS,
    LARGEST_NUMBER,
    Columns,
    Source,
    TrackTable,
    check_known,
    next_track,
)

Box = tuple[float, float, float, float]
"""left, top, width, height in 0-based pixels of the left image as recorded."""


def plan_delete(table: TrackTable, track: int, start: int = 0, end: int | None = None) -> Change:
    """Delete a track's rows in frames start to end; without a range: the whole track.

    Its label stays, so that a deletion undone or a track drawn anew finds it.
    Raises EditError where there is nothing to delete.
    """
    check_known(table, track)
    if end is not None and end <= start:
        raise EditError(f"frames {start} to {end}: the range is empty")
    rows = table.of_track(track, start, end)
    if not len(rows["frame"]):
        raise EditError(f"track {track} has no rows to delete in frames {start} to {end}")
    first, stop = table.frame_range(track)
    text = f"Delete {track}"
    if start <= first and (end is None or end >= stop):
        text = f"Delete track {track}"
    elif end is None or end >= stop:
        text += f" from frame {start} on"
    elif end == start + 1:
        text += f" in frame {start}"
    else:
        text += f" in frames {start} to {end - 1}"
    return Change("delete", text, int(rows["frame"][0]), State(rows=rows), State())


def plan_move_box(
    table: TrackTable,
    track: int,
    frame: int,
    box: Box,
    position: tuple[float, float] | None = None,
) -> Change:
    """Put a track's box of one frame elsewhere; the row then comes from a person.

    position: x, y in metres on the floor that belong to the box; None: unknown, NaN is written.
    Raises EditError where the track has no row in the frame or the box is none.
    """
    check_known(table, track)
    old = table.of_track(track, frame, frame + 1)
    if not len(old["frame"]):
        raise EditError(f"track {track} does not stand in frame {frame}; draw a box there instead")
    new = {name: column.copy() for name, column in old.items()}
    _place(new, box, position)
    text = f"Move the box of {track} in frame {frame}"
    return Change("move", text, frame, State(rows=old), State(rows=new))


def plan_draw_box(
    table: TrackTable,
    track: int | None,
    frame: int,
    box: Box,
    position: tuple[float, float] | None = None,
) -> Change:
    """Add a box a person drew, to a track or (None) as the first of a new one.

    Raises EditError where the track stands in the frame already, or the box is none.
    """
    if frame < 0:
        raise EditError(f"frame {frame} is negative; frames count from 0")
    new_track = track is None
    owner = next_track(table) if track is None else track
    if not 1 <= owner <= LARGEST_NUMBER or frame >= LARGEST_NUMBER:
        raise EditError(f"track {owner} in frame {frame}: ids and frames go up to {LARGEST_NUMBER}")
    if len(table.of_track(owner, frame, frame + 1)["frame"]):
        raise EditError(f"track {owner} stands in frame {frame} already; move its box instead")
    row = {name: np.zeros(1, dtype) for name, dtype in CORRECTED_COLUMNS.items()}
    row["frame"][0], row["track"][0] = frame, owner
    row["vx"][0] = row["vy"][0] = np.nan
    _place(row, box, position)
    text = f"Draw {'new track' if new_track else 'a box of'} {owner} in frame {frame}"
    return Change("draw", text, frame, State(), State(rows=row))


def _place(row: Columns, box: Box, position: tuple[float, float] | None) -> None:
    """Write a person's box and place into a single row."""
    if not (np.all(np.isfinite(box)) and box[2] > 0 and box[3] > 0):
        raise EditError(f"box {box} is none; left, top and a positive width and height are needed")
    for name, value in zip(("left", "top", "width", "height"), box, strict=True):
        row[name][0] = value
    row["x"][0], row["y"][0] = (np.nan, np.nan) if position is None else position
    row["confidence"][0] = row["visibility"][0] = 1.0
    row["predicted"][0] = False
    row["source"][0] = Source.PERSON
