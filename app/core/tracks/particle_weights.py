"""Weights of particles as brightness."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.tracks import Columns


def relative_weights(particles: Columns) -> NDArray[np.float32]:
    """(n,) weights relative to the heaviest particle of the same person."""
    tracks, weights = particles["track"], particles["weight"].astype(np.float32)
    if not len(tracks):
        return weights
    starts = np.flatnonzero(np.append(True, tracks[1:] != tracks[:-1]))
    heaviest = np.maximum.reduceat(weights, starts)
    counts = np.diff(np.append(starts, len(tracks)))
    relative: NDArray[np.float32] = weights / np.maximum(
        np.repeat(heaviest, counts), np.float32(1e-30)
    )
    return relative
