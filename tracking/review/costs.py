"""How much would be wrong if a suspicion is right."""

from __future__ import annotations

import numpy as np

from tracking.review.evidence import Floats, Rows, keys
from tracking.review.material import Material
from tracking.review.reasons.crossings import CLOSE_M

_OWN_S = 1.0
"""A crossing this soon belongs to the same suspicion."""


def costs(material: Material, first: Rows, second: Rows, frame: Rows) -> Floats:
    """(k,) rows of the tracks from each frame on until they end or next cross somebody's way.

    Where they next cross somebody's way they are looked at anyhow.

    Args:
        first, second: (k,) tracks; 0 for none.
    """
    near = material.near
    close = near.distance_m <= CLOSE_M
    crossing = np.zeros(len(material.evidence), np.bool_)
    crossing[near.first[close]] = True
    crossing[near.second[close]] = True
    rows = np.flatnonzero(crossing)
    return _rows_of(material, rows, first, frame) + _rows_of(material, rows, second, frame)


def _rows_of(material: Material, crossing: Rows, track: Rows, frame: Rows) -> Floats:
    evidence = material.evidence
    start = evidence.row_from(track, frame)
    end = np.searchsorted(evidence.key, keys(track + 1, np.zeros_like(frame)))
    later = evidence.row_from(track, frame + evidence.frames_of(_OWN_S))
    padded = np.append(crossing, len(evidence))
    following = padded[np.searchsorted(crossing, later)]
    return np.where(track > 0, np.minimum(end, following) - start, 0).astype(np.float64)
