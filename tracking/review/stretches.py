"""Which frames to watch: from just before to just after."""

from __future__ import annotations

import numpy as np

from tracking.review.evidence import Evidence, Rows
from tracking.review.joining import Places, Reasons

_EXACT = frozenset({"turn", "jump", "lost", "begun", "ended", "drift"})
"""Kinds of reasons that tell the very frame."""
_BEFORE_EXACT_S, _BEFORE_S, _AFTER_S = 0.15, 0.3, 0.4
"""Shown before and after the moment of a reason. Afterwards it takes people a few steps until it
shows who is who."""
_OF_LEADER = 0.8
"""Share of the leader's weight from which on another reason's moment is shown as well."""
_CHANGED_OVER = frozenset({"turn", "exchange"})
_TOGETHER_M, _TOGETHER_S, _PARTED_S = 0.5, 0.8, 0.15
"""Who is who after two changed over shows only once they part: waited for that long at most."""


def stretches(reasons: Reasons, places: Places, evidence: Evidence) -> tuple[Rows, Rows]:
    """(k,), (k,) start and end, half-open, of what shows the weighty reasons of each place."""
    lead = [_BEFORE_EXACT_S if kind in _EXACT else _BEFORE_S for kind in reasons.kinds]
    before = reasons.frame - np.array([evidence.frames_of(s) for s in lead])[reasons.kind]
    after = reasons.frame + evidence.frames_of(_AFTER_S) + 1
    start, end = before[places.leader], after[places.leader]
    of_leader = reasons.weight[places.leader][places.place]
    weighty = reasons.weight[places.reason] >= _OF_LEADER * of_leader
    place, reason = places.place[weighty], places.reason[weighty]
    np.minimum.at(start, place, before[reason])
    np.maximum.at(end, place, after[reason])
    end = np.maximum(end, _parted(reasons, places, evidence))
    return np.maximum(start, 0), np.minimum(end, evidence.stop)


def _parted(reasons: Reasons, places: Places, evidence: Evidence) -> Rows:
    """(k,) just after the frame in which two who changed over part; 0 where nobody did."""
    kinds = [number for number, kind in enumerate(reasons.kinds) if kind in _CHANGED_OVER]
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
