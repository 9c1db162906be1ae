"""The people followed, and how they are predicted and measured on the floor."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.flow.floor import sight_axes

Floats = NDArray[np.float64]

_PUSH_M2_S3 = 0.6
"""How unsteadily people walk: power of the random push on the velocity."""
_FIRST_M, _FIRST_M_S = 0.4, 0.7
_PLACE = np.eye(2, 4)


@dataclass(frozen=True, slots=True, eq=False)
class Walkers:
    """The people followed, a row each, by track.

    Attributes:
        track: (m,) int32.
        state: (m, 4) x, y in m and vx, vy in m/s on the floor.
        spread: (m, 4, 4) its covariance.
        age_s, missed_s: (m,) since the first frame, and since the last one they were measured in.
        empty_s: (m,) how long nothing has been seen where they are in sight.
        count: (m,) tracklets they are held by.
        began: (m, 2) m where they were first. walked: (m,) whether they have gone on from there.
    """

    track: NDArray[np.int32]
    state: Floats
    spread: Floats
    age_s: Floats
    missed_s: Floats
    empty_s: Floats
    count: NDArray[np.int64]
    began: Floats
    walked: NDArray[np.bool_]

    def __len__(self) -> int:
        """How many there are."""
        return len(self.track)

    @property
    def place(self) -> Floats:
        """(m, 2) m."""
        return self.state[:, :2]

    @property
    def pace(self) -> Floats:
        """(m, 2) m/s."""
        return self.state[:, 2:]

    def select(self, rows: NDArray[np.bool_] | NDArray[np.intp]) -> Walkers:
        """Some of them."""
        return Walkers(
            self.track[rows],
            self.state[rows],
            self.spread[rows],
            self.age_s[rows],
            self.missed_s[rows],
            self.empty_s[rows],
            self.count[rows],
            self.began[rows],
            self.walked[rows],
        )

    def append(self, more: Walkers) -> Walkers:
        """These and more, whose tracks are higher."""
        return Walkers(
            np.append(self.track, more.track),
            np.concatenate((self.state, more.state)),
            np.concatenate((self.spread, more.spread)),
            np.append(self.age_s, more.age_s),
            np.append(self.missed_s, more.missed_s),
            np.append(self.empty_s, more.empty_s),
            np.append(self.count, more.count),
            np.concatenate((self.began, more.began)),
            np.append(self.walked, more.walked),
        )


def begin_walkers(track: NDArray[np.int32], place: Floats, pace: Floats) -> Walkers:
    """People at these places, who walk so."""
    spread = np.zeros((len(track), 4, 4))
    spread[:, :2, :2] = np.eye(2) * _FIRST_M**2
    spread[:, 2:, 2:] = np.eye(2) * _FIRST_M_S**2
    none = np.zeros(len(track))
    state = np.concatenate((place, pace), axis=1)
    count, walked = np.zeros(len(track), np.int64), np.zeros(len(track), bool)
    return Walkers(track, state, spread, none, none, none, count, place, walked)


def no_walkers() -> Walkers:
    """No people."""
    return begin_walkers(np.zeros(0, np.int32), np.zeros((0, 2)), np.zeros((0, 2)))


def put_at(walkers: Walkers, row: int, place: Floats, pace: Floats) -> Walkers:
    """With one of them found again at a place, walking so."""
    state, spread = walkers.state.copy(), walkers.spread.copy()
    missed_s, empty_s = walkers.missed_s.copy(), walkers.empty_s.copy()
    state[row] = (*place, *pace)
    spread[row] = np.diag((_FIRST_M, _FIRST_M, _FIRST_M_S, _FIRST_M_S)) ** 2
    missed_s[row] = empty_s[row] = 0.0
    return replace(walkers, state=state, spread=spread, missed_s=missed_s, empty_s=empty_s)


def mark_proven(walkers: Walkers, walked_m: float) -> Walkers:
    """With those marked who have gone so far from where they were found: only people do."""
    way = walkers.place - walkers.began
    far = np.hypot(way[:, 0], way[:, 1]) >= walked_m
    return replace(walkers, walked=walkers.walked | far)


def predict(walkers: Walkers, elapsed_s: float) -> Walkers:
    """Everybody so much later, at constant velocity with random pushes."""
    step = np.eye(4)
    step[:2, 2:] = np.eye(2) * elapsed_s
    push = np.zeros((4, 4))
    push[:2, :2] = np.eye(2) * elapsed_s**3 / 3
    push[:2, 2:] = push[2:, :2] = np.eye(2) * elapsed_s**2 / 2
    push[2:, 2:] = np.eye(2) * elapsed_s
    return replace(
        walkers,
        state=walkers.state @ step.T,
        spread=step @ walkers.spread @ step.T + _PUSH_M2_S3 * push,
        age_s=walkers.age_s + elapsed_s,
        missed_s=walkers.missed_s + elapsed_s,
    )


def update_measured(walkers: Walkers, place: Floats, error_m: Floats) -> Walkers:
    """Everybody corrected by where they were seen: a Kalman filter's update.

    Args:
        place: (m, 2) m; NaN: not seen.
        error_m: (m, 2) its standard deviation along the line of sight and across it.
    """
    known = np.asarray(np.isfinite(place + error_m).all(axis=1))
    if not known.any():
        return walkers
    axes = sight_axes(walkers.place)
    variance = np.where(known[:, None], error_m, 1e3) ** 2
    noise = np.swapaxes(axes, 1, 2) @ (variance[..., None] * axes)
    across = walkers.spread[:, :, :2]
    gain = across @ np.linalg.inv(walkers.spread[:, :2, :2] + noise)
    miss = np.where(known[:, None], place - walkers.place, 0.0)
    state = walkers.state + (gain @ miss[..., None])[..., 0]
    spread = walkers.spread - gain @ np.swapaxes(across, 1, 2)
    spread = np.where(known[:, None, None], spread, walkers.spread)
    return replace(walkers, state=state, spread=(spread + np.swapaxes(spread, 1, 2)) / 2)
