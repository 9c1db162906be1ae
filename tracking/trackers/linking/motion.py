"""How likely people walk from the end of one tracklet to the beginning of another.

This is a mixture of two motion models, constant velocity disturbed by white noise and a
velocity that is forgotten; `_WALKING` is the process noise intensity.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.linking.seen_rows import Floats
from tracking.trackers.linking.tracklets import State

Rows = NDArray[np.intp]

_WALKING = 0.3
"""m²/s³: how much the velocity of somebody who walks on is disturbed."""
_TURNING_EVERY_S = 6.0
"""In this time people turn, stop or start once."""
_LEAST_TURNING = 0.01
"""Share of people who turn even in the shortest gap."""
_TURN_S = 0.4
"""After it somebody who turns may walk anywhere."""
_SPEED_M_S = 0.9
"""Of people along each axis."""
_TOGETHER = 0.8
"""Correlation of where somebody is after a turn and how fast they then walk: nearly one."""


def walk_likelihood(ends: State, starts: State, end: Rows, start: Rows, gap_s: Floats) -> Floats:
    """(k,) log-density, in 1/m² and 1/(m/s)², of where and how fast people come back.

    Either they walked on, with small changes of velocity, or they turned, stopped or started on
    the way; the longer unseen, the likelier that.

    Args:
        end, start: (k,) tracklets. gap_s: (k,) between.
    """
    straight = _density(ends, starts, end, start, *_straight(gap_s))
    turned = _density(ends, starts, end, start, *_turned(gap_s))
    turning = np.clip(1.0 - np.exp(-gap_s / _TURNING_EVERY_S), _LEAST_TURNING, 1.0 - 1e-6)
    return np.asarray(np.logaddexp(np.log1p(-turning) + straight, np.log(turning) + turned))


def fresh_likelihood(starts: State) -> Floats:
    """(t,) log-density, in 1/(m/s)², of the velocity of somebody of whom nothing is known."""
    variance = _SPEED_M_S**2 + starts.covariance[:, 1, 1]
    squared = np.square(starts.velocity).sum(axis=1)
    return np.asarray(-squared / (2 * variance) - np.log(2 * np.pi * variance))


def _straight(gap_s: Floats) -> tuple[Floats, Floats]:
    """Transition and disturbance (k, 2, 2) of walking on."""
    zero, one = np.zeros_like(gap_s), np.ones_like(gap_s)
    transition = _matrices(one, gap_s, zero, one)
    disturbance = _WALKING * _matrices(gap_s**3 / 3, gap_s**2 / 2, gap_s**2 / 2, gap_s)
    return transition, disturbance


def _turned(gap_s: Floats) -> tuple[Floats, Floats]:
    """The same of somebody whose velocity is forgotten within `_TURN_S` (Ornstein, Uhlenbeck)."""
    zero, one = np.zeros_like(gap_s), np.ones_like(gap_s)
    kept = np.exp(-gap_s / _TURN_S)
    transition = _matrices(one, _TURN_S * (1 - kept), zero, kept)
    # For many short turns the way grows as a random walk; one turn and a straight walk after it
    # is more: the place is as uncertain as the new velocity makes it.
    place = np.square(_SPEED_M_S * gap_s) / 2
    speed = _SPEED_M_S**2 * (1 - kept**2)
    both = _TOGETHER * np.sqrt(place * speed)
    return transition, _matrices(place, both, both, speed)


def _matrices(a: Floats, b: Floats, c: Floats, d: Floats) -> Floats:
    """(k, 2, 2) of rows (a, b) and (c, d)."""
    return np.stack((np.stack((a, b), axis=-1), np.stack((c, d), axis=-1)), axis=-2)


def _density(
    ends: State, starts: State, end: Rows, start: Rows, transition: Floats, disturbance: Floats
) -> Floats:
    """(k,) log-density of the starts' places and velocities, along both axes together."""
    before = np.stack((ends.place[end], ends.velocity[end]), axis=1)
    after = np.stack((starts.place[start], starts.velocity[start]), axis=1)
    miss = after - transition @ before
    spread = transition @ ends.covariance[end] @ np.swapaxes(transition, 1, 2)
    spread = spread + disturbance + starts.covariance[start]
    inside = np.einsum("kia,kij,kja->k", miss, np.linalg.inv(spread), miss)
    return np.asarray(-0.5 * inside - np.log(np.linalg.det(spread)) - 2 * np.log(2 * np.pi))
