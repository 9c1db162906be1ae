"""Rows of the corrected table picked out and put together."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.editing.core.change import no_rows
from tracking.tracks import CORRECTED_COLUMNS, Columns, TrackTable

Rows = dict[str, NDArray[Any]]
"""`CORRECTED_COLUMNS` of rows that may be written to."""


def select_rows(rows: Columns, chosen: NDArray[Any] | slice) -> Rows:
    """The chosen rows (a mask, numbers or a slice) as arrays of their own."""
    return {name: rows[name][chosen].copy() for name in CORRECTED_COLUMNS}


def rows_in(table: TrackTable, track: int, frames: NDArray[np.int32]) -> Rows:
    """The rows of a track in ascending frames; there are none for frames it does not stand in."""
    start, end = (int(frames[0]), int(frames[-1]) + 1) if len(frames) else (0, 0)
    rows = table.of_track(track, start, end)
    return select_rows(rows, np.isin(rows["frame"], frames, assume_unique=True))


def stack_rows(parts: Iterable[Columns]) -> Rows:
    """All the rows in the order a table has: by frame, then track."""
    given = [no_rows(), *parts]
    rows = {name: np.concatenate([part[name] for part in given]) for name in CORRECTED_COLUMNS}
    return select_rows(rows, np.lexsort((rows["track"], rows["frame"])))


def rows_differ(before: Columns, after: Columns) -> NDArray[np.bool_]:
    """(n,) which of the rows of the same places are not the same bit for bit."""
    different = np.zeros(len(before["frame"]), np.bool_)
    for name, dtype in CORRECTED_COLUMNS.items():
        bits = np.dtype(f"u{dtype.itemsize}")
        different |= before[name].view(bits) != after[name].view(bits)
    return different
