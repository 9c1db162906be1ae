"""People on marked spots under a camera that looks straight down ([Waechter2013] section 4.2).

The paper shows its spots in a picture without saying where they are; ours are five pairs in five
directions from the middle. At the outer ones (1) people are seen from the hips or the chest down
only, and whoever stands at the inner one (2) of a pair hides part of the one at the outer.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise
from types import MappingProxyType

import numpy as np

from tracking.synthesis.itineraries import EMPTY_S
from tracking.synthesis.scenario import Moment, Role, Scenario

MARKS_M: Mapping[str, tuple[float, float]] = MappingProxyType(
    {
        "A1": (-1.55, 1.00),
        "B1": (0.10, 1.25),
        "C1": (1.60, 0.92),
        "D1": (1.40, -1.05),
        "E1": (-1.30, -1.10),
        "A2": (-1.00, 0.62),
        "B2": (0.06, 0.62),
        "C2": (1.00, 0.56),
        "D2": (0.80, -0.60),
        "E2": (-0.65, -0.52),
    }
)
"""World x, y of the marks, in the order in which the paper's people walked them."""

_OUTER, _INNER = tuple(MARKS_M)[:5], tuple(MARKS_M)[5:]
_ENTRANCE_M, _EXIT_M = (-2.95, 1.05), (-0.6, -2.4)
_STAND_S, _TURN_S = 7.0, 0.5
_SETTLED_S, _BEFORE_GOING_S = 0.8, 1.2  # nobody moves or turns between these
_STROLL_M_S, _WALK_M_S = 1.0, 1.15


def standing() -> Scenario:
    """One person stands on each mark in turn."""
    way = _Way(0, _ENTRANCE_M, _STROLL_M_S)
    for mark in MARKS_M:
        way.stand(mark)
    return Scenario((way.leave(_EXIT_M),), tuple(way.moments))


def walking() -> Scenario:
    """One person walks straight from mark to mark."""
    way = _Way(0, _ENTRANCE_M, _WALK_M_S)
    marks = tuple(MARKS_M)
    way.go(MARKS_M[marks[0]])
    for mark, following in pairwise(marks):
        way.stay(_TURN_S)
        way.walk(mark, following)
    return Scenario((way.leave(_EXIT_M),), tuple(way.moments))


def pairs() -> Scenario:
    """Two people stand on both marks of each pair, one in front of the other."""
    outer = _Way(0, _ENTRANCE_M, _STROLL_M_S)
    inner = _Way(1, (-2.95, 0.30), _STROLL_M_S)
    for far, near in zip(_OUTER, _INNER, strict=True):
        together = max(outer.arrival_s(MARKS_M[far]), inner.arrival_s(MARKS_M[near]))
        outer.stand(far, together)
        inner.stand(near, together)
    roles = outer.leave((-2.95, -1.30)), inner.leave((0.2, -2.4))
    return Scenario(roles, (*outer.moments, *inner.moments))


class _Way:
    """A way that is put together step by step."""

    def __init__(self, person: int, entrance: tuple[float, float], speed_m_s: float) -> None:
        self._person, self._speed_m_s = person, speed_m_s
        self._points = [(EMPTY_S, *entrance)]
        self.moments: list[Moment] = []

    def arrival_s(self, place: tuple[float, float]) -> float:
        now, x, y = self._points[-1]
        return now + float(np.hypot(place[0] - x, place[1] - y)) / self._speed_m_s

    def go(self, place: tuple[float, float], arrival_s: float | None = None) -> None:
        self._points.append((arrival_s or self.arrival_s(place), *place))

    def stay(self, seconds: float) -> None:
        now, x, y = self._points[-1]
        self._points.append((now + seconds, x, y))

    def stand(self, mark: str, arrival_s: float | None = None) -> None:
        self.go(MARKS_M[mark], arrival_s)
        start = self._points[-1][0]
        self.stay(_STAND_S)
        still = start + _SETTLED_S, start + _STAND_S - _BEFORE_GOING_S
        self.moments.append(Moment(*still, self._person, "stands", mark))

    def walk(self, mark: str, following: str) -> None:
        start = self._points[-1][0]
        self.go(MARKS_M[following])
        end = self._points[-1][0]
        self.moments.append(Moment(start, end, self._person, "walks", f"{mark}-{following}"))

    def leave(self, exit_m: tuple[float, float]) -> Role:
        self.go(exit_m)
        return Role(np.array(self._points))
