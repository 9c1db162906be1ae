"""What there is to choose from."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.linking.seen_rows import Floats

Rows = NDArray[np.intp]


@dataclass(frozen=True, slots=True)
class Links:
    """Pairs of tracklets that may be one person's, one after the other.

    Attributes:
        end, start: (k,) the tracklet left and the one gone on with.
        cost: (k,) by what is known without appearance, less the cost of two different people, in
            nats:
            minus the log-likelihood ratio of one person.
    """

    end: Rows
    start: Rows
    cost: Floats

    @classmethod
    def concatenate(cls, portions: Sequence[Links]) -> Links:
        """All of some, one behind the other."""
        none = cls(np.zeros(0, np.intp), np.zeros(0, np.intp), np.zeros(0))
        names = (field.name for field in fields(cls))
        return cls(*(np.concatenate([getattr(p, n) for p in (none, *portions)]) for n in names))

    def select(self, rows: NDArray[np.bool_]) -> Links:
        """Some of them."""
        return Links(self.end[rows], self.start[rows], self.cost[rows])
