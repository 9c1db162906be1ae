"""Who walked, and where: of all the trajectories tracklets suggest those that explain them all."""

from __future__ import annotations

import heapq
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.flow.bundles import Bundle, Trajectory, gather_bundle
from tracking.trackers.flow.chains import Rows, TrackletChains
from tracking.trackers.flow.explained_rows import ExplainedRows, cover_rows, explained_rows
from tracking.trackers.flow.floor import Floor, sight_axes
from tracking.trackers.flow.foot_fit import feet_cost, ratios
from tracking.trackers.flow.trajectory_fit import is_supported, refit

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]

_SEED_S = 0.6
"""Tracklets followed for less begin no trajectory."""
_SEED_HEIGHTS_M = np.arange(0.1, 1.75, 0.05)
_PACE_M_S, _PACE_ERROR = 1.2, 0.35
_HELD_M, _HELD_COSTLIEST = 0.06, 12.0
_LED_S = 0.8
_ROUNDS, _AGAIN = 14, 4
_LEAST_ROWS_S, _LEAST_S, _LEAST_WAY_M = 4.0, 0.8, 0.8
"""Seconds of tracklets, together, that make a person; how long and how far a trajectory is at
least."""
_LEAST_SHARE = 0.4
"""Of what a trajectory explains, that nobody else explains already."""
_TWIN_ACROSS_M, _TWIN_ACROSS, _TWIN_ALONG, _TWIN_SHARE = 0.4, 0.02, 0.08, 0.5
"""Nobody walks so near to another, across the sight (in m, and as a share of the distance if that
is more) and along it (as a share of it), for as large a share of the time."""


@dataclass(frozen=True, slots=True, eq=False)
class WalkerTrajectory:
    """Somebody's trajectory, or a piece of it, with the tracklets that prove it.

    Attributes:
        trajectory: where. chain: the tracklets that nobody chosen before explains.
    """

    trajectory: Trajectory
    chain: Rows


class TrajectorySelector:
    """Finds the trajectories people walked in a finished run, by its tracklets.

    Beyond [Yoneji2013], which gathers tracklets frame by frame: a person is a trajectory over the
    floor that explains, as one body, tracklets over a longer time. Candidates grow from single
    tracklets, at the height at which somebody held them or at which they go at a usual pace, and
    from the pieces of trajectories that were found frame by frame. Of these the one that explains
    most is taken, then the one that explains most of the rest, until what is left is no person.

    Args:
        chains: the run's tracklets. floor: under the camera. fps: frames a second.
    """

    def __init__(self, chains: TrackletChains, floor: Floor, fps: float) -> None:
        self._chains = chains
        self._floor = floor
        self._fps = fps
        order = np.argsort(chains.chain, kind="stable")
        self._rows = np.split(order, np.cumsum(chains.length)[:-1])
        self._left = np.ones(len(chains), bool)
        self._front_m = np.full(len(chains.row), np.inf)

    def select(self, found: Sequence[Trajectory]) -> list[WalkerTrajectory]:
        """The trajectories walked.

        Args:
            found: pieces of trajectories that were found frame by frame.
        """
        trajectories = [*self._grow_all(), *found]
        again = [self._refine(trajectory, _AGAIN) for trajectory in trajectories]
        at_once = [self._refine(trajectory, 1) for trajectory in found]
        likely = [
            trajectory
            for trajectory in (*again, *at_once)
            if trajectory is not None and self._is_plausible(trajectory)
        ]
        return remove_twins(self._choose([*trajectories, *likely]))

    def is_person(self, trajectory: Trajectory) -> bool:
        """Whether a trajectory has enough, and a head, that those selected do not explain.

        One near which nothing was followed may be that of somebody who stands still.
        """
        own = self._explained(trajectory)
        every = own.count(np.ones_like(self._left), np.full_like(self._front_m, np.inf))
        new = own.count(self._left, self._front_m)
        return new >= _LEAST_SHARE * every and own.has_head(self._left, self._front_m)

    def _explained(self, trajectory: Trajectory) -> ExplainedRows:
        return explained_rows(trajectory, self._chains, self._floor, self._fps)

    def _grow_all(self) -> list[Trajectory]:
        """Trajectories grown from the longest tracklets, each of what those before have left."""
        chains, trajectories = self._chains, []
        free = np.ones(len(chains), bool)
        for seed in np.argsort(-chains.length, kind="stable"):
            if chains.length[seed] < _SEED_S * self._fps:
                break
            if not free[seed]:
                continue
            free[seed] = False
            grown = self._grow(int(seed), free)
            if grown is not None and self._is_plausible(grown[0]):
                free[grown[1]] = False
                trajectories.append(grown[0])
        return trajectories

    def _grow(self, seed: int, free: Flags) -> tuple[Trajectory, Rows] | None:
        """The trajectory of a tracklet, with all those that move with it; None: nobody's."""
        free = free.copy()
        free[seed] = True
        trajectory, before = self._trajectory_of(seed), None
        middle = int(self._chains.first[seed] + self._chains.last[seed]) // 2
        for step in range(_ROUNDS):
            near = gather_bundle(trajectory, self._chains, self._floor, self._fps, _LED_S, free)
            kept = near.alike | (near.chain == seed)
            members = near.chain[kept]
            if step > _AGAIN and before is not None and np.array_equal(before, members):
                break
            before = members
            fitted = self._fit(near.select(kept), middle)
            if fitted is None:
                return None
            trajectory = fitted
        enough = self._chains.length[members].sum() >= _LEAST_ROWS_S * self._fps
        return (trajectory, members) if enough else None

    def _refine(self, trajectory: Trajectory, times: int) -> Trajectory | None:
        """A trajectory with all its tracklets, whosever they may be."""
        middle = trajectory.first + len(trajectory.place) // 2
        for _ in range(times):
            near = gather_bundle(trajectory, self._chains, self._floor, self._fps, _LED_S)
            fitted = self._fit(near.select(near.alike), middle)
            if fitted is None:
                return None
            trajectory = fitted
        return trajectory

    def _fit(self, bundle: Bundle, middle: int) -> Trajectory | None:
        """The trajectory of a bundle, as far as it reaches from about a frame; None: not there."""
        if len(bundle.rows) < _LEAST_ROWS_S * self._fps / 3:
            return None
        trajectory, count = refit(bundle, self._chains, self._floor, self._fps)
        reaches = is_supported(trajectory, count, self._floor, self._fps)
        inside = np.flatnonzero(reaches)
        if not len(inside):
            return None
        at = int(inside[np.abs(inside - (middle - trajectory.first)).argmin()])
        if abs(at - (middle - trajectory.first)) > _LEAST_S * self._fps:
            return None
        gaps = np.flatnonzero(~reaches)
        start = int(gaps[gaps < at].max(initial=-1)) + 1
        stop = int(gaps[gaps > at].min(initial=len(reaches)))
        return trajectory.cut(start, stop) if stop - start > 3 else None

    def _trajectory_of(self, seed: int) -> Trajectory:
        """The trajectory of one tracklet, as high over the floor as is likeliest."""
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
        return Trajectory(int(frame[0]), np.stack(place, axis=1))

    def _is_plausible(self, trajectory: Trajectory) -> bool:
        """Whether a trajectory is long enough to be somebody's."""
        far = np.hypot(*(trajectory.place[-1] - trajectory.place[0])) >= _LEAST_WAY_M
        return bool(far and len(trajectory.place) >= _LEAST_S * self._fps)

    def _choose(self, trajectories: Sequence[Trajectory]) -> list[WalkerTrajectory]:
        """The trajectories that explain most, one after the other, each of what is left."""
        explained = [self._explained(trajectory) for trajectory in trajectories]
        left, front_m = self._left, self._front_m
        total = [one.count(left, front_m) for one in explained]
        waiting = [(-rows, number) for number, rows in enumerate(total)]
        heapq.heapify(waiting)
        walks = []
        while waiting:
            hoped, number = heapq.heappop(waiting)
            chain = explained[number].chain
            new = explained[number].count(left, front_m)
            if new < max(_LEAST_ROWS_S * self._fps, _LEAST_SHARE * total[number]):
                continue  # it only becomes less
            if new < -hoped - 1e-9:
                heapq.heappush(waiting, (-new, number))
                continue
            if not explained[number].has_head(left, front_m):
                continue
            walks.append(WalkerTrajectory(trajectories[number], chain[left[chain]]))
            left[chain] = False
            cover_rows(front_m, trajectories[number], self._chains, self._floor)
        return walks


def remove_twins(walks: Sequence[WalkerTrajectory]) -> list[WalkerTrajectory]:
    """Of trajectories too near to be two people's the longest, with all their tracklets."""
    kept: list[WalkerTrajectory] = []
    for walker in sorted(walks, key=lambda one: -len(one.trajectory.place)):
        for number, other in enumerate(kept):
            if _are_twins(walker.trajectory, other.trajectory):
                kept[number] = WalkerTrajectory(
                    other.trajectory, np.concatenate((other.chain, walker.chain))
                )
                break
        else:
            kept.append(walker)
    return sorted(kept, key=lambda one: one.trajectory.first)


def _are_twins(short: Trajectory, long: Trajectory) -> bool:
    """Whether the shorter trajectory leads where the longer one does, at the same time."""
    start, stop = max(short.first, long.first), min(short.stop, long.stop)
    if stop - start < max(_TWIN_SHARE * len(short.place), 2):
        return False
    one, other = (
        trajectory.place[start - trajectory.first : stop - trajectory.first]
        for trajectory in (short, long)
    )
    across = np.abs(((one - other) * sight_axes(other)[:, 1]).sum(axis=1))
    away = np.hypot(*other.T)
    across /= np.maximum(_TWIN_ACROSS * away, _TWIN_ACROSS_M)
    farther = np.abs(np.log(np.hypot(*one.T) / away))
    near = np.median(across) < 1.0 and np.median(farther) < _TWIN_ALONG
    return bool(near and (one[-1] - one[0]) @ (other[-1] - other[0]) > 0)
