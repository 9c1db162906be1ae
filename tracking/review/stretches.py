"""Which frames to watch: those in which most is likely to go wrong near a reason."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.arrays import Flags, Floats
from tracking.review.core.evidence import Evidence, Rows
from tracking.review.hazard.expected_errors import Hazards
from tracking.review.reason_groups import Places, Reasons

_VAGUE = frozenset({"margin", "shared", "crossing", "spread", "split", "colour", "height"})
"""Kinds of reasons that tell about when, not the very frame."""
_SEARCHED_S = 1.2
"""How far from a vague reason's moment the stretch may reach."""
_WATCHED_S = 0.6
_LEAD_S, _TAIL_S = 0.1, 0.2
"""Within a stretch, what happens so near its start and its end is hardly seen."""
_AS_LIKELY, _GROWN_S = 0.4, 0.6
"""Where it goes on being about as likely as that share of the mean, vague stretches grow."""
_CHANGED_OVER = frozenset({"turn", "exchange"})
_TOGETHER_M, _TOGETHER_S, _PARTED_S = 0.5, 0.8, 0.15
"""Who is who after two changed over shows only once they part: waited for that long at most."""
_EXACT = 1.1
"""So much more counts what a reason that knows the frame shows: it says best what went wrong."""
_FOR_NEAR = 1e-3
"""Of stretches in which about as much goes wrong, that around the reason's moment."""


@dataclass(frozen=True, slots=True, eq=False)
class Stretches:
    """Of each place what to watch.

    Attributes:
        start, end: (k,) half-open. frame: (k,) where it happened.
        expected: (k,) how much goes wrong there: hazards of the place's tracks, summed.
    """

    start: Rows
    end: Rows
    frame: Rows
    expected: Floats


def stretches(reasons: Reasons, places: Places, hazards: Hazards) -> Stretches:
    """What shows most of what may have gone wrong, for each place."""
    evidence = hazards.evidence
    leader = places.leader
    told = reasons.frame[leader]
    tracks = np.stack((reasons.first[leader], reasons.second[leader]), axis=1)
    vague = np.isin(reasons.kind[leader], _numbers(reasons, _VAGUE))
    start = told + _offsets(hazards, tracks, told, vague)
    start, end = _grown(hazards, tracks, start, vague)
    end = np.minimum(np.maximum(end, _parted(reasons, places, evidence)), evidence.stop)
    start = np.maximum(start, 0)
    frame = np.where(vague, _worst(hazards, tracks, start, end, told), told)
    shown = _both(hazards, tracks, start, end) * np.where(vague, 1.0, _EXACT)
    order = np.argsort(-shown, kind="stable")
    return Stretches(start, end, frame, hazards.once(tracks, start, end, order))


def _offsets(hazards: Hazards, tracks: Rows, told: Rows, vague: Flags) -> Rows:
    """(k,) where stretches begin, told from the moments of their reasons."""
    evidence = hazards.evidence
    length, searched = evidence.frames_of(_WATCHED_S), evidence.frames_of(_SEARCHED_S)
    lead, tail = evidence.frames_of(_LEAD_S), evidence.frames_of(_TAIL_S)
    usual = -evidence.frames_of(0.15)
    best = np.full(len(told), usual)
    most = np.full(len(told), -np.inf)
    for offset in range(-searched, searched - length + 1):
        holds = -length + tail < offset <= -lead
        shown = _both(hazards, tracks, told + offset + lead, told + offset + length - tail)
        shown = shown * (1.0 - _FOR_NEAR * abs(offset - usual))
        better = (shown > most) & (vague | holds)
        most[better], best[better] = shown[better], offset
    return best


def _grown(hazards: Hazards, tracks: Rows, start: Rows, vague: Flags) -> tuple[Rows, Rows]:
    """(k,), (k,) start and end of stretches; vague ones hold all that is about as likely."""
    evidence = hazards.evidence
    length, lead = evidence.frames_of(_WATCHED_S), evidence.frames_of(_LEAD_S)
    first, end = start + lead, start + length
    least = _AS_LIKELY * _both(hazards, tracks, start, end) / length
    back, ahead = vague.copy(), vague.copy()
    for _ in range(evidence.frames_of(_GROWN_S)):
        back &= _both(hazards, tracks, first - 1, first) >= least
        ahead &= _both(hazards, tracks, end, end + 1) >= least
        first, end = first - back, end + ahead
    return first - lead, end


def _worst(hazards: Hazards, tracks: Rows, start: Rows, end: Rows, told: Rows) -> Rows:
    """(k,) the frames of greatest hazard in stretches."""
    evidence = hazards.evidence
    best = np.clip(told, start, end - 1)
    most = _both(hazards, tracks, best, best + 1)
    for step in range(evidence.frames_of(_WATCHED_S + 2 * _GROWN_S)):
        frame = np.minimum(start + step, end - 1)
        there = _both(hazards, tracks, frame, frame + 1)
        better = there > most * (1.0 + 1e-6)
        most[better], best[better] = there[better], frame[better]
    return best


def _both(hazards: Hazards, tracks: Rows, start: Rows, end: Rows) -> Floats:
    """(k,) hazards of both tracks, summed over stretches."""
    return np.asarray(sum(hazards.expect(side, start, end) for side in tracks.T))


def _parted(reasons: Reasons, places: Places, evidence: Evidence) -> Rows:
    """(k,) just after the frame in which two who changed over part; 0 where nobody did."""
    kinds = _numbers(reasons, _CHANGED_OVER)
    together = np.flatnonzero(np.isin(reasons.kind[places.leader], kinds))
    leader = places.leader[together]
    end = np.zeros(len(places.leader), np.int64)
    frame = reasons.frame[leader]
    one = evidence.row_from(reasons.first[leader], frame)
    other = evidence.row_from(reasons.second[leader], frame)
    for step in range(evidence.frames_of(_TOGETHER_S) + 1):
        a, b = (evidence.later(rows, step) for rows in (one, other))
        apart_m = np.hypot(*(evidence.place[a] - evidence.place[b]).T)
        still = (a >= 0) & (b >= 0) & (apart_m < _TOGETHER_M)
        together, one, other, frame = together[still], one[still], other[still], frame[still]
        end[together] = frame + step + 1 + evidence.frames_of(_PARTED_S)
    return end


def _numbers(reasons: Reasons, kinds: frozenset[str]) -> Rows:
    return np.array([number for number, kind in enumerate(reasons.kinds) if kind in kinds])
