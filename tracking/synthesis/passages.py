"""Who walks through a passage, when and which way ([Yoneji2013])."""

from __future__ import annotations

import numpy as np

from tracking.synthesis.itineraries import EMPTY_S, Itinerary
from tracking.synthesis.specs import PassageSpec

_LAST_S = 8.0  # nobody sets off so late that the way out would be cut off
_BUNCH_S = 1.2  # spread of those who come at once
_ON_THEIR_RIGHT = 0.85
_OFF_THE_WALL_M = 0.5
_BEHIND_M = (0.7, 2.3)  # how far behind the passage's far end people come along
_BESIDE_M = (1.6, 3.0)  # how far beside it they set off
_OUT_OF_VIEW_M = (3.6, 4.4)


def plan_passage(
    passage: PassageSpec, people: int, seconds: float, rng: np.random.Generator
) -> tuple[Itinerary, ...]:
    """Itineraries of all people of a recording, by the time they set off."""
    return tuple(_plan(passage, start, rng) for start in _starts(passage, people, seconds, rng))


def _starts(
    passage: PassageSpec, people: int, seconds: float, rng: np.random.Generator
) -> list[float]:
    """Times to set off: bunches, evenly spread with some chance."""
    sizes: list[int] = []
    while sum(sizes) < people:
        sizes.append(int(rng.integers(passage.bunches[0], passage.bunches[1] + 1)))
    slot_s = max(seconds - _LAST_S - EMPTY_S, 0.0) / max(len(sizes), 1)
    heads = EMPTY_S + (np.arange(len(sizes)) + rng.uniform(0.0, 0.6, len(sizes))) * slot_s
    heads[:1] = EMPTY_S
    starts = np.repeat(heads, sizes)[:people]
    return sorted((starts + rng.uniform(0.0, _BUNCH_S, people)).tolist())


def _plan(passage: PassageSpec, start_s: float, rng: np.random.Generator) -> Itinerary:
    towards = not passage.both_ways or bool(rng.random() < 0.5)
    half = passage.half_width_m
    across = _across(passage, towards, rng)
    far_side, near_side = rng.choice((-1.0, 1.0), 2)
    behind = passage.far_m + rng.uniform(*_BEHIND_M)
    ahead = passage.near_m - rng.uniform(0.9, 1.5)
    way = np.array(
        [
            (far_side * (half + rng.uniform(*_BESIDE_M)), behind),
            (across, passage.far_m + 0.4),
            (across + rng.uniform(-0.2, 0.2), (passage.near_m + passage.far_m) / 2),
            (across, passage.near_m - 0.2),
            (near_side * rng.uniform(*_OUT_OF_VIEW_M), ahead),
        ]
    )
    speed = float(np.clip(rng.normal(1.2, 0.15), 0.85, 1.55))
    return Itinerary(start_s, way if towards else way[::-1].copy(), np.zeros(len(way)), speed)


def _across(passage: PassageSpec, towards: bool, rng: np.random.Generator) -> float:
    """x in the passage; who has somebody coming keeps to the right as a rule."""
    most = passage.half_width_m - _OFF_THE_WALL_M
    if not passage.both_ways or rng.random() > _ON_THEIR_RIGHT:
        return float(rng.uniform(-most, most))
    right = -1.0 if towards else 1.0
    return float(right * rng.uniform(0.15, most))
