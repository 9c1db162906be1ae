"""Which detection is of whom, who is missed and who is new.

Global nearest neighbour (GNN) data association, a 2-D assignment problem (H. W.
Kuhn: The Hungarian Method for the Assignment Problem, 1955).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import Association, cheapest_pairs, margins
from tracking.trackers.joint.association_likelihoods import AssociationLikelihoods
from tracking.trackers.shared.gating import GatedPairs
from tracking.trackers.stereo.population import Population

NAT = 0.1
"""What a nat is in reported costs: as large as in the papers' sums of metres and colours."""
_SEEN_S = 0.5
"""Who was seen so recently may be meant by a detection as well as who has it."""


def associate_people(
    people: Population,
    likelihoods: AssociationLikelihoods,
    gated: GatedPairs,
    usable: NDArray[np.bool_],
    least_margin: float,
) -> tuple[Association, NDArray[np.intp]]:
    """Pairs of people and detections: the likeliest association of the frame.

    One assignment for everybody: each person has a detection or is missed, each detection is of
    somebody or of somebody new. A detection that suits somebody left over nearly as well may be
    both of them and is nobody's.

    Args:
        gated: all pairs. usable: (detections,) False for those that are nobody's.
        least_margin: nats.

    Returns the pairs, with margins in `NAT`, and the detections that nobody has but somebody new
    may have. Margins are of `match` alone: what it costs or saves that somebody else is missed is
    left out of them, and the hazards of the review are fitted to them as they are.
    """
    columns = np.flatnonzero(usable)
    match, allowed = likelihoods.match[:, columns], gated.allowed[:, columns]
    track, detection = cheapest_pairs(match, allowed, likelihoods.missed)
    rival = people.confirmed & (people.missed_s < _SEEN_S)
    rival[track] = False
    cost = match - likelihoods.missed[:, None]
    theirs = np.where(allowed, cost, np.inf)[rival][:, detection]
    gap = theirs.min(axis=0, initial=np.inf) - cost[track, detection]
    left_over = usable.copy()
    left_over[columns[detection]] = False
    clear = gap >= least_margin
    track, detection = track[clear], detection[clear]
    margin = margins(match, allowed, track, detection)
    return Association(track, columns[detection], NAT * margin), np.flatnonzero(left_over)
