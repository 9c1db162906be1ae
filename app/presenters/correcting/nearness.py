"""Who stands near somebody."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.tracks import Columns, TrackTable


def nearest_first(table: TrackTable, track: int, frame: int) -> tuple[int, ...]:
    """Everybody else in the frame, who stands nearest to the track there (or last) first."""
    rows = table.of_frame(frame)
    own = nearest_row(table, track, frame)
    others = rows["track"] != track
    ids = rows["track"][others]
    if own is None or not len(ids):
        return tuple(ids.tolist())
    here, there = _places(own), _places(rows)[others]
    metres = np.linalg.norm(there[:, :2] - here[0, :2], axis=1)
    pixels = np.linalg.norm(there[:, 2:] - here[0, 2:], axis=1)
    apart = metres if np.isfinite(metres).all() else pixels
    return tuple(ids[np.argsort(apart, kind="stable")].tolist())


def metres_apart(table: TrackTable, track: int, other: int, frame: int) -> float:
    """How far apart two stand on the floor in a frame, or nearest to it; NaN where not known."""
    rows = [nearest_row(table, one, frame) for one in (track, other)]
    if rows[0] is None or rows[1] is None:
        return float("nan")
    here, there = _places(rows[0]), _places(rows[1])
    return float(np.linalg.norm(there[0, :2] - here[0, :2]))


def nearest_row(table: TrackTable, track: int, frame: int) -> Columns | None:
    """The track's row whose frame is nearest; None where it has none."""
    if track not in table:
        return None
    frames = table.frames_of_track(track)
    after = int(np.searchsorted(frames, frame))
    beside = frames[max(0, after - 1) : after + 1]
    nearest = int(beside[np.argmin(np.abs(beside - frame))])
    return table.of_track(track, nearest, nearest + 1)


def _places(rows: Columns) -> NDArray[np.float64]:
    """(n, 4) x, y in metres and the boxes' centres in px."""
    centre = rows["left"] + rows["width"] / 2, rows["top"] + rows["height"] / 2
    return np.column_stack((rows["x"], rows["y"], *centre)).astype(np.float64)
