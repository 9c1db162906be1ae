"""Association likelihoods: the score of every pair of a track and a detection, and of a miss.

They are the increments of track scores, log-likelihood ratios (S. Blackman, R. Popoli:
Design and Analysis of Modern Tracking Systems, 1999). Where we differ: there is no false-alarm
density beside the birth density, and places follow Student's t.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import View
from tracking.people import Detections
from tracking.trackers.joint.settings import JointSettings
from tracking.trackers.joint.stage_values import JointFrame
from tracking.trackers.shared.gating import GatedPairs, WideningGate, gate_pairs
from tracking.trackers.stereo.population import Population
from tracking.trackers.stereo.update import FASTEST_M_PER_S

Floats = NDArray[np.float64]

_FREEDOM = 4.0
"""Of Student's t, which places follow: a detection is now and then far off."""
_GATE_M = WideningGate(at_once=0.9, a_second=FASTEST_M_PER_S)
"""The fastest walk since the track was last seen, and more."""
_HIDDEN, _SHOWN = 0.05, 0.5
"""Shares of a body in sight at which nobody and everybody is detected."""
_FAINT = 0.05
"""Detection probability of somebody of whom nothing should show."""
_EDGE = 0.3
"""A box this share of its height away from the picture's edge is within the picture."""
_DOUBT = 4.0
"""Matches that make somebody likely to be a person at all."""


@dataclass(frozen=True, slots=True)
class AssociationLikelihoods:
    """Negative log-likelihood ratios against the detection being of somebody new, in nats.

    Attributes:
        match: (people, detections), of each pair; less is likelier.
        missed: (people,), `-ln(1 - P_D)`.
    """

    match: Floats
    missed: Floats


def gate_people(people: Population, measured: Floats) -> GatedPairs:
    """The pairs within the gate: wide, as the density decides, not the gate.

    Args:
        people: predicted to this frame. measured: (detections, 2) m.
    """
    return gate_pairs(people.position, measured, _GATE_M.radius(people.missed_s)[:, None])


def particle_covariance(people: Population) -> Floats:
    """(people, 3) covariance xx, yy, xy of each person's particles, all alike in weight, m²."""
    count = people.particles.shape[1]
    alike = np.full(count, 1.0 / count, np.float32)
    middle = alike @ people.particles
    x = people.particles[..., 0] - middle[:, :1]
    y = people.particles[..., 1] - middle[:, 1:]
    sums = np.stack((np.vecdot(x, x), np.vecdot(y, y), np.vecdot(x, y)), axis=1)
    return np.asarray(sums.astype(np.float64) / count)


def place_density(offset: Floats, spread: Floats, sigma: Floats) -> Floats:
    """Log-density, in 1/m², of places around those expected: Student's t.

    Args:
        offset: (people, detections, 2) m. spread: (people, 3) as `particle_covariance`.
        sigma: (detections,) m, the error of the places.
    """
    noise = np.square(sigma)[None, :]
    xx, yy, xy = spread[:, :1] + noise, spread[:, 1:2] + noise, spread[:, 2:]
    area = xx * yy - xy**2
    x, y = offset[..., 0], offset[..., 1]
    squared = (yy * x**2 - 2.0 * xy * x * y + xx * y**2) / area
    tails = (_FREEDOM / 2.0 + 1.0) * np.log1p(squared / _FREEDOM)
    return np.asarray(-np.log(2.0 * np.pi) - 0.5 * np.log(area) - tails)


def log_birth_intensity(
    seen: Detections, settings: JointSettings, elapsed_s: float, view: View
) -> Floats:
    """(detections,) log of the birth intensity there: new people expected a m² in this frame.

    It covers false alarms, too.
    """
    width, height = view.camera.size
    box = seen.box
    right, bottom = width - box[:, 0] - box[:, 2], height - box[:, 1] - box[:, 3]
    away = np.minimum.reduce([box[:, 0], box[:, 1], right, bottom]) / np.maximum(box[:, 3], 1.0)
    within = np.where(seen.truncated, 0.0, np.clip(away / _EDGE, 0.0, 1.0))
    rates = np.log([settings.birth_rate_edge, settings.birth_rate_interior])
    return np.asarray(rates[0] + within * (rates[1] - rates[0]) + np.log(max(elapsed_s, 1e-3)))


def detection_probability(people: Population, shown: Floats, settings: JointSettings) -> Floats:
    """(people,) how likely each is detected, by the share of the body in sight.

    A tentative track may be of nobody: the less often it was matched, the likelier.
    """
    share = np.clip((shown - _HIDDEN) / (_SHOWN - _HIDDEN), _FAINT, 1.0 - settings.miss_probability)
    return np.asarray(share * (people.matches + 1.0) / (people.matches + _DOUBT))


def score_pairs(
    people: Population,
    gated: GatedPairs,
    frame: JointFrame,
    appearance: Floats,
    turn: Floats,
    detected: Floats,
) -> AssociationLikelihoods:
    """The association likelihoods of all pairs.

    Args:
        people: predicted to this frame. gated: all pairs.
        appearance: (people, detections) log-likelihood ratio of the appearance.
        turn: (people, detections) nats, NaN where there is no direction.
        detected: (people,) the detection probability.
    """
    place = place_density(gated.offset, particle_covariance(people), frame.sigma)
    turned = np.where(np.isnan(turn), 0.0, turn)
    match = frame.births - place - appearance + turned - np.log(detected)[:, None]
    return AssociationLikelihoods(match, -np.log1p(-detected))
