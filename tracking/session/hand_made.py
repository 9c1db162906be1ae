"""Whether tracks are labels that a person made, or what a tracker found."""

from __future__ import annotations

import numpy as np

from tracking.session.track_import import IMPORTED
from tracking.tracks import Run

_NO_TRACKERS = (0.0, 1.0)
"""Confidences in ground truth: a row counts or does not. Trackers are sure to any degree."""
_LOOKS = 20_000
"""About so many rows tell it, evenly spread: looking at millions takes long."""


def is_hand_made(run: Run | None) -> bool:
    """Whether tracks that began as a run are labels, drawn or imported, and no tracker's result.

    Imported tracks are a tracker's where they say how sure it was of each row.

    Args:
        run: what the corrected tracks began as; None: nothing was tracked.
    """
    if run is None or run.tracker != IMPORTED:
        return run is None
    confidence = run.tracks["confidence"]
    some = confidence[:: max(1, len(confidence) // _LOOKS)]
    return bool(np.isin(some, _NO_TRACKERS).all())
