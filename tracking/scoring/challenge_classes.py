"""Which rows of a truth count, by MOTChallenge's marks and, from 2016 on, its classes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.tracks.columns import Columns

_PERSON = 1
_DISTRACTORS = (2, 7, 8, 12)
"""People on vehicles, people who never move, distractors, reflections."""

_Flags = NDArray[np.bool_]


def rows_that_count(columns: Columns) -> tuple[_Flags, _Flags | None]:
    """What a truth's `confidence` and `class` say of its rows.

    Without classes rows with `confidence` 0 are don't-cares. With classes it is as TrackEval has
    it: people whose `confidence` is not 0 count, distractors are don't-cares, and all else neither
    counts nor takes a result row away.

    Args:
        columns: `confidence` and, where known, `class`; NaN: none.

    Returns:
        (n,) rows that count; (n,) don't-cares, None where they are all the others.
    """
    counted = np.asarray(columns["confidence"] != 0)
    kind = columns.get("class")
    if kind is None or np.isnan(kind).all():
        return counted, None
    person = (kind == _PERSON) | np.isnan(kind)
    return np.asarray(counted & person), np.isin(kind, _DISTRACTORS)
