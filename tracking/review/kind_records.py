"""Records of the decisions on each kind of review item, and the likelihoods that follow from them.

The stated likelihoods come from a hazard that was fitted to other footage. How many items of a kind
are errors differs between recordings and trackers: that share has a Beta prior whose mean is the
stated one, and the decisions of the session are its data.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from tracking.review.review_item import ReviewItem

STRENGTH = 4.0
"""Weight of the prior, in decisions; `python -m tests.benchmarks.review --risk` compares some."""
_LEAST = 1e-3
"""Likelihoods stay within this of 0 and 1, where decisions could not change them any more."""


@dataclass(frozen=True, slots=True)
class KindRecord:
    """The decisions on review items of one kind.

    Attributes:
        decided: number of items said to be right or corrected. errors: those that were errors.
        stated: sum of their likelihoods as they were found.
    """

    decided: int
    errors: int
    stated: float

    def odds_shift(self, strength: float = STRENGTH) -> float:
        """Change of the log odds of undecided items of the kind; strength: see `STRENGTH`."""
        mean = _inside(self.stated / self.decided)
        posterior = _inside((strength * mean + self.errors) / (strength + self.decided))
        return _log_odds(posterior) - _log_odds(mean)


def records_of(outcomes: Iterable[tuple[str, float, bool]]) -> dict[str, KindRecord]:
    """The record of each kind; outcomes: kind, stated likelihood, whether it was an error."""
    decided: defaultdict[str, list[tuple[float, bool]]] = defaultdict(list)
    for kind, stated, error in outcomes:
        decided[kind].append((stated, error))
    return {
        kind: KindRecord(len(every), sum(error for _, error in every), sum(p for p, _ in every))
        for kind, every in decided.items()
    }


def with_learned_likelihoods(
    items: Sequence[ReviewItem], records: Mapping[str, KindRecord], strength: float = STRENGTH
) -> tuple[ReviewItem, ...]:
    """The items with their posterior likelihoods; items of kinds without a record are unchanged.

    Args:
        items: as they were found, with stated likelihoods. strength: see `STRENGTH`.
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
    return min(max(share, _LEAST), 1.0 - _LEAST)


def _log_odds(share: float) -> float:
    return math.log(share / (1.0 - share))
