"""Linear interpolation of gaps: predicted rows between two places where somebody was seen."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import View
from tracking.trackers.linking.seen_rows import Floats
from tracking.trackers.stereo.boxes import visibility
from tracking.tracks.columns import SIDES, TRACK_COLUMNS, Columns, boxes_of, merged_rows, typed

Rows = NDArray[np.intp]

_SURE_S = 2.0
"""So long it is known about where somebody walks unseen."""


def fill_gaps(
    tracks: Columns, signals: Columns, view: View, fps: float, longest_s: float = _SURE_S
) -> tuple[Columns, Columns]:
    """The rows of people with an id, sorted, without short gaps; and their signals.

    In a gap people walk straight and their boxes change evenly, as a beginning for smoothing.
    Longer ones stay: somebody may have stood still or turned behind what hid them.

    Args:
        tracks: `TRACK_COLUMNS`; rows of track 0 are left out. signals: a row for each, or none.
        longest_s: how long a gap that is filled may be.
    """
    order = np.lexsort((tracks["frame"], tracks["track"]))
    order = order[tracks["track"][order] > 0]
    old = {name: column[order] for name, column in tracks.items()}
    added, before = _between(old, round(min(longest_s, _SURE_S) * fps))
    whole, sort = merged_rows(old, added)
    is_new = sort >= len(order)
    expect_visibility(whole, is_new, view)
    if len(signals["frame"]) != len(tracks["frame"]):
        return whole, signals
    row = np.append(order, order[before])[sort]
    noticed = {name: column[row] for name, column in signals.items()}
    for name in noticed.keys() - {"frame", "track"}:
        noticed[name][is_new] = np.nan
    return whole, {**noticed, "frame": whole["frame"], "track": whole["track"]}


def _between(tracks: Columns, longest: int) -> tuple[dict[str, NDArray[Any]], Rows]:
    """Rows for the frames that tracks, sorted by track and frame, leave out; the rows before.

    Args:
        longest: where more are missing, none is added.
    """
    before, nth, steps = missing_frames(tracks["frame"], tracks["track"], longest)
    share = nth / steps
    values = {name: tracks[name][before] for name in TRACK_COLUMNS}
    for name in ("x", "y", *SIDES, "vx", "vy"):
        values[name] = values[name] + share * (tracks[name][before + 1] - values[name])
    values["frame"] = values["frame"] + nth
    values["confidence"] = np.zeros(len(before))
    values["predicted"] = np.ones(len(before), bool)
    return typed(values, TRACK_COLUMNS), before


def missing_frames(
    frame: NDArray[np.int32], track: NDArray[np.int32], longest: int | None = None
) -> tuple[Rows, Rows, Rows]:
    """(k,) the frames that tracks leave out: the row before each, how far behind it, of how far.

    Args:
        frame, track: (n,) sorted by track and frame. longest: a gap of more frames is left;
            None: none is.
    """
    step = np.diff(frame.astype(np.int64))
    missing = np.where(np.diff(track) == 0, step - 1, 0)
    if longest is not None:
        missing[missing > longest] = 0
    before = np.repeat(np.arange(len(missing)), missing)
    nth = np.arange(len(before)) - np.repeat(np.cumsum(missing) - missing, missing) + 1
    return before, nth, missing[before] + 1


def expect_visibility(tracks: Columns, is_new: NDArray[np.bool_], view: View) -> None:
    """Put what others leave to be seen of the new rows in them."""
    box: Floats = boxes_of(tracks)
    range_m = np.hypot(tracks["x"], tracks["y"])
    for frame in np.unique(tracks["frame"][is_new]).tolist():
        rows = slice(*np.searchsorted(tracks["frame"], (frame, frame + 1)))
        shown = visibility(box[rows], range_m[rows], view.camera.size)
        tracks["visibility"][rows][is_new[rows]] = shown[is_new[rows]]
