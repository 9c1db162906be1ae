"""Who walked, and where: of all the ways tracklets suggest those that explain them all."""

from __future__ import annotations

import heapq
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.flow.bundles import Bundle, Way, bundle_of
from tracking.trackers.flow.chains import Chains, Rows
from tracking.trackers.flow.floor import Floor, sight_axes
from tracking.trackers.flow.foot_fit import feet_cost, ratios
from tracking.trackers.flow.ways import reaching, refitted

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]

_SEED_S = 0.6
"""Tracklets followed for less begin no way."""
_SEED_HEIGHTS_M = np.arange(0.1, 1.75, 0.05)
_PACE_M_S, _PACE_ERROR = 1.2, 0.35
_HELD_M, _HELD_COSTLIEST = 0.06, 12.0
_LED_S, _LED_TO_CHOOSE_S = 0.8, 0.3
_ROUNDS, _AGAIN = 14, 4
_LEAST_ROWS_S, _LEAST_S, _LEAST_WAY_M = 4.0, 0.8, 0.8
"""Seconds of tracklets, together, that make a person; how long and how far a way is at least."""
_LEAST_SHARE = 0.4
"""Of what a way explains, that nobody else explains already."""
_TWIN_ACROSS_M, _TWIN_ACROSS, _TWIN_ALONG, _TWIN_SHARE = 0.3, 0.02, 0.08, 0.5
"""Nobody walks so near to another, across the sight (in m, and as a share of the distance if that
is more) and along it (as a share of it), for as large a share of the time."""
_FAIR = 3.0
"""Misfit up to which a tracklet counts in full."""


@dataclass(frozen=True, slots=True, eq=False)
class Walk:
    """Somebody's way, or a piece of it, with the tracklets that prove it.

    Attributes:
        way: where. chain: the tracklets that nobody chosen before explains.
    """

    way: Way
    chain: Rows


class Chooser:
    """Finds the ways people walked in a finished run, by its tracklets.

    Beyond [Yoneji2013], which gathers tracklets frame by frame: a person is a way over the floor
    that explains, as one body, tracklets over a longer time. Candidates grow from single
    tracklets, at the height at which somebody held them or at which they go at a usual pace, and
    from the pieces of ways that were found frame by frame. Of these the one that explains most is
    taken, then the one that explains most of the rest, until what is left is no person.

    Args:
        chains: the run's tracklets. floor: under the camera. fps: frames a second.
    """

    def __init__(self, chains: Chains, floor: Floor, fps: float) -> None:
        self._chains = chains
        self._floor = floor
        self._fps = fps
        order = np.argsort(chains.chain, kind="stable")
        self._rows = np.split(order, np.cumsum(chains.length)[:-1])

    def walks(self, found: Sequence[Way]) -> list[Walk]:
        """The ways walked.

        Args:
            found: pieces of ways that were found frame by frame.
        """
        ways = [*self._grown(), *found]
        again = [self._again(way, _AGAIN) for way in ways]
        at_once = [self._again(way, 1) for way in found]
        likely = [way for way in (*again, *at_once) if way is not None and self._goes(way)]
        return without_twins(self._chosen([*ways, *likely]))

    def _grown(self) -> list[Way]:
        """Ways grown from the longest tracklets, each of what those before have left."""
        chains, ways = self._chains, []
        free = np.ones(len(chains), bool)
        for seed in np.argsort(-chains.length, kind="stable"):
            if chains.length[seed] < _SEED_S * self._fps:
                break
            if not free[seed]:
                continue
            free[seed] = False
            grown = self._grown_from(int(seed), free)
            if grown is not None and self._goes(grown[0]):
                free[grown[1]] = False
                ways.append(grown[0])
        return ways

    def _grown_from(self, seed: int, free: Flags) -> tuple[Way, Rows] | None:
        """The way of a tracklet, with all those that move with it; None: nobody's."""
        free = free.copy()
        free[seed] = True
        way, before = self._way_of(seed), None
        middle = int(self._chains.first[seed] + self._chains.last[seed]) // 2
        for step in range(_ROUNDS):
            near = bundle_of(way, self._chains, self._floor, self._fps, _LED_S, free)
            kept = near.alike | (near.chain == seed)
            members = near.chain[kept]
            if step > _AGAIN and before is not None and np.array_equal(before, members):
                break
            before = members
            fitted = self._fitted(near.only(kept), middle)
            if fitted is None:
                return None
            way = fitted
        enough = self._chains.length[members].sum() >= _LEAST_ROWS_S * self._fps
        return (way, members) if enough else None

    def _again(self, way: Way, times: int) -> Way | None:
        """A way with all its tracklets, whosever they may be."""
        middle = way.first + len(way.place) // 2
        for _ in range(times):
            near = bundle_of(way, self._chains, self._floor, self._fps, _LED_S)
            fitted = self._fitted(near.only(near.alike), middle)
            if fitted is None:
                return None
            way = fitted
        return way

    def _fitted(self, bundle: Bundle, middle: int) -> Way | None:
        """The way a bundle says, as far as it reaches from about a frame; None: not there."""
        if len(bundle.rows) < _LEAST_ROWS_S * self._fps / 3:
            return None
        way, count = refitted(bundle, self._chains, self._floor, self._fps)
        reaches = reaching(way, count, self._floor, self._fps)
        inside = np.flatnonzero(reaches)
        if not len(inside):
            return None
        at = int(inside[np.abs(inside - (middle - way.first)).argmin()])
        if abs(at - (middle - way.first)) > _LEAST_S * self._fps:
            return None
        gaps = np.flatnonzero(~reaches)
        start = int(gaps[gaps < at].max(initial=-1)) + 1
        stop = int(gaps[gaps > at].min(initial=len(reaches)))
        return way.cut(start, stop) if stop - start > 3 else None

    def _way_of(self, seed: int) -> Way:
        """The way of one tracklet, as high over the floor as is likeliest."""
        rows = self._rows[seed]
        chains, floor = self._chains, self._floor
        slope, frame = chains.slope[rows], chains.frame[rows]
        time_s = (frame - frame.mean()) / self._fps
        pace = np.hypot(*(time_s @ slope / (time_s @ time_s))) * (floor.camera_m - _SEED_HEIGHTS_M)
        cost = (np.log(np.maximum(np.abs(pace), 0.05) / _PACE_M_S) / _PACE_ERROR) ** 2
        held = chains.held_at[rows]
        known = np.isfinite(held[:, 0])
        if known.sum() >= 3:
            height = np.median(floor.heights(slope[known], held[known]))
            off = ((_SEED_HEIGHTS_M - height) / _HELD_M) ** 2
            cost = cost + np.minimum(off, _HELD_COSTLIEST)
        away = np.hypot(*slope.T)[:, None] * (floor.camera_m - _SEED_HEIGHTS_M)
        cost = cost + feet_cost(ratios(chains.feet_m[rows, None], away))
        drop = floor.camera_m - _SEED_HEIGHTS_M[cost.argmin()]
        every = np.arange(frame[0], frame[-1] + 1)
        place = [np.interp(every, frame, slope[:, axis] * drop) for axis in (0, 1)]
        return Way(int(frame[0]), np.stack(place, axis=1))

    def _goes(self, way: Way) -> bool:
        """Whether a way is long enough to be somebody's."""
        far = np.hypot(*(way.place[-1] - way.place[0])) >= _LEAST_WAY_M
        return bool(far and len(way.place) >= _LEAST_S * self._fps)

    def _chosen(self, ways: Sequence[Way]) -> list[Walk]:
        """The ways that explain most, one after the other, each of what is left."""
        explained = [self._explained(way) for way in ways]
        total = [float(rows.sum()) for _, rows in explained]
        left = np.ones(len(self._chains), bool)
        waiting = [(-rows, number) for number, rows in enumerate(total)]
        heapq.heapify(waiting)
        walks = []
        while waiting:
            hoped, number = heapq.heappop(waiting)
            chain, rows = explained[number]
            new = float(rows[left[chain]].sum())
            if new < max(_LEAST_ROWS_S * self._fps, _LEAST_SHARE * total[number]):
                continue  # it only becomes less
            if new < -hoped - 1e-9:
                heapq.heappush(waiting, (-new, number))
                continue
            walks.append(Walk(ways[number], chain[left[chain]]))
            left[chain] = False
        return walks

    def _explained(self, way: Way) -> tuple[Rows, Floats]:
        """The tracklets a way explains, and for how many frames, less where they suit it badly."""
        near = bundle_of(way, self._chains, self._floor, self._fps, _LED_TO_CHOOSE_S)
        well = np.clip(1.0 + _FAIR - near.misfit, 0.0, 1.0) * near.frames
        return near.chain[near.alike], well[near.alike]


def without_twins(walks: Sequence[Walk]) -> list[Walk]:
    """Of ways too near to each other to be two people's the longest, with all their tracklets."""
    kept: list[Walk] = []
    for walk in sorted(walks, key=lambda one: -len(one.way.place)):
        for number, other in enumerate(kept):
            if _are_twins(walk.way, other.way):
                kept[number] = Walk(other.way, np.concatenate((other.chain, walk.chain)))
                break
        else:
            kept.append(walk)
    return sorted(kept, key=lambda one: one.way.first)


def _are_twins(short: Way, long: Way) -> bool:
    """Whether the shorter way leads where the longer one does, at the same time."""
    start, stop = max(short.first, long.first), min(short.stop, long.stop)
    if stop - start < max(_TWIN_SHARE * len(short.place), 2):
        return False
    one, other = (way.place[start - way.first : stop - way.first] for way in (short, long))
    across = np.abs(((one - other) * sight_axes(other)[:, 1]).sum(axis=1))
    away = np.hypot(*other.T)
    across /= np.maximum(_TWIN_ACROSS * away, _TWIN_ACROSS_M)
    farther = np.abs(np.log(np.hypot(*one.T) / away))
    near = np.median(across) < 1.0 and np.median(farther) < _TWIN_ALONG
    return bool(near and (one[-1] - one[0]) @ (other[-1] - other[0]) > 0)
