"""The overhead recording: who passes below the cameras, told by eye, as nobody labelled it."""

from __future__ import annotations

import numpy as np

from tracking.tracks import Columns

OVERHEAD = "overhead-real"
PASSAGES = ((20, 110), (180, 320), (380, 470), (480, 570))
"""First and last frame of each passage; people are only partly in the picture then."""
_COVERED = 0.5


def passages_found(tracks: Columns) -> int:
    """How many passages have a track that covers half of their frames."""
    return sum(_most_covered(tracks, first, last) for first, last in PASSAGES)


def _most_covered(tracks: Columns, first: int, last: int) -> bool:
    within = (tracks["frame"] >= first) & (tracks["frame"] <= last)
    _, frames = np.unique(tracks["track"][within], return_counts=True)
    return bool(frames.max(initial=0) >= _COVERED * (last - first + 1))
