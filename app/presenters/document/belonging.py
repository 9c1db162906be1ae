"""Whom a run's findings belong to after the edits."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.tracks import Columns

NOBODY_KNOWN = 0
"""Stands for the id where it cannot be told which of several people it is."""

_BOX = ("left", "top", "width", "height")
_EQUAL = 1e-6
_REACH = 0.5
"""In heights of the box: how far a person may have moved a row for it to be the same one."""


def ids_after_edits(made: Columns, corrected: Columns) -> dict[int, int]:
    """For each track of the run the corrected id of the same person in the same frame.

    An edit moves rows to another id without touching their boxes, so equal boxes are the same
    person; what was moved by hand is looked for nearby. Tracks whose row was taken out are left
    out; `NOBODY_KNOWN` stands where two rows may be meant.

    Args:
        made: the rows of one frame as the run made them. corrected: the frame's rows now.
    """
    distance = _distances(made, corrected)
    tracks, ids = made["track"].tolist(), corrected["track"].tolist()
    after: dict[int, int] = {}
    free = np.ones(len(ids), bool)
    for row, track in enumerate(tracks):
        same = np.flatnonzero(distance[row] <= _EQUAL)
        if len(same):
            after[track] = _one_of([ids[at] for at in same.tolist()], track)
            free[same] = False
    for row, track in enumerate(tracks):
        near = np.flatnonzero(free & (distance[row] <= _REACH))
        if track not in after and len(near):
            after[track] = _one_of([ids[at] for at in near.tolist()], track)
    return after


def renamed(tracks: NDArray[np.int32], after: dict[int, int]) -> NDArray[np.int32]:
    """Ids (n,) of a run as they are after the edits; those that `after` lacks become -1."""
    known, inverse = np.unique(tracks, return_inverse=True)
    ids = np.array([after.get(track, -1) for track in known.tolist()], np.int32)
    return np.asarray(ids[inverse], np.int32) if len(ids) else tracks


def _one_of(ids: list[int], own: int) -> int:
    """The only id; the one it had before where that is among several; else nobody's."""
    if len(ids) == 1:
        return ids[0]
    return own if own in ids else NOBODY_KNOWN


def _distances(made: Columns, corrected: Columns) -> NDArray[np.float64]:
    """(n, m) the largest difference of two boxes in any number, in shares of the run's height.

    Unknown boxes, of tracks that have none, count as equal.
    """
    before = np.column_stack([made[name] for name in _BOX]).astype(np.float64)
    now = np.column_stack([corrected[name] for name in _BOX]).astype(np.float64)
    size = np.maximum(np.nan_to_num(before[:, 3], nan=1.0), 1.0)
    apart = np.abs(before[:, None, :] - now[None, :, :])
    both_unknown = np.isnan(before)[:, None, :] & np.isnan(now)[None, :, :]
    apart[both_unknown] = 0.0
    largest = np.nan_to_num(apart, nan=np.inf).max(axis=2, initial=0.0)
    return np.asarray(largest / size[:, None], np.float64)
