"""The measurement update of matched people, in the joint tracker.

It is that of a particle filter, with a Kalman filter's for velocity.
"""

from __future__ import annotations

import numpy as np

from tracking.filtering import weighted_mean
from tracking.trackers.joint.cues import JointCues
from tracking.trackers.joint.motion import update_motion
from tracking.trackers.joint.stage_values import AssociatedTracks, JointFrame
from tracking.trackers.stereo.population import Population
from tracking.trackers.stereo.update import weigh_or_scatter


def update_matched(
    people: Population,
    associated: AssociatedTracks,
    frame: JointFrame,
    cues: JointCues,
    random: np.random.Generator,
) -> Population:
    """The matched people weighed with their detections, and what is learnt from them.

    Args:
        people: predicted.
    """
    rows, chosen = associated.pairs.track, associated.pairs.detection
    mine, measured, sigma = people.select(rows), associated.measured(frame), frame.sigma[chosen]
    particles, weight = weigh_or_scatter(mine.particles, measured, sigma, random)
    position = weighted_mean(particles, weight)
    velocity, motion = update_motion(mine, measured, sigma)
    colour = cues.update_colours(mine.colour, frame.colours[chosen], mine.matches)
    return people.with_rows(
        rows,
        particles=particles,
        weight=weight,
        position=position,
        velocity=velocity,
        motion=motion,
        matches=mine.matches + 1,
        seen_at=position,
        colour=np.where(associated.isolated[:, None, None], colour, mine.colour),
        appearance=np.where(
            associated.isolated[:, None],
            cues.update_appearance(mine, frame.appearance[chosen]),
            mine.appearance,
        ),
    )
