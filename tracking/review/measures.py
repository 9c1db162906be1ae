"""How good a review is: against known mistakes, and as it goes without any."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.review.review_item import ReviewItem
from tracking.tracks import Labels


class Mistake(Protocol):
    """A known mistake, e.g. a `tracking.scoring.IdentityError`."""

    @property
    def frame(self) -> int:
        """When it happened."""

    @property
    def tracks(self) -> tuple[int, ...]:
        """The tracks that are wrong from there on."""


@dataclass(frozen=True, slots=True, eq=False)
class ReviewMeasures:
    """What a reviewer finds who watches the stretches of review items one after the other.

    Attributes:
        errors: how many mistakes there are. minutes: length of the footage.
        footage: (k,) share of the footage's frames watched after each review item: the union of the
            stretches so far; who watches them sees everybody in them.
        found: (k,) mistakes found by then: their moment lies in a stretch watched, and they name
            one of the tracks that the stretch is about.
    """

    errors: int
    minutes: float
    footage: Floats
    found: NDArray[np.int64]

    def found_within(self, footage: float) -> int:
        """Mistakes found with at most this share of the footage, in order, up to where it ends."""
        done = int(np.searchsorted(self.footage, footage + 1e-12, "right"))
        return int(self.found[done - 1]) if done else 0

    def recall(self, footage: float) -> float:
        """The share of the mistakes found with this share of the footage; NaN without mistakes."""
        return self.found_within(footage) / self.errors if self.errors else float("nan")


def review_measures(
    items: Sequence[ReviewItem],
    errors: Iterable[Mistake],
    frames: int,
    fps: float,
) -> ReviewMeasures:
    """Walk review items in the order given and count what is found.

    Args:
        errors: known mistakes, e.g. of `tracking.scoring.identity_errors`.
        frames: length of the footage; fps: its rate.
    """
    missing = list(errors)
    total, found = len(missing), 0
    seen = np.zeros(max(frames, 1), np.bool_)
    footage, counts = [], []
    for one in items:
        seen[one.start : one.end] = True
        left = [error for error in missing if not _shows(one, error)]
        found += len(missing) - len(left)
        missing = left
        footage.append(float(np.count_nonzero(seen)) / len(seen))
        counts.append(found)
    minutes = frames / fps / 60.0
    return ReviewMeasures(total, minutes, np.array(footage), np.array(counts, np.int64))


def _shows(item: ReviewItem, error: Mistake) -> bool:
    """Whether watching the review item's stretch shows the mistake."""
    inside = item.start <= error.frame < item.end
    return inside and not set(item.tracks).isdisjoint(error.tracks)


@dataclass(frozen=True, slots=True)
class ReviewMeter:
    """How a review goes on, without known mistakes.

    Attributes:
        minutes: of footage watched. decided: review items with a verdict. fixed: those put right.
    """

    minutes: float
    decided: int
    fixed: int

    @classmethod
    def of(cls, labels: Labels, minutes: float) -> ReviewMeter:
        """From the verdicts, and the minutes of footage that were watched for them."""
        decisions = [verdict.decision for verdict in labels.verdicts.values()]
        return cls(minutes, len(decisions), decisions.count("fixed"))

    @property
    def fixed_per_minute(self) -> float:
        """Mistakes found and put right for each minute watched; NaN before anything was."""
        return self.fixed / self.minutes if self.minutes > 0 else float("nan")
