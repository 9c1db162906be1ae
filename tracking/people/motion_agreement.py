"""What moves in each row of two cameras, and by how much one is late."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence

import cv2
import numpy as np

from tracking.arrays import Floats, Picture
from tracking.recording.image_pairs import MOST_LAG

_WIDE_PX = 160
"""About the width of the thinned pictures compared."""
_MOVED = 12
"""Grey levels by which what moves changes from one frame to the next."""
_POOLED = 2
"""Rows taken together: what moves is drawn a little otherwise in the other camera."""
_MOVING, _STILL = 20, 0.02
"""Fewest moving places in one camera, and the share of them that may move in a still one."""
MOST_HELD = 2
"""Encoders, and cables, repeat one picture or two."""
_RECENT_S, _RECENT_FRAMES, _MOST_RECENT_FRAMES = 0.8, 16, 96
"""Movement that tells whether the cameras agree, in seconds and in frames: fewer correlate by
chance, more take long where a recording has thousands a second."""
_MOST_LAG_S, _MOST_LAG_FRAMES = 0.5, 15
"""By how much a camera may be late and found to be, and in frames at the least."""
_NEAR = 0.2
"""Cameras that agree are most alike without a lag, compared with lags of up to this share of the
recent frames; more frames than that apart, so short a time is alike by chance."""
_ALIKE, _BETTER = 0.4, 0.04
"""Correlation of the two cameras' movement at their lag, and how much less it is at any other."""
_BY_CHANCE, _UNLIKE = 0.2, 0.35
"""Correlation that cameras without anything in common reach; below it they are unlike."""
_LEAST_MOVEMENT = 120.0
"""Places, a frame, that must move on average for a lag to be told: fewer may be an encoder's."""

Stretch = tuple[Floats, Floats]
"""What moves in rows of the left and the right camera, each (frames, rows), frame by frame."""


class MotionAgreement:
    """The movement of both cameras in the last frames.

    Rows of rectified pictures show the same things left and right, so how much moves in each row,
    frame by frame, is alike in both cameras, however far away it is: a camera that lags shows the
    same movement, late.

    Attributes:
        recent: frames of movement that tell whether cameras agree.
        most_lag: the largest lag that is looked for, in frames.
        span: frames of movement that are kept, and needed to tell a lag.
    """

    def __init__(self, fps: float, told_lag: int = 0) -> None:
        """Nothing has moved yet. fps: frames a second. told_lag: one to look for in any case."""
        self.recent = min(max(_RECENT_FRAMES, round(_RECENT_S * fps)), _MOST_RECENT_FRAMES)
        most = max(_MOST_LAG_FRAMES, round(_MOST_LAG_S * fps), abs(told_lag))
        self.most_lag = min(most, MOST_LAG)
        self.span = self.recent + self.most_lag
        self._before: tuple[Picture, Picture] | None = None
        self._held = 0
        self._rows: tuple[deque[Floats], deque[Floats]] = (
            deque(maxlen=self.span),
            deque(maxlen=self.span),
        )

    def __len__(self) -> int:
        """Frames of movement that are known, one behind the other."""
        return len(self._rows[0])

    def add(self, images: tuple[Picture, Picture]) -> tuple[int, int]:
        """Take in the next frame, of `thinned` cameras; how much moves in each since the last.

        Where one camera shows its last picture once more, its movement is missing in one frame and
        double in the next, unlike the other's: both cameras' is taken from the frames around then,
        and spread evenly over them, so that rows stay as far apart as frames are.
        """
        if self._before is None:
            self._before = images
            return 0, 0
        moving = [_moving(*pair) for pair in zip(images, self._before, strict=True)]
        left, right = (int(rows.sum()) for rows in moving)
        if self._held < MOST_HELD and (
            self._repeats(0, left, right) or self._repeats(1, right, left)
        ):
            self._held += 1
            return left, right
        shared = 1 + self._held
        for rows, now in zip(self._rows, moving, strict=True):
            rows.extend([now / shared] * shared)
        self._held, self._before = 0, images
        return left, right

    def _repeats(self, image: int, moved: int, other: int) -> bool:
        """Whether a camera shows its last picture once more.

        Not where it stood still before: in cameras that are late somebody begins to move in one
        before the other, which is what tells by how much.
        """
        rows = self._rows[image]
        return bool(rows) and rows[-1].sum() >= _MOVING and stands_still(moved, other)

    def keep(self, frames: int) -> None:
        """Forget all movement but that of the last frames."""
        for rows in self._rows:
            while len(rows) > frames:
                rows.popleft()

    def begin(self) -> None:
        """Forget all, the last pictures too: the next ones do not follow on them."""
        self._before, self._held = None, 0
        self.keep(0)

    def stretch(self) -> Stretch | None:
        """All movement that is kept; None before there is enough to tell any lag."""
        return self._last(self.span) if len(self) == self.span else None

    def is_still(self) -> bool:
        """Whether hardly anything moves in the frames so far."""
        return not _moves([self._last(self.span)])

    def agrees(self) -> bool:
        """Whether nothing in the recent movement speaks against that no camera is late."""
        recent = self._last(self.recent)
        if len(self) < self.recent or not _moves([recent]):
            return True
        near = round(_NEAR * self.recent)
        alike = [_alike([recent], lag) for lag in range(-near, near + 1)]
        return alike[near] >= max(*alike, _BY_CHANCE)

    def is_unlike(self) -> bool:
        """Whether cameras moved recently, but not at all alike."""
        recent = self._last(self.recent)
        return len(self) >= self.recent and _moves([recent]) and _alike([recent], 0) < _UNLIKE

    def _last(self, frames: int) -> Stretch:
        left, right = (np.array(list(rows)[-frames:]) for rows in self._rows)
        return left, right


def stands_still(image: int, other: int) -> bool:
    """Whether a camera repeats its last image while the other moves in so many places."""
    return other >= _MOVING and image <= _STILL * other


def _moving(image: Picture, earlier: Picture) -> Floats:
    """(rows,) how much moves in rows taken together, from one picture to the next."""
    changed = cv2.absdiff(image, _in_light_of(image, earlier))
    moved = cv2.threshold(changed, _MOVED, 1, cv2.THRESH_BINARY)[1]
    rows = cv2.reduce(moved, 1, cv2.REDUCE_SUM, dtype=cv2.CV_32S).ravel()
    whole = len(rows) // _POOLED * _POOLED
    return np.asarray(rows[:whole].reshape(-1, _POOLED).sum(axis=1), np.float64)


def _in_light_of(image: Picture, earlier: Picture) -> Picture:
    """An earlier picture as bright as the present one: lamps that flicker move nothing."""
    now, before = cv2.mean(image)[0], cv2.mean(earlier)[0]
    return np.asarray(cv2.convertScaleAbs(earlier, alpha=now / max(before, 1.0)), np.uint8)


def thinned(image: Picture) -> Picture:
    """Of a rectified camera (height, width, 3) what is compared: one channel of a few pixels."""
    return mean_of_four(image[..., 1], thinning_px(image.shape[1]))


def mean_of_four(channel: Picture, step: int) -> Picture:
    """(height // step, width // step) of (height, width), each the mean of four pixels.

    A sensor's noise, alike in no two cameras, would be movement otherwise. Where every pixel is
    compared, the four overlap those of the next one, and edges are drawn out.
    """
    rows, columns = (side // step * step for side in channel.shape)
    if step == 1:
        channel = np.asarray(cv2.copyMakeBorder(channel, 0, 1, 0, 1, cv2.BORDER_REPLICATE))
    starts = (0, beside_px(step))
    few = [channel[v : v + rows : step, u : u + columns : step] for v in starts for u in starts]
    pairs = [cv2.addWeighted(one, 0.5, other, 0.5, 0) for one, other in (few[:2], few[2:])]
    return np.asarray(cv2.addWeighted(pairs[0], 0.5, pairs[1], 0.5, 0), np.uint8)


def thinning_px(width: int) -> int:
    """How far the pixels that are compared are from each other."""
    return max(1, width // _WIDE_PX)


def beside_px(step: int) -> int:
    """How far the pixels of which the mean is taken are from each other."""
    return max(1, step // 2)


def late_by(stretches: Sequence[Stretch], most_lag: int) -> int | None:
    """Frames by which the right camera is late; negative: the left one. None: it cannot be told.

    A larger lag makes the largest one looked for the best of all: that one is not believed.

    Args:
        stretches: of a lag that is the same in all of them. most_lag: the largest that is told.
    """
    if not stretches or not _moves(stretches):
        return None
    most = most_lag + 1
    alike = np.array([_alike(stretches, lag) for lag in range(-most, most + 1)])
    best = int(alike.argmax())
    if alike[best] < _ALIKE or best in (0, 2 * most):
        return None
    certain = alike[best] > np.delete(alike, best).max() + _BETTER
    return best - most if certain else None


def _moves(stretches: Sequence[Stretch]) -> bool:
    """Whether enough moves in both cameras."""
    return all(
        np.mean([rows.sum(axis=1).mean() for rows in image]) >= _LEAST_MOVEMENT
        for image in zip(*stretches, strict=True)
    )


def _alike(stretches: Sequence[Stretch], lag: int) -> float:
    """Correlation over time of what moves in each row, the right camera being late by `lag`."""
    together = lefts = rights = 0.0
    for left, right in stretches:
        count = len(left) - abs(lag)
        one, other = left[max(-lag, 0) :][:count], right[max(lag, 0) :][:count]
        one, other = one - one.mean(axis=0), other - other.mean(axis=0)
        together += float((one * other).sum())
        lefts, rights = lefts + float((one**2).sum()), rights + float((other**2).sum())
    return together / float(np.sqrt(lefts * rights + 1e-9))
