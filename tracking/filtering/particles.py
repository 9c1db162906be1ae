"""The five steps of the particle filter but association, for all people at once."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats

Particles = NDArray[np.float32]  # (people, N, 2), metres on the floor
Weights = NDArray[np.float32]  # (people, N), each row sums to 1


def scatter(centre: Floats, spread_m: Floats, count: int, random: np.random.Generator) -> Particles:
    """Put particles at random around each centre ([Kawashita2012] step 1).

    Args:
        centre: (people, 2) m. spread_m: (people,) standard deviation per axis.
        count: particles for each person. random: where the noise comes from.
    """
    noise = random.standard_normal((len(centre), count, 2), dtype=np.float32)
    noise *= spread_m.astype(np.float32)[:, None, None]
    # An axis at a time: adding pairs of numbers takes several times as long.
    noise[..., 0] += centre[:, :1].astype(np.float32)
    noise[..., 1] += centre[:, 1:].astype(np.float32)
    return noise


def move(
    particles: Particles, step: Floats, spread_m: Floats, random: np.random.Generator
) -> Particles:
    """Move each person's particles by one step, plus a random spread ([Kawashita2012] step 2).

    Args:
        particles: (people, N, 2) m. step: (people, 2) m, velocity times time.
        spread_m: (people,) standard deviation per axis. random: where the noise comes from.
    """
    moved = scatter(step, spread_m, particles.shape[1], random)
    moved += particles
    return moved


def likelihood(distance: NDArray[np.floating], sigma: Floats) -> NDArray[np.floating]:
    """How likely a particle is at some distance from the measurement ([Kawashita2014] eq. 2).

    `L = exp(-d^2 / (2 s^2)) / (sqrt(2 pi) s)`.

    Args:
        distance: (people, N) d, m. sigma: (people,) s, m.
    """
    spread = sigma[:, None].astype(distance.dtype)
    return np.asarray(np.exp(-0.5 * (distance / spread) ** 2) / (np.sqrt(2.0 * np.pi) * spread))


def weigh(particles: Particles, measured: Floats, sigma: Floats) -> Weights:
    """Weights by the likelihood of each person's measurement, summing to 1 per person.

    The likelihood is taken relative to the nearest particle's, which leaves the weights as they
    are and keeps them from vanishing all together where a measurement is far from every particle.

    Args:
        particles: (people, N, 2) m. measured: (people, 2) m. sigma: (people,) s, m.
    """
    x = particles[..., 0] - measured[:, :1].astype(np.float32)
    y = particles[..., 1] - measured[:, 1:].astype(np.float32)
    squared = x * x
    squared += y * y
    squared -= squared.min(axis=1, keepdims=True)
    squared *= (-0.5 / sigma**2).astype(np.float32)[:, None]
    np.exp(squared, out=squared)
    squared /= squared.sum(axis=1, keepdims=True)
    return np.asarray(squared, np.float32)


def weighted_mean(particles: Particles, weights: Weights) -> Floats:
    """The estimate: (people, 2) m."""
    return np.asarray(np.einsum("pnk,pn->pk", particles, weights), np.float64)


def effective_share(weights: Weights) -> Floats:
    """The share of each person's particles that carry weight: 1 / (N sum w^2), in 1/N to 1."""
    squares = np.vecdot(weights, weights).astype(np.float64)
    return np.asarray(1.0 / (weights.shape[1] * squares))


def resample(particles: Particles, weights: Weights, random: np.random.Generator) -> Particles:
    """Multiply heavy particles and drop light ones ([Kawashita2012] step 5), systematically.

    One random offset per person and N even steps through the running sum of its weights: each
    particle is copied `N w` times, rounded up or down, and `N w` times on average.

    Args:
        particles: (people, N, k): places, or what else a state holds. weights: (people, N), rows
            sum to 1.
        random: where the offsets come from.
    """
    people, count = weights.shape
    reached = np.cumsum(weights, axis=1, dtype=np.float64)
    reached *= count / reached[:, -1:]
    reached -= random.random((people, 1))
    ends = np.ceil(reached, out=reached).astype(np.intp)
    ends[:, -1] = count
    # Each step takes the first particle that ends behind it: as many end before it. Counting them
    # takes half as long as repeating each particle as often as it is taken.
    ends += (count + 1) * np.arange(people)[:, None]
    ended = np.cumsum(np.bincount(ends.ravel(), minlength=people * (count + 1)))
    taken = ended.reshape(people, count + 1)[:, :-1]
    return particles.reshape(people * count, particles.shape[2]).take(taken, axis=0)
