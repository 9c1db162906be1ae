"""What moves in each row of two eyes, and by how much one is late."""

from __future__ import annotations

from collections import deque

import cv2
import numpy as np
from numpy.typing import NDArray

Picture = NDArray[np.uint8]
Floats = NDArray[np.float64]

_WIDE_PX = 160
"""About the width of the thinned pictures compared."""
_MOVED = 12
"""Grey levels by which what moves changes from one frame to the next."""
_RECENT_S, _RECENT_FRAMES = 0.8, 16
"""How much movement is compared, and in frames at the least: fewer correlate by chance."""
_MOST_LAG_S, _MOST_LAG_FRAMES = 0.5, 15
"""By how much an eye may be late and found to be, and in frames at the least."""
_SHARED = 0.75
"""Of the movement that is compared, so much is compared at the largest lag."""
_ALIKE, _BETTER = 0.6, 0.04
"""Correlation of the two eyes' movement at their lag, and how much less it is at any other."""
_LEAST_MOVEMENT = 40.0
"""Places, a frame, that must move on average for a lag to be told."""


class EyeMovement:
    """The movement of both eyes in the last frames.

    Rows of rectified pictures show the same things left and right, so how much moves in each row,
    frame by frame, is alike in both eyes, however far away it is: an eye that lags shows the same
    movement, late.

    Attributes:
        recent: frames of movement that suffice to compare eyes that are not late.
        most_lag: the largest lag that is looked for, in frames.
        span: frames of movement that are kept: with them every lag is found.
    """

    def __init__(self, fps: float) -> None:
        """Nothing has moved yet. fps: frames a second."""
        self.recent = max(_RECENT_FRAMES, round(_RECENT_S * fps))
        self.most_lag = max(_MOST_LAG_FRAMES, round(_MOST_LAG_S * fps))
        self.span = self.recent + self.most_lag
        self._before: tuple[Picture, Picture] | None = None
        self._rows: tuple[deque[Floats], deque[Floats]] = (
            deque(maxlen=self.span),
            deque(maxlen=self.span),
        )

    def __len__(self) -> int:
        """Frames of movement that are known, one behind the other."""
        return len(self._rows[0])

    def add(self, eyes: tuple[Picture, Picture]) -> tuple[int, int]:
        """Take in the next frame, of `thinned` eyes; how much moves in each since the last."""
        before, self._before = self._before, eyes
        if before is None:
            return 0, 0
        total = []
        for eye, earlier, rows in zip(eyes, before, self._rows, strict=True):
            moved = cv2.threshold(cv2.absdiff(eye, earlier), _MOVED, 1, cv2.THRESH_BINARY)[1]
            moving = cv2.reduce(moved, 1, cv2.REDUCE_SUM, dtype=cv2.CV_32S).ravel()
            rows.append(moving.astype(np.float64))
            total.append(int(moving.sum()))
        return total[0], total[1]

    def keep(self, frames: int) -> None:
        """Forget all movement but that of the last frames."""
        for rows in self._rows:
            while len(rows) > frames:
                rows.popleft()

    def begin(self) -> None:
        """Forget all, the last pictures too: the next ones do not follow on them."""
        self._before = None
        self.keep(0)

    def late_by(self, *, recently: bool = False) -> int | None:
        """Frames by which the right eye is late; negative: the left one. None: it cannot be told.

        While less movement is known than `span`, only smaller lags are looked for; with less than
        `recent`, none. recently: only small lags, in the `recent` movement, which takes less time.
        """
        left, right = self._arrays()
        if recently:
            left, right = left[-self.recent :], right[-self.recent :]
        return late_by(left, right, self.recent, self.most_lag)

    def is_unlike(self, alike: float) -> bool:
        """Whether eyes move, lately, and are less alike at no lag than a correlation."""
        left, right = (rows[-self.recent :] for rows in self._arrays())
        moves = len(left) == self.recent and _least_movement(left, right) >= _LEAST_MOVEMENT
        return moves and _alike(left, right, 0) < alike

    def _arrays(self) -> tuple[Floats, Floats]:
        left, right = (np.array(rows) for rows in self._rows)
        return left, right


def thinned(eye: Picture) -> Picture:
    """Of a rectified eye (height, width, 3) or (height, width) what is compared, one channel."""
    step = max(1, eye.shape[1] // _WIDE_PX)
    green = eye[..., 1] if eye.ndim == 3 else eye
    return np.ascontiguousarray(green[::step, ::step])


def late_by(left: Floats, right: Floats, recent: int, most_lag: int) -> int | None:
    """Frames by which the right eye's movement comes later; None where it cannot be told.

    A larger lag makes the largest one looked for the best of all: that one is not believed.

    Args:
        left, right: (frames, rows) what moves in each row of the two eyes.
        recent: see `EyeMovement`. most_lag: the largest lag that is told.
    """
    if len(left) < recent or _least_movement(left, right) < _LEAST_MOVEMENT:
        return None
    most = min(most_lag, len(left) - round(_SHARED * recent)) + 1
    alike = np.array([_alike(left, right, lag) for lag in range(-most, most + 1)])
    best = int(alike.argmax())
    if alike[best] < _ALIKE or best in (0, 2 * most):
        return None
    certain = alike[best] > np.delete(alike, best).max() + _BETTER
    return best - most if certain else None


def _least_movement(left: Floats, right: Floats) -> float:
    """Places that move a frame, in the eye in which fewer do."""
    return float(min(left.sum(axis=1).mean(), right.sum(axis=1).mean()))


def _alike(left: Floats, right: Floats, lag: int) -> float:
    """Correlation over time of what moves in each row, the right eye being late by `lag`."""
    count = len(left) - abs(lag)
    one = left[max(-lag, 0) :][:count]
    other = right[max(lag, 0) :][:count]
    one, other = one - one.mean(axis=0), other - other.mean(axis=0)
    return float((one * other).sum() / np.sqrt((one**2).sum() * (other**2).sum() + 1e-9))
