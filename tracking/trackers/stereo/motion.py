"""How the papers' trackers move people on: random walk around a movement that is known."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.filtering import move
from tracking.trackers.stereo.population import Population
from tracking.trackers.stereo.settings import StereoTrackerSettings


def predict(
    people: Population,
    step: NDArray[np.float64],
    settings: StereoTrackerSettings,
    elapsed_s: float,
    random: np.random.Generator,
) -> Population:
    """Everybody moved on, with a spread that grows while they are missed.

    Args:
        step: (people, 2) m, how far each is thought to have gone.
    """
    spread = settings.process_noise_m * np.sqrt(elapsed_s)
    spreads = spread * (1.0 + settings.process_noise_growth * people.missed_s)
    return people.replace(
        particles=move(people.particles, step, spreads, random),
        position=people.position + step,
    )
