"""Which frames to watch: from just before to just after."""

from __future__ import annotations

import numpy as np

from tracking.review.evidence import Evidence, Rows
from tracking.review.joining import Places, Reasons

_EXACT = frozenset({"turn", "jump", "lost", "begun", "ended", "drift"})
"""Kinds of reasons that tell the very frame."""
_AROUND_EXACT_S, _AROUND_S = 0.2, 0.35
"""Shown before and after the moment of a reason."""
_OF_LEADER = 0.8
"""Share of the leader's weight from which on another reason's moment is shown as well."""


def stretches(reasons: Reasons, places: Places, evidence: Evidence) -> tuple[Rows, Rows]:
    """(k,), (k,) start and end, half-open, of what shows the weighty reasons of each place."""
    around = np.array(
        [
            evidence.frames_of(_AROUND_EXACT_S if kind in _EXACT else _AROUND_S)
            for kind in reasons.kinds
        ]
    )[reasons.kind]
    before, after = reasons.frame - around, reasons.frame + around + 1
    start, end = before[places.leader], after[places.leader]
    of_leader = reasons.weight[places.leader][places.place]
    weighty = reasons.weight[places.reason] >= _OF_LEADER * of_leader
    place, reason = places.place[weighty], places.reason[weighty]
    np.minimum.at(start, place, before[reason])
    np.maximum.at(end, place, after[reason])
    return np.maximum(start, 0), np.minimum(end, evidence.stop)
