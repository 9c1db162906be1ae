"""Subtraction stereo: range for what moved, and for nothing else."""

from __future__ import annotations

import math

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.stereo.settings import StereoSettings
from tracking.stereo.sight_lines import SightLines

Grey = NDArray[np.uint8]
Mask = NDArray[np.uint8]
Disparity = NDArray[np.float32]

STEP = 2
"""Pixels between the places that get a disparity."""
_PARTS_OF_PX = 16
_SLACK_PX = 1.0
_SAME_PLACE_M, _SAME_PLACE_PX = 0.15, 0.75
"""How far in range, and at most in disparity, a change may be from the background it is on."""


class SubtractionStereo:
    """Matches left against right where both are foreground.

    [Kawashita2012], [Kawashita2014] section 2.1: the background is subtracted from each eye on its
    own and what is left is matched. Each pixel is only searched between the disparity of the
    floor it looks at and that of the tallest person that could stand on that line of sight.
    """

    def __init__(self, lines: SightLines, settings: StereoSettings | None = None) -> None:
        self._settings = settings or StereoSettings()
        near, far = self._settings.nearest_m, self._settings.farthest_m
        self._least = lines.disparity_at_height(0.0, near, far)[::STEP, ::STEP] - _SLACK_PX
        self._most = (
            lines.disparity_at_height(self._settings.tallest_m, near, far)[::STEP, ::STEP]
            + _SLACK_PX
        )
        self._lines = lines
        self._scene = np.full_like(self._least, np.nan)
        self._scene_slack = np.zeros_like(self._least)
        self._matcher = cv2.StereoBM.create(16, self._settings.window_px | 1)
        self._matcher.setTextureThreshold(5)
        self._matcher.setUniquenessRatio(10)
        self._matcher.setDisp12MaxDiff(1)
        self._matcher.setPreFilterCap(31)

    def learn_scene(self, left: Grey, right: Grey) -> None:
        """Range the empty scene, so that light that changes on it is not taken for people.

        A change whose range is that of the background itself is a shadow or a fleck of light, on
        the floor or on anything else. The tolerance is a fixed length, but never more than
        a fraction of a pixel: far away, where range cannot tell people from a wall close behind
        them, nothing is dropped.

        Args:
            left, right: (height, width) rectified grey pictures of the backgrounds.
        """
        height, width = left[::STEP].shape
        whole = (slice(0, height), slice(0, width))
        low, high = math.floor(float(self._least.min())), math.ceil(float(self._most.max()))
        found = self._search(_rows_halved(left), _rows_halved(right), whole, low, high)
        scene = found[:, ::STEP]
        self._scene = np.where(scene >= low, scene, np.nan).astype(np.float32)
        infinite = np.float32(self._lines.offset)
        per_m = (self._scene - infinite) ** 2 / np.float32(self._lines.focal_baseline)
        self._scene_slack = np.minimum(per_m * _SAME_PLACE_M, np.float32(_SAME_PLACE_PX))

    def match(self, left: Grey, right: Grey, left_mask: Mask, right_mask: Mask) -> Disparity:
        """Disparity of the left eye's foreground, on every second pixel.

        Rows are halved before matching and columns are not: range needs full resolution across
        only, and the window becomes as upright as people are.

        Args:
            left, right: (height, width) rectified grey pictures.
            left_mask, right_mask: uint8, non-zero in the foreground.

        Returns:
            (rows, columns) float32 px for the pixels [::STEP, ::STEP]; NaN outside the foreground
            and where nothing matched.
        """
        here, there = left_mask[::STEP], right_mask[::STEP]
        disparity = np.full(left_mask[::STEP, ::STEP].shape, np.nan, np.float32)
        x, y, width, height = cv2.boundingRect(here)
        if width == 0 or not there.any():
            return disparity
        v, u = np.nonzero(here[y : y + height, ::STEP])
        v, u = v + y, u * STEP
        least, most = self._least[v, u // STEP], self._most[v, u // STEP]
        if len(v) == 0:
            return disparity
        box = (slice(y, y + height), slice(x, x + width))
        low, high = math.floor(float(least.min())), math.ceil(float(most.max()))
        found = self._search(_rows_halved(left), _rows_halved(right), box, low, high)
        d = found[v - y, u - x]
        good = (d >= least) & (d <= most) & _foreground_there(there, v, u, d)
        v, u, d = v[good], u[good] // STEP, d[good]
        moved = ~(np.abs(d - self._scene[v, u]) < self._scene_slack[v, u])
        disparity[v[moved], u[moved]] = d[moved]
        return disparity

    def _search(
        self, left: Grey, right: Grey, box: tuple[slice, slice], lowest: int, highest: int
    ) -> Disparity:
        """Block matching inside the box; its disparities in px."""
        count = -(-(highest - lowest + 1) // 16) * 16
        self._matcher.setMinDisparity(lowest)
        self._matcher.setNumDisparities(count)
        rows, columns = box
        margin = self._settings.window_px
        before = max(0, count + lowest) + margin
        top, bottom = max(0, rows.start - margin), min(left.shape[0], rows.stop + margin)
        first, last = columns.start - before, columns.stop + margin
        pad = (max(0, -first), max(0, last - left.shape[1]))
        cut = np.s_[top:bottom, max(0, first) : last]
        found = self._matcher.compute(
            *(
                cv2.copyMakeBorder(eye[cut], 0, 0, *pad, cv2.BORDER_REPLICATE)
                for eye in (left, right)
            )
        )
        inner = found[rows.start - top :, before:][
            : rows.stop - rows.start, : columns.stop - columns.start
        ]
        return inner.astype(np.float32) / np.float32(_PARTS_OF_PX)


def _rows_halved(eye: Grey) -> Grey:
    size = (eye.shape[1], -(-eye.shape[0] // STEP))
    return np.asarray(cv2.resize(eye, size, interpolation=cv2.INTER_AREA), np.uint8)


def _foreground_there(
    mask: Mask, v: NDArray[np.intp], u: NDArray[np.intp], disparity: Disparity
) -> NDArray[np.bool_]:
    """Whether the right eye, too, sees foreground at the matched place."""
    partner = np.rint(u - disparity).astype(np.intp)
    inside = (partner >= 0) & (partner < mask.shape[1])
    partner[~inside] = 0
    return np.asarray(inside & (mask[v, partner] > 0), np.bool_)
