"""Subtraction stereo: range for what moved, and for nothing else."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.stereo.settings import StereoSettings
from tracking.stereo.sight_lines import SightLines

Grey = NDArray[np.uint8]
Mask = NDArray[np.uint8]
Disparity = NDArray[np.float32]

_STEPS_PER_PX = 16
_SLACK_PX = 1.0


class SubtractionStereo:
    """Matches left against right where both are foreground.

    [Kawashita2012], [Kawashita2014] section 2.1: the background is subtracted from each eye on its
    own and what is left is matched. Each pixel is only searched between the disparity of the
    floor it looks at and that of the tallest person that could stand on that line of sight.
    """

    def __init__(self, lines: SightLines, settings: StereoSettings | None = None) -> None:
        self._settings = settings or StereoSettings()
        near, far = self._settings.nearest_m, self._settings.farthest_m
        self._least = lines.disparity_at_height(0.0, near, far) - _SLACK_PX
        self._most = lines.disparity_at_height(self._settings.tallest_m, near, far) + _SLACK_PX
        self._matcher = cv2.StereoBM.create(16, self._settings.window_px | 1)
        self._matcher.setTextureThreshold(5)
        self._matcher.setUniquenessRatio(3)
        self._matcher.setPreFilterCap(31)

    def match(self, left: Grey, right: Grey, left_mask: Mask, right_mask: Mask) -> Disparity:
        """Disparity of the left eye's foreground.

        Args:
            left, right: (height, width) rectified grey pictures.
            left_mask, right_mask: uint8, non-zero in the foreground.

        Returns:
            (height, width) float32 px; NaN outside the foreground and where nothing matched.
        """
        disparity = np.full(left.shape, np.nan, np.float32)
        x, y, width, height = cv2.boundingRect(left_mask)
        if width == 0 or not right_mask.any():
            return disparity
        rows, columns = slice(y, y + height), slice(x, x + width)
        lowest = int(np.floor(self._least[rows, columns].min()))
        highest = int(np.ceil(self._most[rows, columns].max()))
        found = self._search(left, right, (rows, columns), lowest, highest)
        self._keep_plausible(found, (rows, columns), left_mask, right_mask)
        disparity[rows, columns] = found
        return disparity

    def _search(
        self, left: Grey, right: Grey, window: tuple[slice, slice], lowest: int, highest: int
    ) -> Disparity:
        """Block matching over the window, its disparities in px."""
        count = -(-(highest - lowest + 1) // 16) * 16
        self._matcher.setMinDisparity(lowest)
        self._matcher.setNumDisparities(count)
        rows, columns = window
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
        inner = found[
            rows.start - top : rows.stop - top, before : before + columns.stop - columns.start
        ]
        return inner.astype(np.float32) / _STEPS_PER_PX

    def _keep_plausible(
        self, found: Disparity, window: tuple[slice, slice], left_mask: Mask, right_mask: Mask
    ) -> None:
        """Set to NaN what is not foreground in both eyes or cannot be a person."""
        rows, columns = window
        v, u = np.nonzero(left_mask[rows, columns])
        d = found[v, u]
        partner = np.rint(u + columns.start - d).astype(np.intp)
        inside = (partner >= 0) & (partner < right_mask.shape[1])
        partner[~inside] = 0
        good = inside & (right_mask[v + rows.start, partner] > 0)
        good &= d >= self._least[rows, columns][v, u]
        good &= d <= self._most[rows, columns][v, u]
        found[:] = np.nan
        found[v[good], u[good]] = d[good]
