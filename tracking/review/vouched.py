"""Places where a person said where people are: there is nothing to suspect."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.review.evidence import Rows
from tracking.review.footage import Footage
from tracking.tracks import Source, row_keys

Flags = NDArray[np.bool_]


def vouched(footage: Footage, tracks: Rows, frame: Rows) -> Flags:
    """(k,) whether a person made or moved the boxes that places are about.

    A jump is told in the frame after it: of one person alone the box before counts as well.

    Args:
        tracks: (k, 2) whom they are about, the second 0 for nobody else. frame: (k,).
    """
    made = footage.key[footage.columns["source"] == Source.PERSON]
    if not len(made):
        return np.zeros(len(frame), bool)
    first, second = tracks.T
    here, other = _among(made, first, frame), _among(made, second, frame)
    before = _among(made, first, frame - 1)
    return np.where(second > 0, here & other, here | before)


def _among(made: Rows, track: Rows, frame: Rows) -> Flags:
    wanted = row_keys(track, np.maximum(frame, 0))
    at = np.minimum(np.searchsorted(made, wanted), len(made) - 1)
    return np.asarray(made[at] == wanted)
