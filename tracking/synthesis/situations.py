"""Fifteen hard situations under a camera that looks straight down ([Waechter2013] section 4.3).

The paper gives three sequences of five situations and how hard experts found each (table 3), not
what people do in them. Ours are as many of each difficulty, in the paper's order: from passing
with room (1) to people who squeeze through others or change places half hidden (5).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from tracking.arrays import Floats
from tracking.synthesis.itineraries import EMPTY_S
from tracking.synthesis.scenario import EVERYBODY, Moment, Role, Scenario

LONGEST_S = 10.0
"""No situation takes longer than this."""

_STRETCH = (0.95, 1.12)
_SHIFT_M = 0.07
_W, _N, _E, _S = -3.1, 2.4, 3.1, -2.4  # out of view, at each side

Points = Sequence[tuple[float, float, float]]


@dataclass(frozen=True, slots=True)
class Situation:
    """What happens.

    Attributes:
        title: in a few words.
        difficulty: 1 easy .. 5 hard, the rounded mean of the paper's three experts.
        ways: seconds, x, y of each person.
    """

    title: str
    difficulty: int
    ways: tuple[Points, ...]


def _round(centre: tuple[float, float], radius: float, degrees: ArrayLike) -> Floats:
    """Places (k, 2) on a circle."""
    angle = np.deg2rad(degrees)
    return np.array(centre) + radius * np.column_stack((np.cos(angle), np.sin(angle)))


def _timed(start_s: float, step_s: float, places: Floats) -> list[tuple[float, float, float]]:
    return [(start_s + k * step_s, float(x), float(y)) for k, (x, y) in enumerate(places)]


def _through_the_middle(corner: int) -> Points:
    """From one corner half round the middle to the opposite one."""
    start = 45.0 + 90.0 * corner
    out, back = (_round((0, 0), 3.3, [angle])[0] for angle in (start, start + 180))
    turn = _timed(2.4, 0.55, _round((0, 0), 0.6, start + np.arange(5) * 45.0))
    return [(0.0, *out), *turn, (turn[-1][0] + 2.4, *back)]


def _change_places(first_deg: float, entrance: Points, leaving: tuple[float, float]) -> Points:
    """Stand at one end of a pair, half round each other, stand, and go."""
    turn = _timed(4.4, 0.5, _round((1.25, 0.75), 0.32, first_deg + np.arange(5) * 45.0))
    end = turn[-1]
    stands = (2.7, *turn[0][1:])
    return [*entrance, stands, *turn, (end[0] + 0.7, *end[1:]), (end[0] + 3.6, *leaving)]


_SITUATIONS = (
    Situation(
        "meet, stand and go back",
        2,
        (
            [(0, _W, 0.1), (2.4, -0.4, 0.1), (5.4, -0.4, 0.1), (7.8, _W, 0.1)],
            [(0.2, _E, -0.1), (2.6, 0.4, -0.1), (5.2, 0.4, -0.1), (7.6, _E, -0.1)],
        ),
    ),
    Situation(
        "cross one behind the other",
        2,
        ([(0, _W, -0.1), (5.0, _E, 0.1)], [(1.2, 0.0, _S), (5.5, 0.1, _N)]),
    ),
    Situation(
        "walk side by side, then part",
        2,
        (
            [(0, _W, 0.35), (3.2, 0.5, 0.35), (5.4, 1.5, _N)],
            [(0, _W, -0.35), (3.2, 0.5, -0.35), (5.4, 1.5, _S)],
        ),
    ),
    Situation(
        "pass with room",
        1,
        ([(0, _W, 0.8), (5.0, _E, 0.8)], [(0.3, _E, -0.7), (5.3, _W, -0.7)]),
    ),
    Situation(
        "follow at some distance",
        1,
        ([(0, _W, 0.0), (5.2, _E, 0.3)], [(1.5, _W, 0.0), (6.7, _E, 0.3)]),
    ),
    Situation(
        "squeeze between two who stand",
        5,
        (
            [(0, _W, 0.8), (2.1, -0.58, 0.75), (7.0, -0.58, 0.75), (9.1, _W, 0.8)],
            [(0, _E, 0.8), (2.1, 0.58, 0.75), (7.2, 0.58, 0.75), (9.3, _E, 0.8)],
            [(2.4, 0.0, _S), (6.8, 0.0, _N)],
        ),
    ),
    Situation(
        "four cross half round the middle",
        5,
        tuple(_through_the_middle(corner) for corner in range(4)),
    ),
    Situation(
        "pass shoulder to shoulder, one hidden",
        3,
        ([(0, _W, 1.15), (5.0, _E, 1.15)], [(0.1, _E, 0.55), (5.1, _W, 0.55)]),
    ),
    Situation(
        "overtake closely",
        3,
        ([(0, _W, 0.3), (7.2, _E, 0.3)], [(2.2, _W, -0.3), (6.2, _E, -0.3)]),
    ),
    Situation(
        "meet, stand and go on past each other",
        2,
        (
            [(0, _W, 0.1), (2.4, -0.4, 0.3), (5.0, -0.4, 0.3), (7.8, _E, 0.45)],
            [(0.2, _E, -0.1), (2.6, 0.4, -0.3), (5.1, 0.4, -0.3), (7.9, _W, -0.45)],
        ),
    ),
    Situation(
        "three stand together and leave other ways",
        4,
        (
            [(0, _W, 0.1), (2.4, -0.38, 0.0), (6.0, -0.38, 0.0), (8.2, -1.3, _S)],
            [(0.3, _E, 0.5), (2.6, 0.19, 0.33), (6.1, 0.19, 0.33), (8.0, -0.2, _N)],
            [(0.6, 0.3, _S), (2.7, 0.19, -0.33), (5.8, 0.19, -0.33), (8.2, _E, -0.4)],
        ),
    ),
    Situation(
        "change places at the edge, one hidden",
        5,
        (
            _change_places(33.0, [(0.3, _E, 1.1)], (_W, 0.3)),
            _change_places(213.0, [(0.0, _W, 0.2)], (_E, 1.1)),
        ),
    ),
    Situation(
        "three cross in the middle, one after the other",
        3,
        (
            [(0, _W, 0.0), (5.0, _E, 0.0)],
            [(1.2, 0.0, _S), (5.5, 0.0, _N)],
            [(1.8, _E, 1.9), (7.2, _W, -1.9)],
        ),
    ),
    Situation(
        "walk round one who stands",
        3,
        (
            [(0, 0.1, _N), (2.2, 0.1, 0.2), (7.6, 0.1, 0.2), (9.8, 0.6, _S)],
            [
                (0.9, _W, 0.2),
                *_timed(3.1, 0.5, _round((0.1, 0.2), 0.66, 180 + np.arange(7) * 45.0)),
                (7.8, -1.0, _N),
            ],
        ),
    ),
    Situation(
        "stand hidden while others pass",
        4,
        (
            [(0, _W, -1.0), (1.5, -1.5, -0.95), (7.0, -1.5, -0.95), (8.6, _W, -1.0)],
            [(0.2, -0.6, _S), (2.2, -0.93, -0.62), (6.4, -0.93, -0.62), (9.4, _E, -0.4)],
            [(1.8, _W, 0.15), (7.0, _E, -0.2)],
        ),
    ),
)

COUNT = len(_SITUATIONS)


def situation(number: int, seed: int) -> Scenario:
    """One situation, from 1; another seed takes place elsewhere, mirrored, faster or slower."""
    asked = _SITUATIONS[number - 1]
    rng = np.random.default_rng((seed, 21, number))
    lasts_s = max(way[-1][0] for way in asked.ways)
    stretch = min(rng.uniform(*_STRETCH), LONGEST_S / lasts_s)
    mirror, shift = rng.choice((-1.0, 1.0), 2), rng.uniform(-_SHIFT_M, _SHIFT_M, 2)
    roles = []
    for way in asked.ways:
        points = np.array(way, float)
        points[:, 0] = EMPTY_S + points[:, 0] * stretch
        points[:, 1:] = points[:, 1:] * mirror + shift
        roles.append(Role(points))
    start, end = min(r.points[0, 0] for r in roles), max(r.points[-1, 0] for r in roles)
    moment = Moment(float(start), float(end), EVERYBODY, "situation", asked.title, asked.difficulty)
    return Scenario(tuple(roles), (moment,))


def situations(seed: int) -> Scenario:
    """All of them in turn, each by people of its own."""
    roles: list[Role] = []
    moments = []
    for number in range(1, COUNT + 1):
        offset_s = (number - 1) * (LONGEST_S + EMPTY_S)
        one = situation(number, seed)
        roles += [role.later(offset_s) for role in one.roles]
        for moment in one.moments:
            start, end = moment.start_s + offset_s, moment.end_s + offset_s
            moments.append(replace(moment, start_s=start, end_s=end))
    return Scenario(tuple(roles), tuple(moments))


def people_in(number: int) -> int:
    """How many take part in a situation."""
    return len(_SITUATIONS[number - 1].ways)
