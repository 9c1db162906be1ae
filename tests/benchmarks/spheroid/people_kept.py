"""Who is followed by which track, frame by frame, and how far away it is."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tests.benchmarks.rendered_clips import Columns
from tracking.scoring import FloorMatch, ScoringTable
from tracking.scoring.clear_matching import clear_matches
from tracking.scoring.comparison import compare

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class Followed:
    """The truth's rows that are asked about, by frame.

    Attributes:
        frame, person: (n,) of the truth.
        place: (n, 2) true x, y.
        track: (n,) the result's track that is matched; 0: none.
        found: (n, 2) where that track is; NaN: none.
    """

    frame: Integers
    person: Integers
    place: Floats
    track: Integers
    found: Floats

    @property
    def error_m(self) -> Floats:
        """(n,) distance on the floor; NaN where nobody follows."""
        return np.asarray(np.hypot(*(self.found - self.place).T))

    def during(self, start: int, end: int, person: int = 0) -> Followed:
        """The rows of some frames, half-open, and of one person unless that is 0."""
        kept = (self.frame >= start) & (self.frame < end)
        if person:
            kept &= self.person == person
        return Followed(
            self.frame[kept],
            self.person[kept],
            self.place[kept],
            self.track[kept],
            self.found[kept],
        )


def follow(truth: Mapping[str, NDArray[np.generic]], tracks: Columns, radius_m: float) -> Followed:
    """Match rows by floor distance as MOTA does: last frame's partners stay together.

    Args:
        truth: frame, track, x, y.
        tracks: a run's.
        radius_m: farther apart is not the same person.
    """
    match = FloorMatch(radius_m)
    comparison = compare(table_of(truth), table_of(tracks), match)
    matched = clear_matches(comparison)
    said = comparison.truth
    track = np.zeros(len(said), np.int64)
    found = np.full((len(said), 2), np.nan)
    track[matched.rows.truth] = comparison.result.track[matched.rows.result]
    found[matched.rows.truth] = comparison.result.position[matched.rows.result]
    return Followed(said.frame, said.track, said.position, track, found)


def table_of(columns: Mapping[str, NDArray[np.generic]]) -> ScoringTable:
    """Floor positions as they are scored."""
    nowhere = np.full(len(columns["frame"]), np.nan)
    boxes = {name: columns.get(name, nowhere) for name in ("left", "top", "width", "height")}
    named = {name: columns[name] for name in ("frame", "track", "x", "y")}
    return ScoringTable.from_columns({**boxes, **named})
