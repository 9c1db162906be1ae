"""How much would be wrong if a review item is right."""

from __future__ import annotations

import numpy as np

from tracking.review.core.evidence import Floats, Rows
from tracking.tracks import row_keys

_OWN_S = 1.0
"""A meeting this soon belongs to the same review item."""


def costs(key: Rows, meeting: Rows, tracks: Rows, frame: Rows, fps: float) -> Floats:
    """(k,) rows of the tracks from each frame on until they end or are next near somebody.

    There they may be looked at anyhow.

    Args:
        key: (n,) of all rows, ascending, see `tracking.review.core.evidence.keys`.
        meeting: those of rows near somebody. tracks: (k, 2), 0 for none.
    """
    own = max(1, round(_OWN_S * fps))
    return np.asarray(sum(_rows_of(key, meeting, side, frame, own) for side in tracks.T))


def _rows_of(key: Rows, meeting: Rows, track: Rows, frame: Rows, own: int) -> Floats:
    start = np.searchsorted(key, row_keys(track, frame))
    end = np.searchsorted(key, row_keys(track + 1, np.zeros_like(frame)))
    padded = np.append(np.searchsorted(key, meeting), len(key))
    following = padded[np.searchsorted(meeting, row_keys(track, frame + own))]
    return np.where(track > 0, np.minimum(end, following) - start, 0).astype(np.float64)
