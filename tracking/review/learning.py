"""What the decisions of a session say of the review items that are left.

The stated likelihoods come from a hazard that was fitted to other footage. How often a kind of item
is right differs between recordings and trackers: so the share of a kind that is right here has a
Beta prior about what was stated, and the decisions are its data.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from tracking.review.review_item import ReviewItem

STRENGTH = 4.0
"""Decisions that the prior counts for; `python -m tests.benchmarks.review --risk` compares some."""
_SUREST = 1e-3
"""Likelihoods are kept so far from 0 and 1, where nothing could be learnt any more."""


@dataclass(frozen=True, slots=True)
class KindRecord:
    """What came of the review items of a kind.

    Attributes:
        decided: items said to be right or put right. errors: those that were errors.
        stated: the sum of the likelihoods they were stated with.
    """

    decided: int
    errors: int
    stated: float

    def odds_shift(self, strength: float = STRENGTH) -> float:
        """By how much the log odds of the kind's other items move."""
        mean = _inside(self.stated / self.decided)
        posterior = _inside((strength * mean + self.errors) / (strength + self.decided))
        return _log_odds(posterior) - _log_odds(mean)


def records_of(outcomes: Iterable[tuple[str, float, bool]]) -> dict[str, KindRecord]:
    """By kind, from each decided item's kind, stated likelihood, and whether it was an error."""
    sums: defaultdict[str, list[float]] = defaultdict(lambda: [0, 0, 0.0])
    for kind, stated, error in outcomes:
        for at, value in enumerate((1, int(error), stated)):
            sums[kind][at] += value
    return {kind: KindRecord(int(n), int(wrong), p) for kind, (n, wrong, p) in sums.items()}


def with_learned_likelihoods(
    items: Sequence[ReviewItem], records: Mapping[str, KindRecord], strength: float = STRENGTH
) -> tuple[ReviewItem, ...]:
    """The items with the likelihoods that the decisions leave; of other kinds the very same ones.

    Args:
        items: as they were found, with stated likelihoods. strength: of the prior, in decisions.
    """
    shift = {kind: record.odds_shift(strength) for kind, record in records.items()}
    return tuple(
        replace(one, likelihood=_shifted(one.likelihood, shift[one.kind]))
        if one.kind in shift
        else one
        for one in items
    )


def _shifted(likelihood: float, by: float) -> float:
    return 1.0 / (1.0 + math.exp(-(_log_odds(_inside(likelihood)) + by)))


def _inside(share: float) -> float:
    return min(max(share, _SUREST), 1.0 - _SUREST)


def _log_odds(share: float) -> float:
    return math.log(share / (1.0 - share))
