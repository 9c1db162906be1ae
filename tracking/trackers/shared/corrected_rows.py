"""Rows of corrected people, as trackers read them to go on: sorted by frame, then track."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import View
from tracking.tracks.columns import Columns, boxes_of, places_of

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
Ids = NDArray[np.int32]
Rows = NDArray[np.intp]

LED_ON_S = 1.0
"""Who has no row in the last frames is thought to have walked on for so long."""
_SLOPE_S = 0.5
"""How much of the last rows tells how fast somebody walks."""
_CLOSE_M = 0.8
"""Of two people closer than this neither is seen by itself."""


def only(rows: Columns, chosen: NDArray[np.bool_] | NDArray[np.intp]) -> Columns:
    """Some of the rows: marked, or by number."""
    return {name: column[chosen] for name, column in rows.items()}


def is_seen(rows: Columns) -> Flags:
    """Whether each row was measured with something of the person in sight."""
    return np.asarray(~rows["predicted"] & ~(rows["visibility"] <= 0.0))


def is_apart(rows: Columns) -> Flags:
    """Whether each row's person stands by himself on the floor, as far as that is known.

    The rows are sorted by frame. Floor positions that are missing are near to nobody.
    """
    close = np.zeros(len(rows["frame"]), bool)
    for step in range(1, len(close)):
        same = rows["frame"][step:] == rows["frame"][:-step]
        if not same.any():
            break
        apart = [rows[name][step:] - rows[name][:-step] for name in ("x", "y")]
        near = same & (np.hypot(*apart) < _CLOSE_M)
        close[step:] |= near
        close[:-step] |= near
    return ~close


def place_on_floor(rows: Columns, view: View) -> Columns:
    """The rows with a place on the floor: of those drawn without one, below the box."""
    box, own = boxes_of(rows), places_of(rows)
    foot = np.column_stack((box[:, 0] + box[:, 2] / 2, box[:, 1] + box[:, 3]))
    below = view.floor_from_pixel(foot)
    place = np.where(np.isfinite(own).all(axis=1)[:, None], own, below)
    placed = {**rows, "x": place[:, 0], "y": place[:, 1]}
    return only(placed, np.asarray(np.isfinite(place).all(axis=1)))


def last_rows(rows: Columns, people: Ids, eligible: Flags | None = None) -> Rows:
    """(people,) the last eligible row of each; -1 where there is none.

    Args:
        people: ids, ascending. eligible: (rows,); None: all.
    """
    chosen = np.arange(len(rows["track"])) if eligible is None else np.flatnonzero(eligible)
    last = np.full(len(people), -1)
    last[np.searchsorted(people, rows["track"][chosen])] = chosen
    return last


def slopes(rows: Columns, place: Floats, people: Ids, frame: int, fps: float) -> Floats:
    """(people, k) a second, of straight lines through the last places; 0 for a single one.

    Args:
        place: (rows, k) m or px. people: ids, ascending. frame: the first one to go on at.
    """
    late = rows["frame"] >= frame - round(_SLOPE_S * fps)
    number = np.searchsorted(people, rows["track"][late])
    count = np.maximum(np.bincount(number, minlength=len(people)), 1)
    time = rows["frame"][late] / fps
    time = time - (np.bincount(number, time, len(people)) / count)[number]
    length = np.maximum(np.bincount(number, time**2, len(people)), 1e-9)
    along = [np.bincount(number, time * axis, len(people)) / length for axis in place[late].T]
    return np.column_stack(along)
