"""Linear interpolation of body parts where a person's rows were filled in."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.linking.gap_rows import missing_frames
from tracking.trackers.linking.seen_rows import keys
from tracking.tracks import PART_EVIDENCE, PARTS
from tracking.tracks.columns import PART_COLUMNS, Columns, typed

_MOVING = ("cx", "cy", "width", "height", "vx", "vy")
_NOT_MEASURED = ("score", "entropy", *PART_EVIDENCE)


def fill_part_gaps(parts: Columns, tracks: Columns) -> Columns:
    """The parts, sorted, with those of people in frames in which only their tracks have a row.

    Parts move evenly from where they were to where they are next, as boxes do in gaps. They are
    occluded, and nothing is measured of them.

    Args:
        parts: `PART_COLUMNS`; may be none. tracks: `TRACK_COLUMNS` of the same ids.
    """
    each = (parts["track"] * PARTS + parts["part"]).astype(np.int32)
    order = np.lexsort((parts["frame"], each))
    before, nth, steps = missing_frames(parts["frame"][order], each[order])
    before, after = order[before], order[before + 1]
    frame = parts["frame"][before] + nth
    there = np.isin(keys(frame, parts["track"][before]), keys(tracks["frame"], tracks["track"]))
    if not there.any():
        return parts
    added = _between(parts, before[there], after[there], (nth / steps)[there])
    added["frame"] = frame[there]
    whole = {name: np.concatenate((column, added[name])) for name, column in parts.items()}
    sort = np.lexsort((whole["part"], whole["track"], whole["frame"]))
    return {name: column[sort] for name, column in whole.items()}


def _between(
    parts: Columns, before: NDArray[np.intp], after: NDArray[np.intp], share: NDArray[np.float64]
) -> dict[str, NDArray[Any]]:
    """Rows so far on the way from one row to another; their frames are left to the caller."""
    values = {name: parts[name][before] for name in PART_COLUMNS}
    for name in _MOVING:
        values[name] = values[name] + share * (parts[name][after] - values[name])
    for name in _NOT_MEASURED:
        values[name] = np.full(len(before), np.nan)
    values["failed"] = np.zeros(len(before), bool)
    values["occluded"] = np.ones(len(before), bool)
    values["particles"] = np.zeros(len(before), np.int32)
    return typed(values, PART_COLUMNS)
