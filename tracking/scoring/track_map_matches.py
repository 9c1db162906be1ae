"""Track-mAP's matching: which tracks stand for which people, by the overlap of whole tracks."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.arrays import Flags, Floats, Integers
from tracking.scoring.comparison import Comparison
from tracking.scoring.examination import Examination
from tracking.scoring.pairs import EPS
from tracking.scoring.similarity import BoxMatch
from tracking.scoring.table import ScoringTable
from tracking.scoring.track_map import OVERLAPS, SUBSETS, TrackMap
from tracking.tracks.boxes import common_px2

_AREAS_PX2 = ((0.0, 32.0**2), (32.0**2, 96.0**2), (96.0**2, 1e5**2))
_LENGTHS = ((0.0, 3.0), (3.0, 10.0), (10.0, 1e5))
_NEAR = 1e-9
_UNKNOWN = -1.0
"""What MOT text has for confidence where a tracker tells none."""


@dataclass(frozen=True, slots=True, eq=False)
class _Whole:
    """Tracks as one thing each.

    Attributes:
        total_px2: (n,) sum of the boxes' areas. rows: (n,) how many there are.
        excluded: (7, n) not of the subset.
    """

    total_px2: Floats
    rows: Integers
    excluded: Flags


@dataclass(frozen=True, slots=True, eq=False)
class _Strong:
    """Couples that overlap enough for some threshold.

    Attributes:
        track, person: (c,) their numbers; people grow within a track.
        overlap: (c,) of the two as a whole.
    """

    track: Integers
    person: Integers
    overlap: Floats

    def in_order(self, order: Integers) -> _Strong:
        """The same by track, tracks numbered by their places in an order."""
        place = np.empty(len(order), np.int64)
        place[order] = np.arange(len(order))
        rank = place[self.track]
        rows = np.argsort(rank, kind="stable")
        return _Strong(rank[rows], self.person[rows], self.overlap[rows])


def track_map(examination: Examination) -> TrackMap | None:
    """Track-mAP of what was compared; None where it is not defined.

    Each track in turn, the surest first, takes the person not yet taken that it overlaps most.
    A person of the subset goes before others. Tracks of equal confidence come in the order of
    their ids. The overlap is that of all boxes together: shared area over covered area.
    Don't-cares, and what stands on them, are left out beforehand.
    """
    comparison = examination.comparison
    confidence = comparison.result.confidence
    if not isinstance(examination.match, BoxMatch) or not _told(comparison.result):
        return None
    sums = np.bincount(comparison.identity, confidence, minlength=comparison.identities)
    surest = sums / comparison.frames_of_identities()
    order = np.argsort(-surest, kind="stable")
    truth = _whole(comparison.truth, comparison.person, comparison.people)
    result = _whole(comparison.result, comparison.identity, comparison.identities)
    strong = _strong(comparison, truth, result).in_order(order)
    found = np.zeros((len(SUBSETS), len(OVERLAPS), len(order)), bool)
    ignored = np.zeros_like(found)
    for subset in range(len(SUBSETS)):
        for number, least in enumerate(OVERLAPS):
            taken = _taken(strong, len(order), float(least), truth.excluded[subset])
            found[subset, number] = taken >= 0
            foreign = np.append(truth.excluded[subset], False)[taken]
            unfound = (taken < 0) & result.excluded[subset][order]
            ignored[subset, number] = foreign | unfound
    people = np.count_nonzero(~truth.excluded, axis=1)
    return TrackMap(surest[order], found, ignored, people)


def _told(result: ScoringTable) -> bool:
    """Whether the tracker says how sure it is."""
    if not len(result):
        return True
    confidence = result.confidence
    if confidence is None or not np.isfinite(confidence).all():
        return False
    return bool((confidence != _UNKNOWN).any())


def _whole(table: ScoringTable, track: Integers, tracks: int) -> _Whole:
    area = table.box[:, 2] * table.box[:, 3]
    total = np.bincount(track, area, minlength=tracks).astype(np.float64)
    rows = np.bincount(track, minlength=tracks)
    mean = total / rows
    subsets = [np.zeros(tracks, bool)]
    subsets += [_outside(mean, *limits) for limits in _AREAS_PX2]
    subsets += [_outside(rows.astype(np.float64), *limits) for limits in _LENGTHS]
    return _Whole(total, rows, np.array(subsets))


def _outside(value: Floats, least: float, most: float) -> Flags:
    return np.asarray((value < least - EPS) | (value > most + EPS))


def _strong(comparison: Comparison, truth: _Whole, result: _Whole) -> _Strong:
    """The overlaps of whole tracks: shared area of all boxes over covered area."""
    rows = comparison.pairs.rows
    shared_px2 = common_px2(comparison.truth.box[rows.truth], comparison.result.box[rows.result])
    couple, of_pair = np.unique(comparison.couple, return_inverse=True)
    person, track = np.divmod(couple, max(1, comparison.identities))
    shared = np.bincount(of_pair, shared_px2, minlength=len(couple))
    covered = result.total_px2[track] + truth.total_px2[person] - shared
    overlap = np.divide(shared, covered, out=np.zeros(len(couple)), where=covered > 0)
    near = np.flatnonzero(overlap > OVERLAPS[0] - _NEAR)
    strong = _Strong(track[near], person[near], overlap[near])
    for number in _doubtful(strong).tolist():
        track_, person_ = int(strong.track[number]), int(strong.person[number])
        strong.overlap[number] = _in_order_of_frames(comparison, track_, person_)
    return strong


def _doubtful(strong: _Strong) -> Integers:
    """(c,) where rounding may lift an overlap over a threshold, or over another of its track."""
    apart = np.abs(strong.overlap[:, None] - OVERLAPS).min(axis=1)
    several = np.bincount(strong.track)[strong.track] > 1
    return np.flatnonzero(several | (apart < _NEAR))


def _in_order_of_frames(comparison: Comparison, track: int, person: int) -> float:
    """A track's overlap with a person, added up frame by frame: it rounds as in TrackEval."""
    truth, result = comparison.truth, comparison.result
    a, b = np.flatnonzero(comparison.person == person), np.flatnonzero(comparison.identity == track)
    area_a = truth.box[a, 2] * truth.box[a, 3]
    area_b = result.box[b, 2] * result.box[b, 3]
    frames, at_a, at_b = np.intersect1d(
        truth.frame[a], result.frame[b], assume_unique=True, return_indices=True
    )
    shared = common_px2(truth.box[a[at_a]], result.box[b[at_b]])
    alone_a, alone_b = np.delete(np.arange(len(a)), at_a), np.delete(np.arange(len(b)), at_b)
    covered = np.concatenate(
        [area_b[at_b] + area_a[at_a] - shared, area_a[alone_a], area_b[alone_b]]
    )
    when = np.concatenate([frames, truth.frame[a[alone_a]], result.frame[b[alone_b]]])
    whole = sum(covered[np.argsort(when)].tolist())
    return sum(shared.tolist()) / whole if whole > 0 else 0.0


def _taken(strong: _Strong, tracks: int, least: float, excluded: Flags) -> Integers:
    """(tracks,) the person each track takes, in the order of their numbers; -1 for none."""
    free = np.ones(len(excluded), bool)
    taken = np.full(tracks, -1)
    near = np.flatnonzero(strong.overlap >= min(least, 1 - 1e-10) - EPS)
    for one in np.split(near, np.flatnonzero(np.diff(strong.track[near])) + 1):
        fit = one[free[strong.person[one]]]
        wanted = fit[~excluded[strong.person[fit]]]
        fit = wanted if len(wanted) else fit
        if len(fit):
            best = _most(strong.overlap, fit.tolist())
            taken[strong.track[best]] = strong.person[best]
            free[strong.person[best]] = False
    return taken


def _most(overlap: Floats, couples: list[int]) -> int:
    """The couple that overlaps most; of equals the last."""
    best = couples[0]
    for couple in couples[1:]:
        if overlap[couple] >= overlap[best] - EPS:
            best = couple
    return best
