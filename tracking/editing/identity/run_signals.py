"""What a run noticed of people, under the ids they have in the corrected table."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from tracking.tracks import SIGNAL_COLUMNS, Columns, Run, TrackTable, empty

_TOLD_BY = ("left", "top", "width", "height")


def signals_of(
    table: TrackTable, run: Run, tracks: Iterable[int], start: int = 0, end: int | None = None
) -> Columns:
    """`SIGNAL_COLUMNS` of some tracks' rows in a half-open range of frames, track after track.

    A row that came from the run is found there by frame and box, whatever id it bears by now;
    rows that a person moved and those of another run have none.
    """
    parts: list[Columns] = [empty(SIGNAL_COLUMNS)]
    if len(run.signals["frame"]):
        parts += [_noticed(run, table.of_track(track, start, end), track) for track in tracks]
    return {name: np.concatenate([part[name] for part in parts]) for name in SIGNAL_COLUMNS}


def _noticed(run: Run, rows: Columns, track: int) -> Columns:
    found = _places_in_run(rows, run.tracks)
    signals = {name: run.signals[name][found[found >= 0]] for name in SIGNAL_COLUMNS}
    return {**signals, "track": np.full(len(signals["frame"]), track, np.int32)}


def _places_in_run(rows: Columns, tracks: Columns) -> NDArray[np.int64]:
    """(n,) which of a run's rows each row is; -1: none."""
    first = np.searchsorted(tracks["frame"], rows["frame"])
    stop = np.searchsorted(tracks["frame"], rows["frame"], side="right")
    found = np.full(len(first), -1)
    for step in range(int((stop - first).max(initial=0))):
        place = np.minimum(first + step, len(tracks["frame"]) - 1)
        same = first + step < stop
        for name in _TOLD_BY:
            same &= tracks[name][place] == rows[name]
        found[same] = place[same]
    return found
