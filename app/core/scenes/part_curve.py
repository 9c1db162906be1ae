"""How a body part went over time."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

THRESHOLD = 0.0
"""Above this score the detector says that a part has failed."""


@dataclass(frozen=True, slots=True, eq=False)
class PartCurve:
    """One part of a person over time.

    Attributes:
        frames: (n,) int64, ascending.
        entropy: (n,) of the weights, 0 to 1; NaN: not filtered. particles: (n,) how many.
        score: (n,) of the detector, above `THRESHOLD`: failed; NaN: not judged.
        failed, occluded: (n,).
    """

    frames: NDArray[np.int64]
    entropy: NDArray[np.float64]
    particles: NDArray[np.float64]
    score: NDArray[np.float64]
    failed: NDArray[np.bool_]
    occluded: NDArray[np.bool_]


@dataclass(frozen=True, slots=True, eq=False)
class LaneScore:
    """How a part of the selected person went, for their lane on the timeline."""

    track: int
    part: int
    curve: PartCurve
