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
    return np.maximum(start, 0), np.minimum(end, evidence.stop)
