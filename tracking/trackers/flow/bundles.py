"""Bundles: the tracklets that move as the body of somebody walking along a trajectory would."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.flow.chains import Rows, TrackletChains
from tracking.trackers.flow.floor import Floor, sight_axes
from tracking.trackers.flow.foot_fit import feet_misfit, ratios

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]

_ALIKE = 4.0
"""Mean squared misfit of a tracklet that may belong to somebody."""
_HEIGHT_M, _ASIDE_M = 0.045, 0.07
"""How far a point of a body moves up and down, and sideways, beside its usual place."""
_WAY_M, _UNSEEN_WAY_M_S = 0.06, 0.15
"""How far the trajectory itself may be off along the sight, and the more the longer it is only
led."""
_OFF_AXIS_M = 0.14
"""How far from the middle points of bodies are found."""
_HIGHEST_M, _HEADROOM_M, _FLOOR_M = 1.72, 0.06, 0.05
_TREND_M, _SHORT_TREND_MS = 0.03, 0.03
"""How far a point may seem to rise, or drift aside, in all: more while it is followed shortly."""
_LEAST_TREND_S = 0.4
_WIDEST_M, _LOW_M, _HIGH_M = 0.5, -0.3, 2.1
"""What lies farther off is not looked at."""
_LEAST_SHARE = 0.5
"""Of a tracklet's frames that must lie on the trajectory."""
_LED_BY_S = 1.5


@dataclass(frozen=True, slots=True, eq=False)
class Trajectory:
    """Where somebody walked.

    Attributes:
        first: the first frame. place: (t, 2) m, a row a frame.
    """

    first: int
    place: Floats

    @property
    def stop(self) -> int:
        """The frame after the last."""
        return self.first + len(self.place)

    def frames_off(self, frame: NDArray[np.int64]) -> NDArray[np.int64]:
        """(n,) how many frames before its first or after its last each is; 0 within."""
        return np.maximum(np.maximum(self.first - frame, frame - self.stop + 1), 0)

    def cut(self, start: int, stop: int) -> Trajectory:
        """The rows `start` to `stop`."""
        return Trajectory(self.first + start, self.place[start:stop])

    def extended(self, frames: int, stop: int, fps: float) -> Trajectory:
        """Led back and on straight for so many frames, between frame 0 and `stop`."""
        near = min(len(self.place), max(2, round(_LED_BY_S * fps)))
        before, after = min(frames, self.first), max(min(frames, stop - self.stop), 0)
        back = self.place[0] - np.arange(before, 0, -1)[:, None] * _pace(self.place[:near])
        on = self.place[-1] + np.arange(1, after + 1)[:, None] * _pace(self.place[-near:])
        return Trajectory(self.first - before, np.concatenate((back, self.place, on)))


def _pace(place: Floats) -> Floats:
    """(2,) m a frame of the straight line through places."""
    if len(place) < 2:
        return np.zeros(2)
    off = np.arange(len(place)) - (len(place) - 1) / 2
    return np.asarray(off @ place / (off @ off))


@dataclass(frozen=True, slots=True, eq=False)
class Bundle:
    """Tracklets near a trajectory.

    Attributes:
        rows: (k,) of the chains. number: (k,) of their tracklets among these m.
        place: (k, 2) m where the walker is. across: (k, 2) unit vectors, across the sight.
        chain: (m,) the tracklets. frames: (m,) in how many frames they lie near the trajectory.
        z_m, aside_m: (m,) their places in the body.
        misfit: (m,) squared, in standard deviations. alike: (m,) whether they may be the walker's.
    """

    rows: Rows
    number: Rows
    place: Floats
    across: Floats
    chain: Rows
    frames: Rows
    z_m: Floats
    aside_m: Floats
    misfit: Floats
    alike: Flags

    def select(self, kept: Flags) -> Bundle:
        """With the rows of some of the tracklets; all the tracklets stay in the list."""
        rows = kept[self.number]
        return Bundle(
            self.rows[rows],
            self.number[rows],
            self.place[rows],
            self.across[rows],
            *(self.chain, self.frames, self.z_m, self.aside_m, self.misfit, self.alike),
        )


def gather_bundle(
    trajectory: Trajectory,
    chains: TrackletChains,
    floor: Floor,
    fps: float,
    led_s: float,
    free: Flags | None = None,
) -> Bundle:
    """The tracklets near a trajectory, and how well each suits a body that walks it.

    A point of a body keeps its height and its distance from the body's axis. Of one who walks
    elsewhere, or the same behind or before, it seems to rise, to sink or to drift aside,
    and the feet below it are not where the walker is.

    Args:
        led_s: how long before and after it the trajectory is led on.
        free: (chains,) those that are looked at.
    """
    whole = trajectory.extended(round(led_s * fps), len(chains.start) - 1, fps)
    rows, place, z_m = rows_near(whole, chains, floor, free)
    across = sight_axes(place)[:, 1]
    spot = floor.places(chains.slope[rows], z_m)
    aside_m = ((spot - place) * across).sum(axis=1)
    chain, number, frames = np.unique(chains.chain[rows], return_inverse=True, return_counts=True)
    frame = chains.frame[rows]
    unseen_s = trajectory.frames_off(frame) / fps
    middle_z, middle_aside = (_means(number, value, frames) for value in (z_m, aside_m))
    misfit = _unsteadiness(
        z_m - middle_z[number], aside_m - middle_aside[number], unseen_s, chains.slope[rows]
    )
    misfit = _means(number, misfit, frames) + _oddity(middle_z, middle_aside)
    misfit += _trends(number, frame / fps, z_m, aside_m, frames / fps)
    ratio = ratios(chains.feet_m[rows], np.hypot(*place.T))
    misfit += _means(number, feet_misfit(ratio), frames)
    enough = np.maximum(
        np.minimum(round(_LEAST_TREND_S * fps), chains.length[chain]),
        _LEAST_SHARE * chains.length[chain],
    )
    alike = (misfit < _ALIKE) & (frames >= enough)
    return Bundle(rows, number, place, across, chain, frames, middle_z, middle_aside, misfit, alike)


def rows_near(
    trajectory: Trajectory, chains: TrackletChains, floor: Floor, free: Flags | None = None
) -> tuple[Rows, Floats, Floats]:
    """Rows of tracklets that pass near a body on the trajectory, its place, and their height.

    (k,), (k, 2) m and (k,) m over the floor.

    Args:
        free: (chains,) those that are looked at; None: all.
    """
    rows = chains.of_frames(trajectory.first, trajectory.stop)
    if free is not None:
        rows = rows[free[chains.chain[rows]]]
    place, slope = trajectory.place[chains.frame[rows] - trajectory.first], chains.slope[rows]
    cross = slope[:, 1] * place[:, 0] - slope[:, 0] * place[:, 1]
    near = np.abs(cross) < _WIDEST_M * np.maximum(np.hypot(*slope.T), 1e-6)
    rows, place = rows[near], place[near]
    z_m = floor.heights(chains.slope[rows], place)
    body = (z_m > _LOW_M) & (z_m < _HIGH_M)
    return rows[body], place[body], z_m[body]


def _unsteadiness(z_m: Floats, aside_m: Floats, unseen_s: Floats, slope: Floats) -> Floats:
    """(k,) squared distances from where a point of a body would be."""
    steep = np.maximum(np.hypot(*slope.T), 0.5)
    up = np.hypot(_HEIGHT_M, (_WAY_M + _UNSEEN_WAY_M_S * unseen_s) / steep)
    return np.asarray((z_m / up) ** 2 + (aside_m / (_ASIDE_M * (1 + unseen_s))) ** 2)


def _oddity(z_m: Floats, aside_m: Floats) -> Floats:
    """(m,) what places in a body cost where few points of bodies are."""
    over = np.maximum(z_m - _HIGHEST_M, 0) / _HEADROOM_M
    below = np.maximum(_FLOOR_M - z_m, 0) / _FLOOR_M
    return np.asarray((aside_m / _OFF_AXIS_M) ** 2 + over**2 + below**2)


def _trends(number: Rows, time_s: Floats, z_m: Floats, aside_m: Floats, for_s: Floats) -> Floats:
    """(m,) what it costs to rise or to drift aside all the while; steps cancel out over time."""
    frames = np.bincount(number, minlength=len(for_s))
    off = time_s - _means(number, time_s, frames)[number]
    spread = np.maximum(np.bincount(number, off**2, len(for_s)), 1e-6)
    rise, drift = (
        np.bincount(number, off * value, len(for_s)) / spread * for_s for value in (z_m, aside_m)
    )
    usual = _TREND_M + _SHORT_TREND_MS / np.maximum(for_s, _LEAST_TREND_S)
    cost = (rise / usual) ** 2 + (drift / (1.5 * usual)) ** 2
    return np.where(for_s > _LEAST_TREND_S, cost, 0.0)


def _means(number: Rows, value: Floats, count: Rows) -> Floats:
    return np.asarray(np.bincount(number, value, len(count)) / np.maximum(count, 1))
