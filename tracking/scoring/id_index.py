"""Ids as numbers from 0, and rows by what they belong to."""

from __future__ import annotations

import numpy as np

from tracking.arrays import Integers

_SPARSE = 8
"""Ids that spread over more than so many times as many numbers as there are rows are sorted."""


def numbered(ids: Integers) -> tuple[Integers, Integers]:
    """The different ids in order, and (n,) which of them each is."""
    if not len(ids):
        return ids, np.zeros(0, np.int64)
    least = int(ids.min())
    spread = int(ids.max()) - least + 1
    if spread > _SPARSE * len(ids):
        different, number = np.unique(ids, return_inverse=True)
        return different, number
    borne = np.zeros(spread, bool)
    borne[ids - least] = True
    number = np.cumsum(borne) - 1
    return np.flatnonzero(borne) + least, number[ids - least]


def grouped(group: Integers, groups: int) -> Integers:
    """(n,) the rows ordered by group; those of one stay in order."""
    # Numbers of 16 bits are sorted by radix, several times faster.
    small = group.astype(np.uint16) if groups < 1 << 16 else group
    return np.argsort(small, kind="stable")
