"""Boxes to report: what is seen, steadied by the learnt outline."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_TRUST = 0.85
"""Weight of the box seen against the learnt outline."""


def steady_boxes(box: Floats, seen: Floats, alone: NDArray[np.bool_]) -> Floats:
    """(people, 4) px the boxes to report; of whom a region holds somebody else too, the outline.

    Args:
        box: (people, 4) px by the learnt outlines. seen: (people, 4) px, of their regions.
        alone: (people,) who is alone in theirs.
    """
    return box + (_TRUST * alone)[:, None] * (seen - box)
