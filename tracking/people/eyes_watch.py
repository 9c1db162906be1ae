"""Whether the right eye sees what the left one sees, and at the same instant."""

from __future__ import annotations

from collections import deque

import cv2
import numpy as np
from numpy.typing import NDArray

Picture = NDArray[np.uint8]
Floats = NDArray[np.float64]

_WIDE_PX = 160
"""About the width of the thinned pictures compared."""
_TILE = 20
"""Side of the squares, of thinned pixels, that are looked at for whether they show anything."""
_STRUCTURED, _FLAT = 4.0, 1.5
"""Deviations of brightness, grey levels: of a tile that shows something, and that shows nothing."""
_FEWEST_TILES, _LOST = 6, 0.25
"""Of at least so many tiles that show something left, this share must show nothing right."""
_MOVED = 12
"""Grey levels by which what moves changes from one frame to the next."""
_MOVING, _STILL = 20, 0.02
"""Places that move left at the least, and the share of them that may move right in a frozen eye."""
_FROZEN_FRAMES = 3
"""Frames on end without movement after which an eye is frozen: encoders repeat one or two."""
_SPAN_S, _EVERY_S = 0.8, 0.25
"""How much movement is compared for a lag, and how often."""
_FEWEST_FRAMES = 16
"""Of that movement, whatever the frame rate: fewer correlate by chance."""
_ONE_FAILURE_S = 1.0
"""Failures no farther apart than this are told as one."""
_MOST_TOLD = 5
"""Failures, and changes of lag, that are told one by one; the others are counted."""
MOST_LAG = 4
"""Frames by which an eye may be late, and found to be."""
_ALIKE, _BETTER = 0.6, 0.04
"""Correlation of the two eyes' movement at their lag, and how much less it is at no lag."""
_LEAST_MOVEMENT = 40.0
"""Places, a frame, that must move on average for a lag to be told."""
_LOOKS = 2
"""So many looks on end must find the same lag."""


class EyesWatch:
    """Follows how the two eyes agree, frame by frame.

    An eye that fails shows nothing where the other one does (it is black or flat, all of it or a
    part), or does not move while the other one does. An eye that lags shows the same movement,
    late: rows of rectified pictures show the same things left and right, so what moves in each
    row, frame by frame, is alike in both eyes, however far away it is.

    Attributes:
        failing: whether the right eye is of no use in the last frame looked at.
        lag: frames by which the right eye is late; negative: the left one is.
    """

    def __init__(self, fps: float) -> None:
        """`fps`: frames a second."""
        self.failing = False
        self.lag = 0
        self._span = max(_FEWEST_FRAMES, round(_SPAN_S * fps))
        self._every = max(1, round(_EVERY_S * fps))
        self._gap = max(1, round(_ONE_FAILURE_S * fps))
        self._before: tuple[Picture, Picture] | None = None
        self._moving: tuple[deque[Floats], deque[Floats]] = (
            deque(maxlen=self._span),
            deque(maxlen=self._span),
        )
        self._frozen = self._count = self._lag_found = self._lag_looks = 0
        self._failed: list[tuple[int, int]] = []
        self._lagged: list[tuple[int, int]] = []

    def look(self, frame: int, left: Picture, right: Picture) -> None:
        """Take notice of the next frame.

        Args:
            left, right: (height, width, 3) uint8, rectified.
        """
        eyes = _thinned(left), _thinned(right)
        still = self._took_movement(eyes)
        self._before = eyes
        self._frozen = self._frozen + 1 if still else 0
        self.failing = self._frozen >= _FROZEN_FRAMES or _lost(*eyes)
        if self.failing:
            self._took_failure(frame)
            return
        self._count += 1
        if self._count % self._every == 0:
            self._look_for_lag(frame)

    def told(self) -> tuple[str, ...]:
        """What the user should know, a line each; nothing while both eyes are well."""
        failed = [
            f"the right eye shows nothing new in frames {first} to {last}: people are placed by "
            "the left eye alone there, less exactly; look after the camera or its cable"
            for first, last in self._failed
        ]
        late = [_told_late(frame, lag) for frame, lag in self._lagged]
        return (*_first_few(failed), *_first_few(late))

    def _took_failure(self, frame: int) -> None:
        """Movement is not compared over a failure; short gaps are told as one."""
        for moving in self._moving:
            moving.clear()
        if self._failed and frame - self._failed[-1][1] <= self._gap:
            self._failed[-1] = (self._failed[-1][0], frame)
        else:
            self._failed.append((frame, frame))

    def _took_movement(self, eyes: tuple[Picture, Picture]) -> bool:
        """Remember what moves in each row; whether the right eye stands still and the left not."""
        if self._before is None:
            return False
        total = []
        for eye, before, moving in zip(eyes, self._before, self._moving, strict=True):
            moved = cv2.threshold(cv2.absdiff(eye, before), _MOVED, 1, cv2.THRESH_BINARY)[1]
            rows = cv2.reduce(moved, 1, cv2.REDUCE_SUM, dtype=cv2.CV_32S).ravel()
            moving.append(rows.astype(np.float64))
            total.append(int(rows.sum()))
        return total[0] >= _MOVING and total[1] <= _STILL * total[0]

    def _look_for_lag(self, frame: int) -> None:
        if len(self._moving[0]) < self._span:
            return
        left, right = (np.array(moving) for moving in self._moving)
        found = late_by(left, right)
        if found is None:
            return
        self._lag_looks = self._lag_looks + 1 if found == self._lag_found else 1
        self._lag_found = found
        if self._lag_looks >= _LOOKS and found != self.lag:
            self.lag = found
            self._lagged.append((frame, found))


def _told_late(frame: int, lag: int) -> str:
    """What is told of a lag that was found at a frame; 0: there is none any more."""
    if lag == 0:
        return f"from frame {frame} on both eyes show the same instant again"
    eye, by = "right" if lag > 0 else "left", "1 frame" if abs(lag) == 1 else f"{abs(lag)} frames"
    behind = f", and people are told of {by} late" if lag > 0 else ""
    return (
        f"the {eye} eye is {by} late, found at frame {frame}: pictures of the same instant are "
        f"paired from there{behind}; distances before are wrong, mend the recording and track again"
    )


def _first_few(lines: list[str]) -> list[str]:
    """Not more lines than anybody reads, and how many more there are."""
    more = len(lines) - _MOST_TOLD
    return lines if more <= 0 else [*lines[:_MOST_TOLD], f"and {more} more times like this"]


def late_by(left: Floats, right: Floats) -> int | None:
    """Frames by which the right eye's movement comes later; None where it cannot be told.

    Args:
        left, right: (frames, rows) what moves in each row of the two eyes.
    """
    if min(left.sum(axis=1).mean(), right.sum(axis=1).mean()) < _LEAST_MOVEMENT:
        return None
    lags = range(-MOST_LAG, MOST_LAG + 1)
    alike = np.array([_alike(left, right, lag) for lag in lags])
    best = int(alike.argmax())
    if alike[best] < _ALIKE:
        return None
    certain = alike[best] > np.delete(alike, best).max() + _BETTER
    return lags[best] if certain else None


def _alike(left: Floats, right: Floats, lag: int) -> float:
    """Correlation over time of what moves in each row, the right eye being late by `lag`."""
    count = len(left) - abs(lag)
    one = left[max(-lag, 0) :][:count]
    other = right[max(lag, 0) :][:count]
    one, other = one - one.mean(axis=0), other - other.mean(axis=0)
    return float((one * other).sum() / np.sqrt((one**2).sum() * (other**2).sum() + 1e-9))


def shows_nothing(left: Picture, right: Picture) -> bool:
    """Whether the right eye, or a part of it, is black or flat where the left one is not.

    Args:
        left, right: (height, width, 3) uint8, rectified.
    """
    return _lost(_thinned(left), _thinned(right))


def _thinned(eye: Picture) -> Picture:
    step = max(1, eye.shape[1] // _WIDE_PX)
    return np.ascontiguousarray(eye[::step, ::step, 1])


def _lost(left: Picture, right: Picture) -> bool:
    """Whether a part of the right picture shows nothing where the left one shows something."""
    there, here = _deviation(left) > _STRUCTURED, _deviation(right) < _FLAT
    return bool(there.sum() >= _FEWEST_TILES and (there & here).sum() > _LOST * there.sum())


def _deviation(eye: Picture) -> Floats:
    """Standard deviation of brightness in each tile."""
    rows, columns = (side // _TILE for side in eye.shape)
    if rows == 0 or columns == 0:
        return np.zeros((1, 1))
    light = eye[: rows * _TILE, : columns * _TILE].astype(np.float32)
    mean, squared = (
        cv2.resize(values, (columns, rows), interpolation=cv2.INTER_AREA)
        for values in (light, light * light)
    )
    return np.sqrt(np.maximum(np.asarray(squared - mean * mean, np.float64), 0))
