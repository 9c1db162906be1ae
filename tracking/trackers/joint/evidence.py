"""How well every detection suits every person, and what it would mean to be missed.

Standard term: the increments of track scores, log-likelihood ratios (S. Blackman, R. Popoli:
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
from tracking.trackers.population import Population
from tracking.trackers.stereo_update import FASTEST_M_PER_S

Floats = NDArray[np.float64]

_FREEDOM = 4.0
"""Of Student's t, which places follow: a detection is now and then far off."""
_REACH_M = 0.9
"""Nobody is found farther off than this and their fastest walk since they were seen."""
_HIDDEN, _SHOWN = 0.05, 0.5
"""Shares of a body in sight at which nobody and everybody is found."""
_FAINT = 0.05
"""How likely somebody is found of whom nothing should show."""
_EDGE = 0.3
"""A box this share of its height away from the picture's edge is within the picture."""
_DOUBT = 4.0
"""Matches that make somebody likely to be a person at all."""


@dataclass(frozen=True, slots=True)
class Evidence:
    """In nats, against the detection being of somebody new; less is likelier.

    Attributes:
        match: (people, detections), minus the log-likelihood ratio of each pair.
        missed: (people,), `-ln(1 - P_D)`. allowed: (people, detections), the gate.
        distance: (people, detections) m.
    """

    match: Floats
    missed: Floats
    allowed: NDArray[np.bool_]
    distance: Floats


def spread_of(people: Population) -> Floats:
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
        offset: (people, detections, 2) m. spread: (people, 3) as `spread_of`.
        sigma: (detections,) m, the error of the places.
    """
    noise = np.square(sigma)[None, :]
    xx, yy, xy = spread[:, :1] + noise, spread[:, 1:2] + noise, spread[:, 2:]
    area = xx * yy - xy**2
    x, y = offset[..., 0], offset[..., 1]
    squared = (yy * x**2 - 2.0 * xy * x * y + xx * y**2) / area
    tails = (_FREEDOM / 2.0 + 1.0) * np.log1p(squared / _FREEDOM)
    return np.asarray(-np.log(2.0 * np.pi) - 0.5 * np.log(area) - tails)


def arrivals(seen: Detections, settings: JointSettings, elapsed_s: float, view: View) -> Floats:
    """(detections,) log of how many new people are expected a m² in this frame, there.

    Standard term: the birth density (new-target density); it covers false alarms, too.
    """
    width, height = view.camera.size
    box = seen.box
    right, bottom = width - box[:, 0] - box[:, 2], height - box[:, 1] - box[:, 3]
    away = np.minimum.reduce([box[:, 0], box[:, 1], right, bottom]) / np.maximum(box[:, 3], 1.0)
    within = np.where(seen.truncated, 0.0, np.clip(away / _EDGE, 0.0, 1.0))
    rates = np.log([settings.new_at_edge, settings.new_within])
    return np.asarray(rates[0] + within * (rates[1] - rates[0]) + np.log(max(elapsed_s, 1e-3)))


def found_share(people: Population, shown: Floats, settings: JointSettings) -> Floats:
    """(people,) how likely each is detected, by the share of the body in sight.

    Standard term: the detection probability. Newcomers may be nobody: the less often they were
    seen, the likelier.
    """
    share = np.clip((shown - _HIDDEN) / (_SHOWN - _HIDDEN), _FAINT, 1.0 - settings.overlooked)
    return np.asarray(share * (people.matches + 1.0) / (people.matches + _DOUBT))


def evidence_of(
    people: Population,
    seen: Detections,
    sigma: Floats,
    new: Floats,
    likeness: Floats,
    turn: Floats,
    found: Floats,
) -> Evidence:
    """The evidence of all pairs.

    Args:
        people: predicted to this frame. sigma: (detections,) m. new: (detections,) as `arrivals`.
        likeness: (people, detections) log-likelihood ratio of the looks.
        turn: (people, detections) nats, NaN where there is no direction.
        found: (people,) how likely each is detected.
    """
    offset = seen.position[None, :, :2] - people.position[:, None, :]
    distance = np.hypot(offset[..., 0], offset[..., 1])
    place = place_density(offset, spread_of(people), sigma)
    turned = np.where(np.isnan(turn), 0.0, turn)
    match = new - place - likeness + turned - np.log(found)[:, None]
    reach = _REACH_M + FASTEST_M_PER_S * people.missed_s
    return Evidence(match, -np.log1p(-found), distance <= reach[:, None], distance)
