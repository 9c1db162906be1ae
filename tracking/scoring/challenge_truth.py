"""Truth of MOTChallenge from 2016 on, whose rows have classes."""

from __future__ import annotations

import numpy as np

from tracking.tracks.columns import Columns

_PERSON = 1
_DISTRACTORS = (2, 7, 8, 12)
"""People on vehicles, people who never move, distractors, reflections."""


def challenge_truth(columns: Columns) -> Columns:
    """The rows of a truth that count or are don't-cares, by their classes where they have some.

    As TrackEval takes them: people whose `conf` is not 0 count, distractors are don't-cares (a
    result row that matches one is dropped), and all else is left out. Unlike there a result row
    does not have to choose between a distractor and a row that is left out.

    Args:
        columns: `confidence` and `class` (NaN: none); without any class they stay as they are.

    Returns: the rows that are kept; `confidence` 0 marks the don't-cares.
    """
    kind = columns.get("class")
    if kind is None or np.isnan(kind).all():
        return columns
    distracts = np.isin(kind, _DISTRACTORS)
    counts = ((kind == _PERSON) | np.isnan(kind)) & (columns["confidence"] != 0)
    kept = distracts | counts
    rows = {name: column[kept] for name, column in columns.items()}
    return rows | {"confidence": np.where(distracts[kept], 0.0, 1.0)}
