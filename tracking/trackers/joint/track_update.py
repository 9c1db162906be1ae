"""The measurement update of matched people, in the joint tracker.

It is that of a particle filter, with a Kalman filter's for velocity.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import weighted_mean
from tracking.trackers.joint.cues import JointCues
from tracking.trackers.joint.motion import update_motion
from tracking.trackers.stereo.population import Population
from tracking.trackers.stereo.update import Match, weigh_or_scatter


def update_matched(
    people: Population,
    match: Match,
    appearance: NDArray[np.float32],
    sigma: NDArray[np.float64],
    cues: JointCues,
    random: np.random.Generator,
) -> Population:
    """The matched people weighed with their detections, and what is learnt from them.

    Args:
        people: predicted. appearance: (detections, k) as `Population.appearance`.
            sigma: (detections,) m.
    """
    rows, chosen = match.pairs.track, match.pairs.detection
    mine = people.select(rows)
    measured = match.seen.position[chosen, :2]
    measured[match.shared.owner] = match.shared.owner_at
    particles, weight = weigh_or_scatter(mine.particles, measured, sigma[chosen], random)
    position = weighted_mean(particles, weight)
    velocity, motion = update_motion(mine, measured, sigma[chosen])
    colour = cues.update_colours(mine.colour, match.colours[chosen], mine.matches)
    return people.with_rows(
        rows,
        particles=particles,
        weight=weight,
        position=position,
        velocity=velocity,
        motion=motion,
        matches=mine.matches + 1,
        seen_at=position,
        colour=np.where(match.isolated[:, None, None], colour, mine.colour),
        appearance=np.where(
            match.isolated[:, None],
            cues.update_appearance(mine, appearance[chosen]),
            mine.appearance,
        ),
    )
