"""The suspicion an edit is begun for, and the frame it is first looked at in."""

from __future__ import annotations

from functools import reduce

import numpy as np

from tracking.review import Suspicion
from tracking.tracks import TrackTable

_AROUND_S = 1.0
"""So near to the stretch of a suspicion an edit of its people is about it."""


def is_near(suspicion: Suspicion, frame: int, fps: float) -> bool:
    """Whether a frame lies in the stretch of a suspicion, or so near that it is about that."""
    around = round(_AROUND_S * fps)
    return suspicion.start - around <= frame < suspicion.end + around


def first_shown(suspicion: Suspicion, table: TrackTable) -> int:
    """The first frame of a suspicion's stretch in which its people are there to be seen.

    All of them, up to where it happened; else somebody, in the stretch or nearest to it.
    """
    there = [table.frames_of_track(one) for one in suspicion.tracks if one in table]
    if not there:
        return suspicion.start
    together = reduce(np.intersect1d, there)
    for frames, stop in (
        (together, suspicion.frame + 1),
        (np.unique(np.concatenate(there)), suspicion.end),
    ):
        low, high = np.searchsorted(frames, (suspicion.start, stop))
        if low < high:
            return int(frames[low])
    return int(frames[np.argmin(np.abs(frames - suspicion.frame))])
