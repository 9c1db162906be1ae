"""Boxes between keyframes, as CVAT has them: straight and even in time from one to the next."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.formats.filled_rows import held_until
from tracking.tracks import Columns, Source

SIDES = ("left", "top", "right", "bottom")
CLOSE_PX = 0.005
"""CVAT writes hundredths of a pixel: a box this close to the straight way lies on it."""

Boxes = NDArray[np.float64]
Mask = NDArray[np.bool_]


def keyframes_of(frame: NDArray[Any], boxes: Boxes, source: NDArray[Any], occluded: Mask) -> Mask:
    """Which of a track's rows must be keyframes, so that CVAT shows all of them as they are.

    All that a tracker or a person placed, the first and the last of an unbroken stretch, those from
    which on a person is occluded or is no longer, and where an interpolated box is off the straight
    way between its neighbours, all of that gap.

    Args:
        frame: (n,) ascending. boxes: (n, 4). source: (n,) see `Source`. occluded: (n,).
    """
    if not len(frame):
        return np.zeros(0, bool)
    breaks = np.diff(frame) > 1
    first = np.concatenate([[True], breaks])
    last = np.concatenate([breaks, [True]])
    changed = np.concatenate([[False], np.diff(occluded)])
    key: Mask = (source != Source.INTERPOLATED) | first | last | changed
    at = np.flatnonzero(key)
    off = np.abs(between(frame, frame[at], boxes[at]) - boxes).max(axis=1) > CLOSE_PX
    gap = np.searchsorted(at, np.arange(len(frame)), side="right")
    return key | np.isin(gap, gap[off & ~key])


def between(frame: NDArray[Any], key_frames: NDArray[Any], key_boxes: Boxes) -> Boxes:
    """(n, 4) boxes at frames on the straight way between keyframes."""
    return np.column_stack([np.interp(frame, key_frames, side) for side in key_boxes.T])


def filled(
    rows: Columns, outside: Mask, step: int, last_frame: int, frames: int | None = None
) -> dict[str, NDArray[Any]]:
    """The rows CVAT shows of a track that is told by keyframes alone.

    From each keyframe in view to the next, and from the last one to the end of the task.

    Args:
        rows: (n,) `frame` ascending, `left, top, right, bottom`, `occluded`.
        outside: (n,) keyframes from which on the track is out of view.
        step: frames between two of the task. last_frame: of the task. frames: of the recording,
            beyond which nothing is filled; None: unknown.

    Returns: (m,) the same columns of all frames in view, and `key`: those that are keyframes.
    """
    frame = rows["frame"]
    starts, stops = frame[~outside], held_until(frame, last_frame + 1, frames)[~outside]
    shown = np.concatenate(
        [
            np.arange(start, stop, step)
            for start, stop in zip(starts.tolist(), stops.tolist(), strict=True)
        ]
        or [np.zeros(0, np.int64)]
    )
    before = np.searchsorted(frame, shown, side="right") - 1
    boxes = between(shown, frame, np.column_stack([rows[side] for side in SIDES]))
    return {
        "frame": shown,
        **dict(zip(SIDES, boxes.T, strict=True)),
        "occluded": rows["occluded"][before],
        "key": shown == frame[before],
    }


def rows_filled(
    frame: NDArray[Any], outside: Mask, step: int, last_frame: int, frames: int | None
) -> int:
    """How many rows `filled` makes beside the keyframes themselves."""
    held = held_until(frame, last_frame + 1, frames) - frame
    return int((-(-held // step) - 1)[~outside].sum())
