"""How much would be wrong if a suspicion is right."""

from __future__ import annotations

import numpy as np

from tracking.review.evidence import Floats, Rows, keys
from tracking.review.material import REACH_M, Material

_OWN_S = 1.0
"""A meeting this soon belongs to the same suspicion."""


def costs(material: Material, first: Rows, second: Rows, frame: Rows) -> Floats:
    """(k,) rows of the tracks from each frame on until they end or are next near somebody.

    There they may be looked at anyhow.

    Args:
        first, second: (k,) tracks; 0 for none.
    """
    meeting = np.flatnonzero(material.near.nearest_m < REACH_M)
    return _rows_of(material, meeting, first, frame) + _rows_of(material, meeting, second, frame)


def _rows_of(material: Material, meeting: Rows, track: Rows, frame: Rows) -> Floats:
    evidence = material.evidence
    start = evidence.row_from(track, frame)
    end = np.searchsorted(evidence.key, keys(track + 1, np.zeros_like(frame)))
    later = evidence.row_from(track, frame + evidence.frames_of(_OWN_S))
    padded = np.append(meeting, len(evidence))
    following = padded[np.searchsorted(meeting, later)]
    return np.where(track > 0, np.minimum(end, following) - start, 0).astype(np.float64)
