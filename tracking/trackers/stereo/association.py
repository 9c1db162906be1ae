"""Who of the people followed is which detection."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import Association, cheapest_pairs, margins
from tracking.trackers.stereo.cues import Costs
from tracking.trackers.stereo.population import Population
from tracking.trackers.stereo.settings import StereoTrackerSettings

_LONG_MISSED_S = 0.5
"""People missed for longer choose after those who were just seen."""


def associate_people(
    people: Population, costs: Costs, usable: NDArray[np.bool_], settings: StereoTrackerSettings
) -> Association:
    """Pairs of people and detections with the smallest total cost, in three turns.

    First choose those seen a moment ago, then those missed for long, then tentative tracks. What
    suits somebody missed for long better than who chose it is left to them. A detection that suits
    somebody left over nearly as well is taken back: it may be both of them.

    Args:
        people: predicted to this frame. costs: of all pairs.
        usable: (detections,) False for merged regions, which are nobody's observation
            ([Kawashita2014] section 3.4).
    """
    present = people.confirmed & (people.missed_s < _LONG_MISSED_S)
    missed = people.confirmed & ~present
    free = usable.copy()
    taken = np.full(len(people), -1)
    for turn in (present, missed, ~people.confirmed):
        rows, columns = np.flatnonzero(turn), np.flatnonzero(free)
        block = np.ix_(rows, columns)
        row, column = cheapest_pairs(costs.total[block], costs.allowed[block], settings.cost_limit)
        track, detection = rows[row], columns[column]
        if turn is present:
            own = _suits_better(costs, track, detection, missed, 0.0)
            track, detection = track[own], detection[own]
        taken[track] = detection
        free[detection] = False
    track = np.flatnonzero(taken >= 0)
    left_over = present.copy()
    left_over[track] = False
    track = track[_suits_better(costs, track, taken[track], left_over, settings.association_margin)]
    detection = taken[track]
    return Association(track, detection, margins(costs.total, costs.allowed, track, detection))


def _suits_better(
    costs: Costs,
    track: NDArray[np.intp],
    detection: NDArray[np.intp],
    rivals: NDArray[np.bool_],
    margin: float,
) -> NDArray[np.bool_]:
    """(pairs,) whose detection would cost each of the rivals more, by the margin at least.

    Args:
        rivals: (people,) who else may be meant; nobody of the pairs.
    """
    theirs = np.where(costs.allowed, costs.total, np.inf)[np.ix_(rivals, detection)]
    gap = theirs.min(axis=0, initial=np.inf) - costs.total[track, detection]
    return np.asarray(gap >= margin)
