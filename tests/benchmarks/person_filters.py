"""A particle filter for each person, one after the other, as a textbook has it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_ELAPSED_S, _SPREAD_M, _SIGMA_M = 0.05, 0.06, 0.15
_GATE_M = 0.9


@dataclass(frozen=True, slots=True)
class Seen:
    """Regions of a frame: places (k, 2) m on the floor, colours (k, bins) histograms."""

    place: Floats
    colour: NDArray[np.float32]


class PersonFilter:
    """Follows one person: predict, weigh by place and colour, estimate, resample.

    The particles of the one person are arrays: a loop over single particles would cost a hundred
    times as much, and nobody with NumPy at hand writes one.
    """

    def __init__(self, place: Floats, colour: NDArray[np.float32], particles: int) -> None:
        self._random = np.random.default_rng(0)
        self._particles = place + self._random.normal(0.0, 0.25, (particles, 2))
        self._velocity = np.zeros(2)
        self._colour = colour
        self.place = place

    def step(self, seen: Seen) -> None:
        """One frame: of the regions near by, the one most like this person."""
        count = len(self._particles)
        self._particles += self._velocity * _ELAPSED_S
        self._particles += self._random.normal(0.0, _SPREAD_M, (count, 2))
        weight = np.full(count, 1.0 / count)
        away = np.linalg.norm(seen.place - self.place, axis=1)
        if len(away) and away.min() < _GATE_M:
            alike = np.sqrt(self._colour * seen.colour).sum(axis=1)
            cost = 2.0 * away + np.sqrt(np.clip(1.0 - alike, 0.0, 1.0))
            k = int(np.where(away < _GATE_M, cost, np.inf).argmin())
            weight = self._weights(seen.place[k])
            self._colour = 0.97 * self._colour + 0.03 * seen.colour[k]
        before, self.place = self.place, weight @ self._particles
        self._velocity += 0.2 * ((self.place - before) / _ELAPSED_S - self._velocity)
        steps = (np.arange(count) + self._random.random()) / count
        chosen = np.searchsorted(np.cumsum(weight), steps).clip(max=count - 1)
        self._particles = self._particles[chosen]

    def _weights(self, place: Floats) -> Floats:
        squared = ((self._particles - place) ** 2).sum(axis=1)
        weight = np.exp(-0.5 * (squared - squared.min()) / _SIGMA_M**2)
        return np.asarray(weight / weight.sum())


class PersonFilters:
    """As many filters as there are people.

    Args:
        particles: of each.
    """

    def __init__(self, particles: int) -> None:
        self._particles = particles
        self._filters: list[PersonFilter] = []

    def step(self, seen: Seen, people: int) -> list[Floats]:
        """Where each person is; newcomers begin at a region, leavers are those followed longest."""
        del self._filters[: max(0, len(self._filters) - people)]
        for k in range(min(people - len(self._filters), len(seen.place))):
            self._filters.append(PersonFilter(seen.place[k], seen.colour[k], self._particles))
        for one in self._filters:
            one.step(seen)
        return [one.place for one in self._filters]
