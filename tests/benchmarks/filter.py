"""How long the particle filter takes for a frame, in milliseconds of processor time."""

from __future__ import annotations

import sys
import time
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from tests.benchmarks.tracker_peers.comparison import chosen_settings
from tests.peers.follow import SEEN
from tests.peers.followers import STONESOUP_GNN
from tracking.filtering import (
    associate,
    bhattacharyya_distance,
    move,
    resample,
    weigh,
    weighted_mean,
)

_PEOPLE, _PARTICLES = 15, 700
_NUMBERS_OF_PEOPLE = (1, 5, 15, 50)
_NUMBERS_OF_PARTICLES = (100, 350, 700, 1400, 2800)
_FRAMES, _WARM = 200, 40
_ELAPSED_S, _BINS = 0.05, 64
_SPREAD_M, _SIGMA_M, _GATE_M, _COST_LIMIT = 0.06, 0.15, 0.9, 2.0
_NOISE_M = 0.06

Floats = NDArray[np.float64]


def filter_ms(people: int, particles: int) -> float:
    """The median time of the filter's five steps over crossing walkers, association included.

    Predict, cost of all pairs from distance and colour, the assignment with the least total,
    weigh and estimate, resample: what [Kawashita2014] section 3 has, for all people at once.
    Left out is what the default tracker does beyond these: who is hidden, new, lost or shares a
    region, what looks and noise are learnt, boxes and the run's columns.
    """
    random = np.random.default_rng(people)
    start, velocity, colour = _walkers(people, random)
    detections = _detected(start, velocity, random)
    crowd = np.repeat(start.astype(np.float32)[:, None], particles, axis=1)
    spread, sigma = np.full(people, _SPREAD_M), np.full(people, _SIGMA_M)
    position, taken = start, []
    for measured in detections:
        begun = time.process_time()
        crowd = move(crowd, velocity * _ELAPSED_S, spread, random)
        expected = position + velocity * _ELAPSED_S
        distance = np.linalg.norm(measured[None] - expected[:, None], axis=2)
        cost = 2.0 * distance + bhattacharyya_distance(colour, colour)
        pairs = associate(cost, distance <= _GATE_M, _COST_LIMIT)
        seen = expected
        seen[pairs.track] = measured[pairs.detection]
        weight = weigh(crowd, seen, sigma)
        position = weighted_mean(crowd, weight)
        crowd = resample(crowd, weight, random)
        taken.append(time.process_time() - begun)
    return _usual_ms(taken)


def _walkers(
    people: int, random: np.random.Generator
) -> tuple[Floats, Floats, NDArray[np.float32]]:
    """Where people start (people, 2), how fast they walk, and their histograms of colour."""
    start = random.uniform((-4.0, 2.0), (4.0, 12.0), (people, 2))
    velocity = random.uniform(-1.2, 1.2, (people, 2))
    colour = random.dirichlet(np.full(_BINS, 0.1), people).astype(np.float32)
    return start, velocity, colour


def _detected(start: Floats, velocity: Floats, random: np.random.Generator) -> Floats:
    """(frames, people, 2) where they are seen, off by 6 cm."""
    elapsed_s = np.arange(1, _FRAMES)[:, None, None] * _ELAPSED_S
    walked = start + elapsed_s * velocity
    return np.asarray(walked + random.normal(0.0, _NOISE_M, walked.shape))


def stonesoup_ms(people: int) -> float | None:
    """The median time Stone Soup's GNN tracker takes for a frame of the same detections.

    Over the same frames as `filter_ms`. None where it is not installed, which is told.
    """
    if not STONESOUP_GNN.peer.installed:
        print(STONESOUP_GNN.peer.absent, file=sys.stderr)
        return None
    random = np.random.default_rng(people)
    detections = _detected(*_walkers(people, random)[:2], random)
    frame = np.repeat(np.arange(len(detections)), people)
    seen = np.zeros((len(frame), len(SEEN)))
    seen[:, SEEN.index("frame")] = frame
    seen[:, SEEN.index("x") : SEEN.index("y") + 1] = detections.reshape(-1, 2)
    clips = {"walkers": (len(detections), 1.0 / _ELAPSED_S, seen)}
    (followed,) = STONESOUP_GNN.follow(clips, [chosen_settings("crossing")[STONESOUP_GNN.name]])
    return _usual_ms(followed["walkers"][1])


def _usual_ms(taken_s: NDArray[np.float64] | Sequence[float]) -> float:
    """The median of frames' times, in ms, once everybody is followed."""
    return float(1000.0 * np.median(taken_s[_WARM:]))


def straightness(numbers: Sequence[int], times_ms: Sequence[float]) -> tuple[float, float]:
    """The straight line through times of so many: its slope, and the worst distance from it.

    The distance is a share of the longest time; 0 where cost grows exactly in proportion.
    """
    slope, start = np.polyfit(numbers, times_ms, 1)
    apart = np.abs(np.asarray(times_ms) - (start + slope * np.asarray(numbers)))
    return float(slope), float(apart.max() / max(times_ms))


def measure() -> dict[str, float | None]:
    """The filter alone, and how its time grows with people and particles.

    `ms`: the filter step, 15 people of 700 particles, association included. `ms_N_people`: the
    same for N people; `ms_N_particles`: 15 people of N particles. `us_per_...`: slopes of straight
    lines through those, and `..._off_the_line` how far the farthest is from its line, as a share of
    the longest time. `vs_stonesoup`: `ms` over the time of Stone Soup's GNN tracker for the same
    detections, both the median of the same frames; None where it is not installed.
    """
    by_people = {n: filter_ms(n, _PARTICLES) for n in _NUMBERS_OF_PEOPLE}
    by_particles = {n: filter_ms(_PEOPLE, n) for n in _NUMBERS_OF_PARTICLES}
    theirs = stonesoup_ms(_PEOPLE)
    figures: dict[str, float | None] = {"ms": by_people[_PEOPLE]}
    for each, what, times_ms in (
        ("person", "people", by_people),
        ("particle", "particles", by_particles),
    ):
        slope, off = straightness(list(times_ms), list(times_ms.values()))
        figures |= {f"ms_{n}_{what}": ms for n, ms in times_ms.items()}
        figures |= {f"us_per_{each}": 1000.0 * slope, f"{what}_off_the_line": off}
    figures["vs_stonesoup"] = None if theirs is None else by_people[_PEOPLE] / theirs
    return figures
