"""How long the particle filter takes for a frame, in milliseconds of processor time."""

from __future__ import annotations

import sys
import time
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).parents[1] / "trackers"))

from people_on_a_floor import Walker, observations, straight, view

from tracking.trackers.stereo import StereoTracker
from tracking.trackers.stereo_direction import MiddleUpdated, StereoDirectionSettings

_PARTICLES = 500
_FRAMES = 80


def step_ms(people: int) -> float:
    """The median time of a whole tracker step with so many people, particles stored."""
    random = np.random.default_rng(people)
    starts = random.uniform((-2.0, 4.0), (2.0, 9.0), (people, 2))
    speeds = random.uniform(-0.2, 0.2, (people, 2))
    walkers = [
        Walker(straight(at, speed, _FRAMES), k % 16)
        for k, (at, speed) in enumerate(zip(starts, speeds, strict=True))
    ]
    settings = StereoDirectionSettings(particles=_PARTICLES, birth_distance_m=0.0)
    tracker = StereoTracker(view(), settings, MiddleUpdated(settings), seed=0)
    taken = []
    for observation in observations(walkers):
        begun = time.thread_time()
        tracker.step(observation)
        taken.append(1000.0 * (time.thread_time() - begun))
    return float(np.median(taken[20:]))


def measure() -> dict[str, float | None]:
    """`ms` for 15 people and `ms_50_people`; a peer that is not installed gives None."""
    return {"ms": step_ms(15), "ms_50_people": step_ms(50), "vs_stonesoup": None}
