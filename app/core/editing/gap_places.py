"""The gaps that an edit fills, gone through with the playhead."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.editing import Change, gaps_of
from tracking.tracks import Columns, TrackTable


def gap_near(table: TrackTable, track: int, frame: int) -> int | None:
    """A frame of the gap that a frame lies in, else of the next gap, else of the last one.

    None where the track has no gap.
    """
    gaps = gaps_of(table, track)
    if not gaps:
        return None
    return next(
        (max(start, min(frame, end - 1)) for start, end in gaps if frame < end), gaps[-1][0]
    )


def next_filled(change: Change, frame: int, step: int) -> int:
    """Where the next filled gap begins (step 1), or the one before (-1), around and around.

    Step 0: the gap the frame lies in, else the nearest one.
    """
    starts = _starts(change.after.rows)
    if not len(starts):
        return frame
    if step == 0:
        frames = change.after.rows["frame"]
        return int(frames[np.argmin(np.abs(frames - frame))])
    if step > 0:
        return int(starts[np.searchsorted(starts, frame, side="right") % len(starts)])
    return int(starts[np.searchsorted(starts, frame) - 1])


def _starts(rows: Columns) -> NDArray[np.int32]:
    """(n,) the first frame of each stretch of a track's rows, ascending, each once."""
    order = np.lexsort((rows["frame"], rows["track"]))
    frames, tracks = rows["frame"][order], rows["track"][order]
    first = np.ones(len(frames), bool)
    first[1:] = (np.diff(frames) != 1) | (np.diff(tracks) != 0)
    return np.unique(frames[first])
