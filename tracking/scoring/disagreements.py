"""Stretches of frames in which two people say something else of who somebody is."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from tracking.arrays import Integers

Kind = Literal["identity", "only a", "only b"]


@dataclass(frozen=True, slots=True)
class Disagreement:
    """One stretch of frames in which the same two tracks disagree.

    Attributes:
        track_a, track_b: who it is in each; 0: nobody stands there.
        start, end: half-open range of frames.
        kind: "identity", both see somebody and take them for different people; "only a" and
            "only b", one sees nobody.
    """

    track_a: int
    track_b: int
    start: int
    end: int
    kind: Kind


def stretches_of(
    frame: Integers, track_a: Integers, track_b: Integers, gap: int
) -> tuple[Disagreement, ...]:
    """The rows that disagree, by tracks, as stretches in the order of their first frames.

    Args:
        frame, track_a, track_b: (n,) a row each; 0 for nobody.
        gap: stretches of the same two tracks with at most so many frames between are one.
    """
    if not len(frame):
        return ()
    order = np.lexsort((frame, track_b, track_a))
    frame, track_a, track_b = frame[order], track_a[order], track_b[order]
    begins = np.ones(len(frame), bool)
    begins[1:] = (np.diff(track_a) != 0) | (np.diff(track_b) != 0) | (np.diff(frame) > gap + 1)
    first = np.flatnonzero(begins)
    last = np.append(first[1:], len(frame)) - 1
    columns = (track_a[first], track_b[first], frame[first], frame[last] + 1)
    rows = zip(*(column.tolist() for column in columns), strict=True)
    found = [Disagreement(a, b, start, end, _kind(a, b)) for a, b, start, end in rows]
    return tuple(sorted(found, key=lambda one: (one.start, one.track_a, one.track_b)))


def _kind(track_a: int, track_b: int) -> Kind:
    if not track_b:
        return "only a"
    return "identity" if track_a else "only b"
