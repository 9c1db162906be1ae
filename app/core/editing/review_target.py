"""The review item an edit is begun for, and the frame it is first looked at in."""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce

import numpy as np
from numpy.typing import NDArray

from tracking.review import ReviewItem
from tracking.tracks import TrackTable, between

_AROUND_S = 1.0
"""So near to the stretch of a review item an edit of its people is about it."""


def is_near(item: ReviewItem, frame: int, fps: float) -> bool:
    """Whether a frame lies in the stretch of a review item, or so near that it is about that."""
    around = round(_AROUND_S * fps)
    return item.start - around <= frame < item.end + around


def find_first_frame(item: ReviewItem, table: TrackTable) -> int:
    """The first frame of a review item's stretch in which its people are there to be seen.

    All of them, up to where it happened; else somebody, in the stretch or nearest to it. Of tracks
    of any length only the stretch is read: this is asked whenever the queue is drawn.
    """
    there = [table.frames_of_track(one) for one in item.tracks if one in table]
    if not there:
        return item.start
    here = [frames[between(frames, item.start, item.end)] for frames in there]
    together = reduce(np.intersect1d, here)
    if len(together) and together[0] <= item.frame:
        return int(together[0])
    first = [int(frames[0]) for frames in here if len(frames)]
    return min(first) if first else _nearest(there, item.frame)


def _nearest(there: Sequence[NDArray[np.int32]], frame: int) -> int:
    """The frame nearest to one in which any of them stands; the earlier of two."""
    found: list[int] = []
    for frames in there:
        at = int(np.searchsorted(frames, frame))
        found += frames[max(at - 1, 0) : at + 1].tolist()
    return min(found, key=lambda one: (abs(one - frame), one))
