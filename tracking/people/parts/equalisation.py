"""Histograms equalised by a reference, so that similar colours fall into different bins."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

LEVELS = 256
CHANNELS = 3
BINS = 8
"""Bins a channel; [ZhaoLee2009] section 3.1."""

Floats = NDArray[np.float32]


def equalisation(reference: Floats) -> NDArray[np.uint8]:
    """M of [ZhaoLee2009] section 3.1: which of the 8 bins each level belongs to.

    A level goes to the bin in which the middle of its share of the reference lies, so that the
    reference itself fills the bins as evenly as whole levels can.

    Args:
        reference: (..., 3, 256) histograms of levels; H of [ZhaoLee2009]. Any sum.

    Returns:
        (..., 3, 256) bins, 0 to 7, never falling with the level. An empty reference gives the
        even division.
    """
    total = reference.sum(axis=-1, keepdims=True)
    even = np.full(LEVELS, 1.0 / LEVELS, np.float32)
    share = np.where(total > 0, reference / np.maximum(total, 1e-12), even)
    middle = np.cumsum(share, axis=-1, dtype=np.float64) - share / 2
    return np.clip(middle * BINS, 0, BINS - 1).astype(np.uint8)


def even_division(count: int) -> NDArray[np.uint8]:
    """(count, 3, 256) bins of equal width: no equalisation."""
    bins = (np.arange(LEVELS) * BINS // LEVELS).astype(np.uint8)
    return np.broadcast_to(bins, (count, CHANNELS, LEVELS)).copy()


def equalised(histograms: Floats, mapping: NDArray[np.uint8]) -> Floats:
    """(n, 24) M(H): the histograms in the bins of their mappings, each channel summing to 1.

    Args:
        histograms: (n, 3, 256) of levels.
        mapping: (n, 3, 256) of `equalisation`.
    """
    count = len(histograms)
    row = np.arange(count * CHANNELS)[:, None] * BINS
    bins = row + mapping.reshape(-1, LEVELS)
    total = np.bincount(
        bins.ravel(), np.asarray(histograms, np.float64).ravel(), count * CHANNELS * BINS
    ).reshape(count, CHANNELS, BINS)
    share = total / np.maximum(total.sum(axis=-1, keepdims=True), 1e-12)
    return np.asarray(share.reshape(count, CHANNELS * BINS), np.float32)


def bhattacharyya(one: Floats, other: Floats) -> Floats:
    """(...) rho = sum_u sqrt(p_u q_u), the mean over the channels: 1 alike, 0 nothing in common.

    Args:
        one, other: (..., 24), each channel summing to 1 (or to 0: nothing was seen).
    """
    together = np.einsum("...u,...u->...", np.sqrt(one), np.sqrt(other))
    return np.asarray(np.minimum(together / CHANNELS, 1), np.float32)
