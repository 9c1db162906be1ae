"""Passages that were found against those that happened."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.arrays import Floats
from tracking.counting.passages import Passages

LATEST_S = 1.0
"""A passage found is the one that happened when they are no farther apart in time."""


@dataclass(frozen=True, slots=True)
class Hits:
    """How well passages were found.

    Attributes:
        happened, found: how many there were, and how many were said.
        hit: how many that happened were found: same line, same direction, near in time, each
            found one standing for one that happened.
    """

    happened: int
    found: int
    hit: int

    @property
    def rate(self) -> float:
        """The share of those that happened; NaN where none did."""
        return self.hit / self.happened if self.happened else float("nan")

    @property
    def precision(self) -> float:
        """The share of those found that happened; NaN where none was found."""
        return self.hit / self.found if self.found else float("nan")

    def __add__(self, other: Hits) -> Hits:
        """Of two lines or recordings together."""
        return Hits(self.happened + other.happened, self.found + other.found, self.hit + other.hit)


def compare_passages(found: Passages, truth: Passages, latest_s: float = LATEST_S) -> Hits:
    """Pair the passages of each line and direction, as many as can be."""
    hits = Hits(0, 0, 0)
    for line in np.union1d(found.line, truth.line).tolist():
        for forward in (True, False):
            said = found.time_s[(found.line == line) & (found.forward == forward)]
            was = truth.time_s[(truth.line == line) & (truth.forward == forward)]
            hits += Hits(len(was), len(said), _paired(said, was, latest_s))
    return hits


def _paired(said: Floats, was: Floats, latest_s: float) -> int:
    """The largest number of pairs (one each) no farther apart than latest_s."""
    # Both are sorted: taking the earliest that still fits is best for moments on a line.
    pairs, at = 0, 0
    for moment in was.tolist():
        while at < len(said) and said[at] < moment - latest_s:
            at += 1
        if at < len(said) and said[at] <= moment + latest_s:
            pairs, at = pairs + 1, at + 1
    return pairs
