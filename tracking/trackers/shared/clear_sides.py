"""Sides of people's boxes that show themselves and nobody else."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.tracks.columns import Columns, boxes_of

Floats = NDArray[np.float32]
Flags = NDArray[np.bool_]

_NEAR_PX = 1.0
_CHUNK_ROWS = 50_000


def clear_sides(tracks: Columns) -> Flags:
    """(n, 2) whether what is seen at the left and the right side of each row's box is their own.

    It is, arms and legs, where no other box lies, and where somebody farther stands who is told
    apart: a nearer one may hide it, and one who is only predicted may be seen as part of it.
    Takes time with the square of the people in a frame.

    Args:
        tracks: (n,) rows of a run, in any order.
    """
    order = np.argsort(tracks["frame"], kind="stable")
    clear = np.ones((len(order), 2), np.bool_)
    frame = tracks["frame"][order]
    start = 0
    while start < len(order):
        wanted = min(start + _CHUNK_ROWS, len(order))
        stop = int(np.searchsorted(frame, frame[wanted - 1], side="right"))
        rows = order[start:stop]
        box = boxes_of(tracks, rows)
        clear[rows] = _find_clear(box, tracks["predicted"][rows], frame[start:stop])
        start = stop
    return clear


def _find_clear(box: Floats, predicted: Flags, frame: NDArray[np.int32]) -> Flags:
    """The same of boxes (n, 4) px sorted by frame; feet lower in the picture are nearer."""
    clear = np.ones((len(frame), 2), np.bool_)
    edges = np.stack((box[:, 0], box[:, 0] + box[:, 2]))
    bottom = box[:, 1] + box[:, 3]
    apart = 1
    while (rows := np.flatnonzero(frame[apart:] == frame[:-apart])).size:
        for own, other in ((rows, rows + apart), (rows + apart, rows)):
            beside = (box[own, 1] < bottom[other]) & (bottom[own] > box[other, 1])
            low, high = edges[:, other]
            inside = (edges[:, own] > low - _NEAR_PX) & (edges[:, own] < high + _NEAR_PX) & beside
            harmless = ~predicted[other] & (bottom[other] < bottom[own])
            clear[own] &= (~inside | harmless).T
        apart += 1
    return clear
