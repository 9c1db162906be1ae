"""Vertical misalignment of the right camera against the calibration, and its correction."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.foreground import Marks

Grey = NDArray[np.uint8]
Floats = NDArray[np.float32]

_MARKS = Marks(most=200, faintest=0.002, apart_px=12, window_px=15, levels=1)
_FEWEST = 40
_RETURN_PX = 0.4
"""A mark followed to the right camera and back must end so near to where it began."""
_ASIDE_PX = 2.5
"""Marks of the empty scene are found so near to where range puts them, to the left and right."""
_LIKE_PX = 0.6
"""Marks off by more than this from where all the others are were mistaken."""
_FEWEST_IN_QUARTER = 5
"""So many marks in a quarter of the picture tell what is there."""
_CERTAIN = 3.0
"""Standard errors by which a slope must differ from none."""
_LEVEL_PX, _MOST_PX = 0.35, 4.0
"""Cameras that are off by less match as well; off by more they are calibrated wrong."""


class Levelling:
    """Shifts, turns and scales the right camera so that things lie in the rows of the left one.

    A rig that was warm, or knocked, when or after it was calibrated sees the same thing a pixel
    higher in one camera. Block matching looks along rows, and finds what is there instead. Where
    what is higher on one side is lower on the other, the camera is turned about its axis, and range
    is wrong above and below.

    `Marks` are followed from one camera to the other and back. What is made of them is ours.

    Attributes:
        off: how much lower the right camera sees than the left one: (3,) px in the picture's
            middle, and more for each px to the right, and downwards. None: the cameras are level,
            or nothing is known of them.
    """

    def __init__(self) -> None:
        self.off: Floats | None = None

    def learn(self, left: Grey, right: Grey, scene: Floats, step: int) -> bool:
        """Compare where both cameras see marks of the empty scene.

        What is known stays as it is unless marks tell that it is wrong: a scene that lies in the
        dark, or in hard light, has few of them.

        Args:
            left, right: (height, width) rectified pictures of it.
            scene: disparity of the pixels [::step, ::step], NaN where unknown.

        Returns:
            Whether its marks told anything.
        """
        start, end = _found_right(left, right, scene, step)
        middle = _middle(right)
        points, lower_px = end - middle, end[:, 1] - start[:, 1]
        if self.off is not None:
            lower_px = lower_px - _sides(points).astype(np.float32) @ self.off
        more = _plane(points, lower_px, middle)
        if more is None:
            return False
        if more.any():
            off = more if self.off is None else self.off + more
            self.off = off if _LEVEL_PX < _most(off, middle) < _MOST_PX else None
        return True

    def level(self, right: Grey) -> Grey:
        """The right camera with its rows at the height of the left one's."""
        return self._moved(right, cv2.INTER_LINEAR)

    def level_mask(self, right: Grey) -> Grey:
        """A mask of the right camera, moved as the camera is."""
        return self._moved(right, cv2.INTER_NEAREST)

    def _moved(self, right: Grey, between: int) -> Grey:
        """between: how values between pixels are made, as OpenCV numbers it."""
        if self.off is None:
            return right
        shift, turn, larger = self.off.tolist()
        turned = np.array(((1 + larger, -turn), (turn, 1 + larger)))
        middle = _middle(right)
        moved = np.column_stack((turned, middle - turned @ middle + np.array((0.0, shift))))
        way = between | cv2.WARP_INVERSE_MAP
        size, border = (right.shape[1], right.shape[0]), cv2.BORDER_REPLICATE
        return np.asarray(cv2.warpAffine(right, moved, size, flags=way, borderMode=border))


def _middle(image: Grey) -> NDArray[np.float64]:
    """(2,) px."""
    return (np.array(image.shape[::-1]) - 1) / 2


def _found_right(left: Grey, right: Grey, scene: Floats, step: int) -> tuple[Floats, Floats]:
    """(n, 2) px of marks in the left camera, and where they are in the right one."""
    marks = _MARKS.of(left)
    u, v = (marks // step).astype(np.intp).T
    range_px = scene[v.clip(0, scene.shape[0] - 1), u.clip(0, scene.shape[1] - 1)]
    known = np.isfinite(range_px)
    marks, range_px = marks[known], range_px[known]
    guess = marks - np.column_stack((range_px, np.zeros_like(range_px)))
    there, seen = _MARKS.followed(left, right, marks, guess)
    back, again = _MARKS.followed(right, left, there, marks)
    good = seen & again & (np.hypot(*(back - marks).T) < _RETURN_PX)
    good &= np.abs(there[:, 0] - guess[:, 0]) < _ASIDE_PX
    return marks[good], there[good]


def _plane(
    points: NDArray[np.floating], lower_px: Floats, middle: NDArray[np.float64]
) -> Floats | None:
    """What most marks say of how much lower the right camera sees; None: they cannot tell.

    Marks that lie together tell how much lower it sees there, but not how it is turned.

    Args:
        points: (n, 2) px from the picture's middle. lower_px: (n,), beyond what is known.
        middle: (2,) px.

    Returns:
        (3,) as `Levelling.off`; zeros where it is too little to be worth undoing.
    """
    sides = _sides(points) if _spread_out(points) else _sides(points)[:, :1]
    off = _fitted(sides, lower_px)
    if off is None or len(sides) < _FEWEST:
        return None
    off = np.append(off, np.zeros(3 - len(off)))
    if _most(off, middle) <= _LEVEL_PX:
        return np.zeros(3, np.float32)
    return off.astype(np.float32) if _foretold(sides, lower_px) else None


def _sides(points: NDArray[np.floating]) -> NDArray[np.floating]:
    """(n, 3) by what each number of `Levelling.off` counts at points, px from the middle."""
    return np.column_stack((np.ones(len(points)), points))


def _most(off: NDArray[np.floating], middle: NDArray[np.float64]) -> float:
    """By how many px rows are off where they are so most, in a corner."""
    return float(abs(off[0]) + np.abs(off[1:]) @ middle)


def _spread_out(points: NDArray[np.floating]) -> bool:
    """Whether marks lie in three quarters of the picture at least."""
    quarter = (points[:, 0] > 0) + 2 * (points[:, 1] > 0)
    return int(np.count_nonzero(np.bincount(quarter, minlength=4) >= _FEWEST_IN_QUARTER)) >= 3


def _fitted(sides: NDArray[np.floating], lower_px: Floats) -> NDArray[np.float64] | None:
    """What most marks say, as much of it as is more than chance; None: they do not agree.

    Args:
        sides: (n, k) by what each number counts for each mark; the first for all of them alike.
        lower_px: (n,).
    """
    if len(sides) < _FEWEST // 2:
        return None
    off = np.append(np.median(lower_px), np.zeros(sides.shape[1] - 1))
    for near_px in (2 * _LIKE_PX, _LIKE_PX):
        like = np.abs(lower_px - sides @ off) < near_px
        if np.count_nonzero(like) < max(_FEWEST // 2, len(sides) / 2):
            return None
        off = _least_squares(sides[like], lower_px[like])
    return off


def _least_squares(sides: NDArray[np.floating], lower_px: Floats) -> NDArray[np.float64]:
    """(k,) of the marks; slopes that chance may have made are 0."""
    off = np.linalg.lstsq(sides, lower_px, rcond=None)[0]
    spread = np.sum((lower_px - sides @ off) ** 2) / max(1, len(sides) - len(off))
    errors = np.sqrt(spread * np.diag(np.linalg.pinv(sides.T @ sides)))
    certain = np.abs(off) > _CERTAIN * errors
    certain[0] = True
    told = np.zeros(len(off))
    told[certain] = np.linalg.lstsq(sides[:, certain], lower_px, rcond=None)[0]
    return told


def _foretold(sides: NDArray[np.floating], lower_px: Floats) -> bool:
    """Whether what every other mark says fits those left out better than what is known."""
    off = _fitted(sides[::2], lower_px[::2])
    if off is None:
        return False
    left_out = lower_px[1::2]
    wrong, known = (
        np.minimum(np.abs(px), 2 * _LIKE_PX).mean()
        for px in (left_out - sides[1::2] @ off, left_out)
    )
    return bool(wrong < known)
