"""Truth and result compared and matched once, for all that is told of them."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from tracking.arrays import Flags, Floats
from tracking.scoring.clear_matches import clear_matches
from tracking.scoring.comparison import Comparison, compare
from tracking.scoring.conventions import Conventions
from tracking.scoring.motmetrics import motmetrics_admitted, motmetrics_matches
from tracking.scoring.pairs import Candidates
from tracking.scoring.similarity import BoxMatch, FloorMatch, Match
from tracking.scoring.table import ScoringTable


@dataclass(frozen=True, slots=True, eq=False)
class Examination:
    """What scores, errors and tables of people are made from.

    Attributes:
        comparison: the rows that count.
        matched: the pairs matched for CLEAR, by frame.
        frames: length of the recording, as far as it is known.
        match: how rows were paired. conventions: by whose definitions.
    """

    comparison: Comparison
    matched: Candidates
    frames: int
    match: Match
    conventions: Conventions

    @property
    def unit(self) -> float:
        """What a similarity of 0 means as a distance: 1 for boxes, metres on the floor."""
        return 2.0 * self.match.radius_m if isinstance(self.match, FloorMatch) else 1.0

    @property
    def admitted(self) -> Flags:
        """(k,) pairs of the comparison that may be one person, for naming people after tracks."""
        if self.conventions is Conventions.MOTMETRICS:
            return motmetrics_admitted(self.comparison)
        return np.asarray(self.comparison.pairs.similarity >= self.comparison.threshold)

    @property
    def distances_m(self) -> Floats:
        """(k,) on the floor between matched rows; NaN where one has no position."""
        if not (self.comparison.truth.placed and self.comparison.result.placed):
            return np.full(len(self.matched), np.nan)
        truth, result = self.comparison.truth.position, self.comparison.result.position
        apart = truth[self.matched.rows.truth] - result[self.matched.rows.result]
        return np.hypot(apart[:, 0], apart[:, 1])


def examine(
    truth: ScoringTable,
    result: ScoringTable,
    match: Match | None = None,
    frames: int = 0,
    conventions: Conventions = Conventions.TRACKEVAL,
) -> Examination:
    """Compare and match; the arguments are those of `score`.

    Raises:
        FormatError: a side has nothing to be matched by.
    """
    last = max((int(table.frame[-1]) for table in (truth, result) if len(table)), default=-1)
    match = match or BoxMatch()
    if conventions is Conventions.MOTMETRICS:
        # It never hears of don't-cares: they are left out when its files are read.
        truth = truth.rows(truth.counted)
        match = replace(match, first_pixel=0.0) if isinstance(match, BoxMatch) else match
    comparison = compare(truth, result, match)
    matched = (
        motmetrics_matches(comparison)
        if conventions is Conventions.MOTMETRICS
        else clear_matches(comparison)
    )
    return Examination(comparison, matched, max(frames, last + 1), match, conventions)
