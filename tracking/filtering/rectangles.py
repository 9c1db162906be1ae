"""The particle filter over rectangles in the picture, for many targets with many particles each.

The particles of all targets stand one target's after the other's in flat arrays, as the number of
particles differs from target to target and from frame to frame. A particle holds one rectangle or
several that belong together, each with the state X, Y, W, H, dX, dY: centre and size in px, and
the centre's velocity in px/s. Nothing here loops over particles or targets.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats

States = NDArray[np.float32]
Counts = NDArray[np.int64]

X, Y, WIDTH, HEIGHT, DX, DY = range(6)
"""Columns of a state."""
_LEAST_SIZE_PX = 3.0
_FLAT = 1e-300


@dataclass(frozen=True, slots=True, eq=False)
class Clouds:
    """Particles of many targets; nothing is changed in place.

    Attributes:
        state: (particles, rectangles, 6) of all targets.
        weight: (particles,) float32, sums to 1 over each target's.
        start: (targets + 1,) int64; target i's particles are the rows start[i] to start[i + 1],
            and there is at least one.
    """

    state: States
    weight: NDArray[np.float32]
    start: Counts

    @property
    def count(self) -> Counts:
        """(targets,) how many particles each has."""
        return np.diff(self.start)

    @property
    def owner(self) -> NDArray[np.intp]:
        """(particles,) which target each is of."""
        return np.repeat(np.arange(len(self.start) - 1), self.count)

    def weighed(self, weight: NDArray[np.float32]) -> Clouds:
        """The same particles with other weights."""
        return Clouds(self.state, weight, self.start)

    def select(self, targets: NDArray[np.intp]) -> Clouds:
        """The particles of some targets, in their order."""
        count = self.count[targets]
        start = starts_of(count)
        rows = np.arange(start[-1]) + np.repeat(self.start[targets] - start[:-1], count)
        return Clouds(self.state[rows], self.weight[rows], start)


def starts_of(count: Counts) -> Counts:
    """(targets + 1,) where each target's particles start and the last one's end."""
    return np.concatenate((np.zeros(1, np.int64), np.cumsum(count)))


def joined_clouds(one: Clouds, other: Clouds) -> Clouds:
    """The targets of one, then those of the other."""
    return Clouds(
        np.concatenate((one.state, other.state)),
        np.concatenate((one.weight, other.weight)),
        np.concatenate((one.start, one.start[-1] + other.start[1:])),
    )


def no_clouds(rectangles: int) -> Clouds:
    """No targets, with so many rectangles a particle."""
    empty = np.zeros((0, rectangles, 6), np.float32)
    return Clouds(empty, np.zeros(0, np.float32), np.zeros(1, np.int64))


def scattered(state: Floats, spread: Floats, count: Counts, random: np.random.Generator) -> Clouds:
    """Put particles of equal weight at random around states.

    Args:
        state: (targets, rectangles, 6). spread: the same shape, standard deviations.
        count: (targets,) particles of each. random: where the noise comes from.
    """
    particles = np.repeat(state.astype(np.float32), count, axis=0)
    noise = random.standard_normal(particles.shape, dtype=np.float32)
    particles += noise * np.repeat(spread.astype(np.float32), count, axis=0)
    weight = np.repeat((1.0 / np.maximum(count, 1)).astype(np.float32), count)
    return Clouds(_sized(particles), weight, starts_of(count))


def drifted(
    clouds: Clouds, elapsed_s: float, spread: Floats, random: np.random.Generator
) -> Clouds:
    """Move all particles at their own velocities, plus a random spread.

    [ZhaoLee2009] section 3: a uniform velocity motion model.

    Args:
        elapsed_s: since the last frame.
        spread: (targets, rectangles, 6) standard deviations after this time.
    """
    state = clouds.state.copy()
    state[..., :2] += state[..., 4:] * np.float32(elapsed_s)
    noise = random.standard_normal(state.shape, dtype=np.float32)
    noise *= np.repeat(spread.astype(np.float32), clouds.count, axis=0)
    state += noise
    return Clouds(_sized(state), clouds.weight, clouds.start)


def weighed_by(clouds: Clouds, log_likelihood: NDArray[np.floating]) -> Clouds:
    """The particles with weights by the logarithms (particles,) of their likelihoods.

    Taken relative to each target's best particle, so that weights never vanish all together.
    """
    if not len(clouds.weight):
        return clouds
    first, count = clouds.start[:-1], clouds.count
    log = np.asarray(log_likelihood, np.float64)
    best = np.maximum.reduceat(log, first)
    likelihood = np.exp(log - np.repeat(best, count)) * clouds.weight
    total = np.maximum(np.add.reduceat(likelihood, first), _FLAT)
    return clouds.weighed((likelihood / np.repeat(total, count)).astype(np.float32))


def mean_states(clouds: Clouds) -> Floats:
    """(targets, rectangles, 6) the weighted means: the estimates."""
    if not len(clouds.weight):
        return np.zeros((0, *clouds.state.shape[1:]))
    weighted = clouds.state.astype(np.float64) * clouds.weight[:, None, None]
    return np.asarray(np.add.reduceat(weighted, clouds.start[:-1], axis=0))


def entropies(clouds: Clouds) -> Floats:
    """(targets,) -sum w log w over log N: 1 where all weights are alike, 0 where one has all."""
    if not len(clouds.weight):
        return np.zeros(0)
    weight = clouds.weight.astype(np.float64)
    terms = -weight * np.log(np.maximum(weight, _FLAT))
    total = np.add.reduceat(terms, clouds.start[:-1])
    return np.asarray(np.clip(total / np.log(np.maximum(clouds.count, 2)), 0.0, 1.0))


def particle_counts(count: Counts, entropy: Floats, growth: float, least: int, most: int) -> Counts:
    """(targets,) how many particles come next: `N_t = C N_(t-1) (-sum w log w) / (-log 1/N_(t-1))`.

    [ZhaoLee2009] eq. 2: many where much looks alike or the target was missed, few where one place
    alone suits.

    Args:
        count: N_(t-1). entropy: of `entropies`. growth: C. least, most: N_t stays between them.
    """
    return np.asarray(np.clip(np.rint(growth * count * entropy), least, most), np.int64)


def redrawn(clouds: Clouds, count: Counts, random: np.random.Generator) -> Clouds:
    """Multiply heavy particles and drop light ones, to another number of each target's.

    Systematically: one random offset a target and even steps through the running sum of its
    weights.

    Args:
        count: (targets,) how many of each there shall be.
    """
    targets = len(count)
    weight = clouds.weight.astype(np.float64)
    reached = np.cumsum(weight)
    before = np.concatenate((np.zeros(1), reached))[clouds.start]
    total = np.repeat(np.diff(before), clouds.count)
    # Target i's own running sum goes from i to i + 1, so that one search serves all.
    reached = (reached - np.repeat(before[:-1], clouds.count)) / np.maximum(total, _FLAT)
    reached += clouds.owner
    reached[clouds.start[1:] - 1] = np.arange(1, targets + 1)
    start = starts_of(count)
    owner = np.repeat(np.arange(targets), count)
    place = np.arange(start[-1]) - start[owner] + random.random(targets)[owner]
    chosen = np.searchsorted(reached, owner + place / count[owner], side="left")
    chosen = np.clip(chosen, clouds.start[owner], clouds.start[owner + 1] - 1)
    even = np.repeat((1.0 / np.maximum(count, 1)).astype(np.float32), count)
    return Clouds(clouds.state[chosen], even, start)


def _sized(state: States) -> States:
    """The states with rectangles no smaller than can be measured; changed in place."""
    np.maximum(state[..., 2:4], np.float32(_LEAST_SIZE_PX), out=state[..., 2:4])
    return state


def restarted(
    clouds: Clouds,
    which: NDArray[np.bool_],
    state: Floats,
    spread: Floats,
    random: np.random.Generator,
) -> Clouds:
    """Scatter some rectangles' particles anew; there are as many as before.

    Args:
        which: (targets, rectangles). state, spread: (targets, rectangles, 6), as in `scattered`.
    """
    owner = clouds.owner
    rows = np.flatnonzero(np.asarray(which.any(axis=1))[owner])
    theirs = owner[rows]
    noise = random.standard_normal((len(rows), *clouds.state.shape[1:]), dtype=np.float32)
    fresh = _sized((state[theirs] + noise * spread[theirs]).astype(np.float32))
    moved, weight = clouds.state.copy(), clouds.weight.copy()
    moved[rows] = np.where(which[theirs][..., None], fresh, moved[rows])
    # Weights say nothing of particles that are all new; of half new ones they still do.
    whole = rows[np.asarray(which.all(axis=1))[theirs]]
    weight[whole] = 1.0 / np.maximum(clouds.count[owner[whole]], 1)
    return Clouds(moved, weight, clouds.start)
