"""How people move: at a velocity that changes at random, known as well as it was measured.

The constant-velocity model with continuous white noise of acceleration, whose
process noise intensity is `process_noise` (Y. Bar-Shalom, X. R. Li, T. Kirubarajan: Estimation with
Applications to Tracking and Navigation, 2001).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import move
from tracking.trackers.joint.settings import JointSettings
from tracking.trackers.stereo.population import Population
from tracking.trackers.stereo.update import FASTEST_M_PER_S

Floats = NDArray[np.float64]


def predict(
    people: Population, settings: JointSettings, elapsed_s: float, random: np.random.Generator
) -> Population:
    """Everybody moved on; those missed slow down.

    Constant velocity disturbed by white noise, as in Kalman's filter: the particles spread as much
    as it says the place becomes less known, which is more and more while nobody sees them. Where
    we differ from the sources: there the spread of one step is a constant.
    """
    slower = np.where(people.missed_s > 0.0, np.exp(-elapsed_s / settings.velocity_decay_s), 1.0)
    velocity = people.velocity * slower[:, None]
    step = velocity * elapsed_s
    place, both, speed = people.motion.T
    noise = settings.process_noise
    ahead = place + elapsed_s * (2.0 * both + elapsed_s * speed) + noise * elapsed_s**3 / 3.0
    spread = np.sqrt(np.maximum(ahead - place, 0.0))
    both = both + elapsed_s * speed + noise * elapsed_s**2 / 2.0
    return people.replace(
        particles=move(people.particles, step, spread, random),
        position=people.position + step,
        velocity=velocity,
        motion=np.stack((ahead, both, speed + noise * elapsed_s), axis=1),
    )


def update_motion(mine: Population, measured: Floats, sigma: Floats) -> tuple[Floats, Floats]:
    """Velocity (people, 2) m/s and motion (people, 3) once each was seen at a place.

    Args:
        mine: predicted. measured: (people, 2) m. sigma: (people,) m.
    """
    place, both, speed = mine.motion.T
    total = place + sigma**2
    velocity = mine.velocity + (both / total)[:, None] * (measured - mine.position)
    fast = np.hypot(velocity[:, 0], velocity[:, 1])
    velocity = velocity * np.minimum(1.0, FASTEST_M_PER_S / np.maximum(fast, 1e-9))[:, None]
    kept = sigma**2 / total
    return velocity, np.stack((kept * place, kept * both, speed - both**2 / total), axis=1)
