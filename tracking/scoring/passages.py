"""Counted passages over a line against those that happened."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class PassageScore:
    """How well the passages over one counting line were found.

    Attributes:
        line: its name.
        happened: passages of the truth. found: of the result. hit: found ones that happened.
    """

    line: str
    happened: int
    found: int
    hit: int

    @property
    def recall(self) -> float:
        """The share of those that happened; NaN where none did."""
        return self.hit / self.happened if self.happened else math.nan

    @property
    def precision(self) -> float:
        """The share of those found that happened; NaN where none was found."""
        return self.hit / self.found if self.found else math.nan


def combined_passages(parts: Sequence[Sequence[PassageScore]]) -> tuple[PassageScore, ...]:
    """Of several recordings: lines of one name are added up, in the order they first appear."""
    lines: dict[str, PassageScore] = {}
    for one in (line for part in parts for line in part):
        sofar = lines.get(one.line, PassageScore(one.line, 0, 0, 0))
        lines[one.line] = PassageScore(
            one.line,
            sofar.happened + one.happened,
            sofar.found + one.found,
            sofar.hit + one.hit,
        )
    return tuple(lines.values())
