"""Who stands near somebody."""

from __future__ import annotations

from heapq import nsmallest

import numpy as np
from numpy.typing import NDArray

from tracking.tracks import Columns, TrackTable

_WALK_M_PER_S = 1.3
"""How fast people usually walk."""
_MOST_WEIGHED = 50
"""Of so many who come soonest before or after, places are compared: a click waits for it."""
_PERSON_M = 1.7
"""How tall people usually are: where no floor is known, boxes tell how far they are apart."""


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


def followers_first(table: TrackTable, track: int, fps: float) -> tuple[int, ...]:
    """Those who end before a track begins, or begin after it ends; the nearest first.

    Near is who is soon reached: the seconds between the two tracks, and those it takes to walk
    from the place where one ends to the place where the other begins.
    """
    if track not in table:
        return ()
    start, stop = table.frame_range(track)
    missing: dict[int, int] = {}
    for one in table.track_ids:
        first, end = table.frame_range(one)
        if one != track and (end <= start or first >= stop):
            missing[one] = start - end if end <= start else first - stop
    near = {}
    for one in nsmallest(_MOST_WEIGHED, missing, key=missing.__getitem__):
        at = start if table.frame_range(one)[1] <= start else stop - 1
        rows = nearest_row(table, track, at), nearest_row(table, one, at)
        near[one] = missing[one] / fps + _walk_s(*rows)
    return tuple(sorted(near, key=near.__getitem__))


def _walk_s(one: Columns | None, other: Columns | None) -> float:
    """Seconds to walk from one row's place to another's; 0 where no place is known."""
    if one is None or other is None:
        return 0.0
    apart = (_places(other) - _places(one))[0]
    metres = float(np.hypot(*apart[:2]))
    if not np.isfinite(metres):
        heights = max(float(one["height"][0]), float(other["height"][0]), 1.0)
        metres = float(np.hypot(*apart[2:])) / heights * _PERSON_M
    return metres / _WALK_M_PER_S if np.isfinite(metres) else 0.0


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
