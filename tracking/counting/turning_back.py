"""Who passes a line and comes back at once: a place that trembles, not a passage."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.counting.paths import Flags, Floats, Integers


def stays_passed(
    over: Integers, side: NDArray[np.int8], distance: Floats, track: Integers, jitter: float
) -> Flags:
    """(k,) which passages over one line are kept.

    Two passages of one track in opposite directions, between which it was never farther from the
    line than jitter, take each other out; what remains of a longer to and fro is the one passage
    that leads to the other side, or none.

    Args:
        over: (k,) the rows that are the first beyond the line, ascending.
        side: (k,) the side each leads to, +1 or -1.
        distance: (n,) from the line, at least 0. track: (n,).
    """
    kept = np.ones(len(over), bool)
    waiting: list[int] = []
    for number in range(len(over)):
        last = waiting[-1] if waiting else -1
        if last >= 0 and track[over[last]] == track[over[number]] and side[last] != side[number]:
            farthest = distance[over[last] : over[number]].max()
            if farthest <= jitter:
                kept[[last, number]] = False
                waiting.pop()
                continue
        waiting.append(number)
    return kept
