"""Pieces of tracks in which nothing is doubtful, and how they begin and end.

Their ends are states with a covariance, fitted by least squares with a
prior on speed.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.linking.seen_rows import Floats, Integers, SeenRows, place_errors

_WINDOW_S = 0.6
"""Of a tracklet's end from which place and velocity there are taken."""
_DOUBTFUL = 2.0
"""Times as much err places of people cut off by the edge, or close to somebody."""
_SPEED_M_S = 1.2
"""Of people, along each axis, before anything is known of them."""


@dataclass(frozen=True, slots=True)
class State:
    """Where tracklets begin or end, each with its uncertainty, the same along both axes.

    Attributes:
        frame: (t,). place: (t, 2) m. velocity: (t, 2) m/s.
        covariance: (t, 2, 2) of place and velocity along one axis.
    """

    frame: Integers
    place: Floats
    velocity: Floats
    covariance: Floats


@dataclass(frozen=True, slots=True)
class Tracklets:
    """Stretches of rows of one track each, in the order of `SeenRows`.

    Attributes:
        start, stop: (t,) their rows, half-open. track: (t,) the tracker's id.
        doubt: (t,) why they begin where they do; see `Doubt`.
        first, last: (t,) how they begin and end.
    """

    start: NDArray[np.intp]
    stop: NDArray[np.intp]
    track: Integers
    doubt: NDArray[np.uint8]
    first: State
    last: State

    def __len__(self) -> int:
        """The number of tracklets."""
        return len(self.start)

    @property
    def of_rows(self) -> NDArray[np.intp]:
        """(n,) the tracklet of each row."""
        return np.repeat(np.arange(len(self)), self.stop - self.start)


def cut_tracklets(seen: SeenRows, doubt: NDArray[np.uint8], fps: float) -> Tracklets:
    """The rows as pieces that begin where it is doubtful who goes on."""
    start = np.flatnonzero(doubt)
    stop = np.append(start[1:], len(seen))
    return Tracklets(
        start,
        stop,
        seen.track[start],
        doubt[start],
        _states(seen, start, stop, fps, last=False),
        _states(seen, start, stop, fps, last=True),
    )


def _states(
    seen: SeenRows, start: NDArray[np.intp], stop: NDArray[np.intp], fps: float, *, last: bool
) -> State:
    """The straight line through the rows at one end that suits them and usual speeds best."""
    anchor = (stop - 1) if last else start
    reach = max(2, round(_WINDOW_S * fps))
    offset = np.arange(reach) * (-1 if last else 1)
    rows = np.clip(anchor[:, None] + offset, start[:, None], stop[:, None] - 1)
    elapsed_s = (seen.frame[rows] - seen.frame[anchor][:, None]) / fps
    used = (anchor[:, None] + offset == rows) & (np.abs(elapsed_s) <= _WINDOW_S)
    error_m = place_errors(seen.place) * np.where(seen.alone & ~seen.at_edge, 1.0, _DOUBTFUL)
    weight = used / np.square(error_m[rows])
    information = np.zeros((len(start), 2, 2))
    information[:, 0, 0] = weight.sum(axis=1)
    information[:, 0, 1] = information[:, 1, 0] = (weight * elapsed_s).sum(axis=1)
    information[:, 1, 1] = (weight * elapsed_s**2).sum(axis=1) + _SPEED_M_S**-2
    covariance: Floats = np.linalg.inv(information).astype(np.float64)
    place = seen.place[rows]
    moments = np.stack(
        ((weight[..., None] * place).sum(axis=1), ((weight * elapsed_s)[..., None] * place).sum(1)),
        axis=1,
    )
    line = covariance @ moments
    return State(seen.frame[anchor], line[:, 0], line[:, 1], _add_floor(covariance))


def _add_floor(covariance: Floats) -> Floats:
    """Errors of places follow each other: many rows do not make a place sure."""
    return covariance + np.diag((0.05**2, 0.15**2))
