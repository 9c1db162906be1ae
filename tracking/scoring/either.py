"""Rows that are one person by their boxes or by where they stand."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from tracking.arrays import Floats
from tracking.errors import FormatError
from tracking.scoring.pairs import Rows
from tracking.scoring.similarity import BoxMatch, FloorMatch
from tracking.scoring.table import ScoringTable


@dataclass(frozen=True, slots=True)
class EitherMatch:
    """Boxes that overlap by half, or places on the floor within a radius: whichever says more.

    Attributes:
        radius_m: greatest distance of one person's positions.
    """

    radius_m: float = 0.5
    threshold: float = field(default=0.5, init=False)

    def __post_init__(self) -> None:
        FloorMatch(self.radius_m)  # refuses a radius that is none

    def measured(self, table: ScoringTable) -> Floats:
        """(11, n) everywhere: what is far apart in the picture may be near on the floor.

        Then what boxes and places are compared by.
        """
        everywhere = np.repeat([[-np.inf], [np.inf]], len(table), axis=1)
        places = FloorMatch(self.radius_m).measured(table)
        return np.concatenate([everywhere, BoxMatch().measured(table), places])

    def similarity(self, truth: Floats, result: Floats, pairs: Rows) -> Floats:
        """The greater of both similarities, each 0.5 where it just suffices."""
        boxes = BoxMatch().similarity(truth[2:7], result[2:7], pairs)
        places = FloorMatch(self.radius_m).similarity(truth[7:], result[7:], pairs)
        return np.maximum(boxes, places)

    def require(self, table: ScoringTable, side: str) -> None:
        """Boxes or positions are asked for."""
        nowhere = np.isnan(table.box).any(axis=1) & np.isnan(table.position).any(axis=1)
        if len(table) and nowhere.all():
            raise FormatError(
                "the {side} has neither boxes nor floor positions to be matched by", side=side
            )
