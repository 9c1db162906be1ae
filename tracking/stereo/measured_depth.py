"""Range from a depth picture, in the place of block matching."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Mask
from tracking.geometry import Rectification
from tracking.stereo.settings import StereoSettings
from tracking.stereo.sight_lines import SightLines
from tracking.stereo.subtraction import STEP, Disparity, disparities_of_people, slack_of

_SCENE_SHARE = 0.25
"""Of disparities seen at a pixel, this share is of the scene at the least: people stand before
it."""
_FOLLOW = 0.1
"""By this share of a change the scene follows what is seen, a look."""


class MeasuredDepth:
    """Depth as disparities on the grid of `SubtractionStereo`, and what of them is people.

    Args:
        rectification: of the left camera and its imagined partner (`depth_pair`).
        lines: sight lines of that pair, at the working scale.
        settings: which distances count.

    Attributes:
        scene: (rows, columns) px of the empty scene on the pixels [::STEP, ::STEP]; NaN: unknown.
    """

    def __init__(
        self,
        rectification: Rectification,
        lines: SightLines,
        settings: StereoSettings | None = None,
    ) -> None:
        self._lines = lines
        self._least, self._most = disparities_of_people(lines, settings or StereoSettings())
        self._place, self._outside = _recorded_places(rectification, lines)
        self.scene: Disparity = np.full_like(self._least, np.nan)

    def disparity(self, depth: NDArray[np.float32]) -> Disparity:
        """(rows, columns) working px of a depth picture (height, width) m; NaN where unknown."""
        seen = depth.ravel().take(self._place)
        seen[self._outside | ~(seen > 0)] = np.nan
        return np.asarray(self._lines.focal_baseline / seen + self._lines.offset, np.float32)

    def learn_scene(self, disparities: Sequence[Disparity]) -> None:
        """Take the scene from pictures spread over some time: people are nearer than it."""
        stack = np.sort(np.stack(disparities), axis=0)  # NaN comes last
        known = np.isfinite(stack).sum(axis=0)
        place = (_SCENE_SHARE * np.maximum(known - 1, 0)).astype(np.intp)
        self.scene = np.take_along_axis(stack, place[None], axis=0)[0]

    def follow_scene(self, disparity: Disparity, people: Mask) -> None:
        """Let the scene follow slow changes.

        Args:
            disparity: of this frame. people: (rows, columns) non-zero where nothing is learnt.
        """
        seen = (people == 0) & np.isfinite(disparity)
        change = _FOLLOW * (disparity - self.scene)
        followed = np.where(np.isfinite(self.scene), self.scene + change, disparity)
        self.scene = np.where(seen, followed, self.scene).astype(np.float32)

    def match(self, disparity: Disparity, mask: Mask) -> Disparity:
        """The disparity of the foreground, NaN elsewhere and on the scene itself.

        Args:
            disparity: of the frame. mask: (height, width) uint8, non-zero in the foreground.
        """
        kept = (mask[::STEP, ::STEP] != 0) & (disparity >= self._least) & (disparity <= self._most)
        kept &= ~(np.abs(disparity - self.scene) < slack_of(self.scene, self._lines))
        return np.where(kept, disparity, np.float32(np.nan))


def _recorded_places(
    rectification: Rectification, lines: SightLines
) -> tuple[NDArray[np.intp], NDArray[np.bool_]]:
    """(rows, columns) where in a recorded picture, row by row, the grid lies; and where outside.

    The nearest pixel is taken: depth between two things is of neither.
    """
    height, width = lines.shape
    u, v = np.meshgrid(np.arange(0, width, STEP), np.arange(0, height, STEP))
    grid = (np.column_stack((u.ravel(), v.ravel())) + 0.5) * float(lines.shrink) - 0.5
    recorded = np.nan_to_num(rectification.recorded_from_rectified(grid.astype(float)), nan=-1.0)
    pixel = np.floor(recorded + 0.5).astype(np.intp)
    size = np.array(rectification.size)
    outside = ((pixel < 0) | (pixel >= size)).any(axis=1)
    inside = pixel.clip(0, size - 1)
    place = inside[:, 1] * size[0] + inside[:, 0]
    return place.reshape(u.shape), outside.reshape(u.shape)
