"""One number for two, by which rows are sorted and found: track and frame, in either order."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Keys = NDArray[np.int64]
Integers = NDArray[Any]

_BITS = 32
"""Tracks and frames are below half of that; see `LARGEST_NUMBER`."""


def row_keys(first: Integers, then: Integers) -> Keys:
    """(n,) one number for each pair, which sorts as the pair does: by the first, then the other.

    Args:
        first, then: (n,) whole numbers up to `LARGEST_NUMBER`; `then` may be a little below 0,
            to look up what comes before the first.
    """
    return np.asarray((np.asarray(first, np.int64) << _BITS) + np.asarray(then, np.int64))


def pairs_of(keys: Keys) -> tuple[Keys, Keys]:
    """The two numbers (n,) of each key, of which none is below 0."""
    return keys >> _BITS, keys & ((1 << _BITS) - 1)
