"""How far the review of a session is: one answer for the window, a project and the command line.

All of it follows from what a session keeps: its tracks, the run they began as and the verdicts.
Opened again, the same session has the same items in the same order and the same figures.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from tracking.review.kind_records import KindRecord, records_of, with_learned_likelihoods
from tracking.review.queue import SAME_S, filter_undecided
from tracking.review.review_item import ReviewItem, ReviewItemKey
from tracking.review.review_search import ReviewFinding
from tracking.review.risk import DecidedItems, ErrorsLeft, errors_left, reviewed_share
from tracking.tracks import Labels, TrackTable

_UNKNOWN = 0.5
"""Likelihood of a decided item of a kind that is not found any more."""
_SECONDS_A_MINUTE = 60.0


@dataclass(frozen=True, slots=True)
class ReviewState:
    """How far a review is.

    Attributes:
        found: all items there are now, with their likelihoods as stated.
        left: those nobody has decided or marked as reviewed, with the likelihoods that the
            decisions teach.
        decided: how many items are decided or in reviewed ranges, those put right among them that
            are not found any more.
        records: what came of the decided items, by kind; outcome: of all.
        reviewed: share of the boxes in reviewed ranges or where decided items are shown, 0 to 1.
        errors: identity errors expected to be left.
        minutes_left: footage to be watched for the items left.
    """

    found: tuple[ReviewItem, ...] = ()
    left: tuple[ReviewItem, ...] = ()
    decided: int = 0
    records: Mapping[str, KindRecord] = field(default_factory=dict)
    outcome: DecidedItems = field(default_factory=DecidedItems)
    reviewed: float = 0.0
    errors: ErrorsLeft = field(default_factory=lambda: ErrorsLeft(0.0, 0, 0))
    minutes_left: float = 0.0

    @property
    def items(self) -> int:
        """How many items there are in all, decided or left."""
        return self.decided + len(self.left)


def review_state(
    finding: ReviewFinding, labels: Labels, table: TrackTable, fps: float
) -> ReviewState:
    """How far the review of tracks is.

    Where tracks were corrected somebody has looked: no error is expected at the items there, as
    long as they are left, too. They stay in the list, as an edit may be wrong.

    Args:
        finding: see `ReviewItemFinder.find`. The items of the tracks as they began tell
            what was stated of decided items which are not found any more.
        labels: with verdicts and reviewed ranges. table: the tracks. fps: frames a second.
    """
    found, begun = finding.items, finding.begun
    stated = _Stated(begun, found, fps)
    outcomes = [
        (key, stated.of(key), verdict.decision == "fixed")
        for key, verdict in labels.verdicts.items()
        if verdict.decision != "dismissed"  # which says nothing
    ]
    records = records_of((kind, likely, error) for (kind, *_), likely, error in outcomes)
    left = filter_undecided(with_learned_likelihoods(found, records), labels, fps, table)
    keys = {one.key for one in left}
    done = [one for one in found if one.key not in keys]
    gone = _gone(labels, found, fps)
    share = reviewed_share(table, labels, [*done, *stated.found_as(gone)])
    outcome = DecidedItems(sum(p for _, p, _ in outcomes), sum(error for *_, error in outcomes))
    counted = [one for one in found if one.key not in finding.corrected]
    whole = sum(one.likelihood for one in counted) + sum(p for key, p, _ in outcomes if key in gone)
    stated_left = sum(one.likelihood for one in counted if one.key in keys)
    return ReviewState(
        found,
        left,
        len(done) + len(gone),
        records,
        outcome,
        share,
        errors_left(stated_left, outcome, whole * (1.0 - share)),
        watched_frames(left) / fps / _SECONDS_A_MINUTE,
    )


def watched_frames(items: Iterable[ReviewItem]) -> int:
    """Frames in the stretches of review items; those that several show count once."""
    every = tuple(items)
    seen = np.zeros(max((item.end for item in every), default=0), np.bool_)
    for item in every:
        seen[max(0, item.start) : item.end] = True
    return int(np.count_nonzero(seen))


def _gone(labels: Labels, found: Sequence[ReviewItem], fps: float) -> frozenset[ReviewItemKey]:
    """Verdicts on items that are not found any more, as they were put right."""
    there = _Places(found, fps)
    return frozenset(key for key in labels.verdicts if there.at(key) is None)


class _Places:
    """Items by kind and tracks; what is found anew may lie a little beside where it was."""

    def __init__(self, items: Iterable[ReviewItem], fps: float) -> None:
        self._reach = round(SAME_S * fps)
        self._by_who: defaultdict[tuple[str, tuple[int, ...]], list[ReviewItem]] = defaultdict(list)
        for one in items:
            self._by_who[one.kind, one.tracks].append(one)

    def at(self, key: ReviewItemKey) -> ReviewItem | None:
        """The nearest one of a kind and tracks within reach of a frame."""
        kind, tracks, frame = key
        near = min(
            self._by_who.get((kind, tracks), ()),
            key=lambda one: abs(one.frame - frame),
            default=None,
        )
        return near if near is not None and abs(near.frame - frame) <= self._reach else None


class _Stated:
    """What was stated of items before they were decided.

    Of one that only an edit brought about, and another one put right, nothing is known any more:
    it is taken for one like the others of its kind.
    """

    def __init__(
        self, begun: Sequence[ReviewItem], found: Sequence[ReviewItem], fps: float
    ) -> None:
        self._places = _Places(begun, fps), _Places(found, fps)
        sums: defaultdict[str, list[float]] = defaultdict(list)
        for one in {one.key: one for one in (*found, *begun)}.values():
            sums[one.kind].append(one.likelihood)
        self._usual = {kind: sum(every) / len(every) for kind, every in sums.items()}

    def of(self, key: ReviewItemKey) -> float:
        """The likelihood that was stated of an item."""
        for places in self._places:
            known = places.at(key)
            if known is not None:
                return known.likelihood
        return self._usual.get(key[0], _UNKNOWN)

    def found_as(self, keys: Iterable[ReviewItemKey]) -> list[ReviewItem]:
        """The items of the tracks as they began, as far as they were known then."""
        known = [self._places[0].at(key) for key in keys]
        return [one for one in known if one is not None]
