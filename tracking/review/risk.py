"""How far a review is, and how many errors are expected to be left.

What items state is held against errors on footage that nothing was fitted to:
`python -m tests.benchmarks.review --risk` prints the figures below and how far off they are.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from tracking.review.review_item import ReviewItem
from tracking.tracks import Labels, TrackTable

SHOWN, HIDDEN = 1.18, 0.53
"""Errors for each one that items state: in items, and where no item is."""
SHAPE = 0.40
"""How much results differ: their errors are as many times those expected as a Gamma variable of
this shape and mean 1 says."""
WEIGHT = 0.30
"""What a decided item counts for. Below 1: errors come in groups, and the items decided first are
those of most worth, so they tell less of the rest than as many taken at random."""
_LOW, _HIGH = 0.1, 0.9

Ranges = list[tuple[int, int]]


@dataclass(frozen=True, slots=True)
class RiskModel:
    """Parameters that were measured: see `SHOWN`, `HIDDEN`, `SHAPE` and `WEIGHT`."""

    shown: float = SHOWN
    hidden: float = HIDDEN
    shape: float = SHAPE
    weight: float = WEIGHT


@dataclass(frozen=True, slots=True)
class DecidedItems:
    """What came of the review items that were decided.

    Attributes:
        stated: sum of their likelihoods as they were found. errors: how many were errors.
    """

    stated: float = 0.0
    errors: int = 0


@dataclass(frozen=True, slots=True)
class ErrorsLeft:
    """Errors expected to be left: a Gamma-Poisson model, whose rate the decisions teach.

    Attributes:
        mean: expected. low, high: hold in at least four of five cases on footage that the figures
            were not fitted to.
        at_items: of those expected, the ones at the items left; the others are where no item is.

    Counted are identity errors as in `tracking.scoring.identity_errors`: somebody goes on under
    another id, or a track goes over to somebody else. People without a track, tracks of nobody and
    inexact boxes are none.
    """

    mean: float
    low: int
    high: int
    at_items: float = 0.0


def errors_left(
    stated_left: float, decided: DecidedItems, stated_hidden: float, model: RiskModel | None = None
) -> ErrorsLeft:
    """Errors left in a session.

    Args:
        stated_left: sum of the likelihoods, as found, of the items left.
        stated_hidden: sum of those of all items, decided ones too, by the share of the footage that
            is not reviewed: errors that no item shows go with it.
        model: another one than the one built in.
    """
    known = model or RiskModel()
    shape, rate = _learned(decided, known)
    shown = known.shown * stated_left
    exposure = shown + known.hidden * stated_hidden
    if exposure <= 0:
        return ErrorsLeft(0.0, 0, 0)
    from scipy.stats import nbinom  # takes long to load, and most commands never need it

    spread = nbinom(shape, rate / (rate + exposure))
    low, high = (int(spread.ppf(share)) for share in (_LOW, _HIGH))
    return ErrorsLeft(shape / rate * exposure, low, high, shape / rate * shown)


def learned_rate(decided: DecidedItems, model: RiskModel | None = None) -> float:
    """How many times as many errors as usual the decisions let expect; 1 before any decision."""
    shape, rate = _learned(decided, model or RiskModel())
    return shape / rate


def _learned(decided: DecidedItems, model: RiskModel) -> tuple[float, float]:
    """Shape and rate of the Gamma variable, once the decisions are known."""
    shape = model.shape + model.weight * decided.errors
    return shape, model.shape + model.weight * model.shown * decided.stated


def reviewed_share(table: TrackTable, labels: Labels, decided: Iterable[ReviewItem] = ()) -> float:
    """The share of rows in reviewed ranges, or in the stretches of decided items; 0 to 1."""
    ranges: defaultdict[int, Ranges] = defaultdict(list)
    for seen in labels.reviewed:
        ranges[seen.track].append((seen.start, seen.end))
    for item in decided:
        for track in item.tracks:
            ranges[track].append((item.start, item.end))
    of_all = ranges.pop(0, [])
    tracks = table.track_ids if of_all else [track for track in ranges if track in table]
    rows = sum(_count(table, track, ranges[track] + of_all) for track in tracks)
    return rows / len(table) if len(table) else 0.0


def _count(table: TrackTable, track: int, ranges: Ranges) -> int:
    """Rows of a track in any of the ranges."""
    if not ranges:
        return 0
    frames = table.frames_of_track(track)
    places = np.searchsorted(frames, _joined(ranges))
    return int((places[:, 1] - places[:, 0]).sum())


def _joined(ranges: Ranges) -> Ranges:
    """Ranges that overlap or touch made one."""
    joined: Ranges = []
    for start, end in sorted(ranges):
        if joined and start <= joined[-1][1]:
            joined[-1] = joined[-1][0], max(joined[-1][1], end)
        else:
            joined.append((start, end))
    return joined
