"""What a match, or its absence, does to the people followed."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import (
    effective_share,
    hiding_reach,
    out_of_hiding,
    scatter,
    weigh,
    weighted_mean,
)
from tracking.geometry import View
from tracking.trackers.stereo.cues import Cues, likelihood_sigma
from tracking.trackers.stereo.population import Population
from tracking.trackers.stereo.settings import StereoFilterSettings, StereoTrackerSettings
from tracking.trackers.stereo.shared_detections import SharedRegions
from tracking.trackers.stereo.stage_values import AssociatedPeople, MeasuredFrame

Floats = NDArray[np.float64]
_SCATTERED_SHARE = 0.01
"""Below this share of particles that carry weight, the cloud has lost its person."""
FASTEST_M_PER_S = 3.0
"""Of people who walk; who runs is followed by where they are seen."""
_BODY_M = 0.3
_CONFIDENCE_MEMORY_S = 0.5


def age_tracks(people: Population, rows: NDArray[np.intp], elapsed_s: float) -> Population:
    """Everybody one frame older: seconds missed, confidence; `rows` are those matched."""
    missed_s = people.missed_s + elapsed_s
    missed_s[rows] = 0.0
    kept = np.exp(-elapsed_s / _CONFIDENCE_MEMORY_S)
    confidence = people.confidence * kept
    confidence[rows] += 1.0 - kept
    weight = np.full_like(people.weight, 1.0 / people.weight.shape[1])
    return people.replace(missed_s=missed_s, confidence=confidence, weight=weight)


def update_matched(
    people: Population,
    associated: AssociatedPeople,
    frame: MeasuredFrame,
    cues: Cues,
    settings: StereoTrackerSettings,
    random: np.random.Generator,
) -> Population:
    """The matched people weighed with their detections, and what is learnt from them.

    The predicted `position` of the population is still the expected one here.
    """
    rows, chosen = associated.pairs.track, associated.pairs.detection
    mine, measured = people.select(rows), associated.measured(frame)
    sigma = likelihood_sigma(measured, settings)
    particles, weight = weigh_or_scatter(mine.particles, measured, sigma, random)
    position = weighted_mean(particles, weight)
    return people.with_rows(
        rows,
        particles=particles,
        weight=weight,
        position=position,
        velocity=_velocity(mine, measured, associated.since_s, settings.velocity_average_s),
        matches=mine.matches + 1,
        seen_at=position,
        colour=np.where(
            associated.isolated[:, None, None],
            cues.update_colours(mine.colour, frame.colours[chosen], mine.matches),
            mine.colour,
        ),
    )


def update_occluded(
    people: Population,
    expected: Population,
    shared: SharedRegions,
    settings: StereoFilterSettings,
    random: np.random.Generator,
) -> Population:
    """People seen only as a part of somebody else's region: weighed, and no longer missed.

    They count as predicted: [Kawashita2014] takes people in merged regions as undetected.
    """
    rows = shared.occluded
    if len(rows) == 0:
        return people
    sigma = 2.0 * likelihood_sigma(shared.occluded_at, settings)
    particles, weight = weigh_or_scatter(people.particles[rows], shared.occluded_at, sigma, random)
    return people.with_rows(
        rows,
        particles=particles,
        weight=weight,
        position=weighted_mean(particles, weight),
        missed_s=np.maximum(expected.missed_s[rows], 1e-3),
    )


def update_missed(
    people: Population,
    elapsed_s: float,
    view: View,
    settings: StereoFilterSettings,
    sought: NDArray[np.bool_] | None = None,
) -> Population:
    """Those not seen, weighed by where they would not be: behind the people who were seen.

    Where we differ from the sources: there prediction alone carries people who are not detected.
    That somebody is not seen tells where he is not: negative evidence (Koch 2007).

    Args:
        sought: (people,) who may be behind others; None: everybody who is not seen.
    """
    missed = people.missed_s > 0.0
    lost = np.flatnonzero(missed if sought is None else missed & sought)
    present = people.position[people.missed_s == 0.0]
    if len(lost) == 0 or len(present) == 0:
        return people
    reach_m = hiding_reach(present, view.ground.height_m)
    mine = people.particles[lost]
    away_m = out_of_hiding(mine, present, reach_m, _BODY_M)
    # A longer time says more; a person far from every hiding place is just missed.
    weight = np.exp(
        -elapsed_s / settings.negative_information_s * np.minimum(away_m / _BODY_M, 2.0)
    )
    weight /= weight.sum(axis=1, keepdims=True)
    before = mine.mean(axis=1)
    position = people.position[lost] + weighted_mean(mine, weight) - before
    return people.with_rows(lost, weight=weight, position=position)


def weigh_or_scatter(
    particles: NDArray[np.float32],
    measured: Floats,
    sigma: Floats,
    random: np.random.Generator,
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Particles and weights by the likelihood; lost clouds are scattered anew first."""
    weight = weigh(particles, measured, sigma)
    lost = np.flatnonzero(effective_share(weight) < _SCATTERED_SHARE)
    if len(lost) == 0:
        return particles, weight
    particles = particles.copy()
    particles[lost] = scatter(measured[lost], sigma[lost], particles.shape[1], random)
    weight[lost] = weigh(particles[lost], measured[lost], sigma[lost])
    return particles, weight


def _velocity(people: Population, measured: Floats, since_s: Floats, memory_s: float) -> Floats:
    """The velocity after a match: a line through the first few, then a fading memory.

    The gains are those of the g-h filter: expanding memory while a person is new, critically
    damped with time constant `memory_s` later.
    """
    count = people.matches + 2.0
    new = 6.0 / (count * (count + 1.0))
    settled = (1.0 - np.exp(-since_s / memory_s)) ** 2
    gain = np.maximum(new, settled) / np.maximum(since_s, 1e-3)
    velocity = people.velocity + gain[:, None] * (measured - people.position)
    speed = np.hypot(velocity[:, 0], velocity[:, 1])
    slower = np.minimum(1.0, FASTEST_M_PER_S / np.maximum(speed, 1e-9))
    return np.asarray(velocity * slower[:, None])
