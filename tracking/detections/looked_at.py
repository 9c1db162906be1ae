"""Boxes of the frame that was looked at last, of whatever looks at pictures."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tracking.arrays import Mask
from tracking.detections.settings import ONLY, DetectionSettings
from tracking.detections.table import are_in_region, suppress_overlaps
from tracking.people.detection_source import FrameDetections
from tracking.recording import StereoFrame
from tracking.tracks import NETWORK_BOX_COLUMNS, Columns, empty
from tracking.tracks.columns import box_columns


class LookedAt:
    """Keeps the boxes of one frame: what looks at pictures derives from it.

    Args:
        settings: which of the boxes are used.
        both: whether the right camera is looked at, too.
        looked_at: the region of interest in the left picture, see `Recording`; None: everywhere.

    Attributes:
        pictures, count: how many pictures were looked at so far, and boxes found in them.
    """

    def __init__(
        self, settings: DetectionSettings, *, both: bool, looked_at: Mask | None = None
    ) -> None:
        self.settings, self._both, self._looked_at = settings, both, looked_at
        self._left: dict[int, FrameDetections] = {}
        self._right: dict[int, FrameDetections] = {}
        self.pictures = self.count = 0

    def pictures_of(self, frame: StereoFrame) -> list[np.ndarray]:
        """The pictures to look at, the left one first."""
        right = frame.right if self._both and frame.right_lag is not None else None
        return [frame.left] if right is None else [frame.left, right]

    def keep(self, frame: StereoFrame, found: Sequence[FrameDetections]) -> None:
        """The boxes of a frame, of each of its pictures that were looked at."""
        chosen = [suppress_overlaps(boxes, self.settings.max_overlap) for boxes in found]
        if self._looked_at is not None:
            left = are_in_region(chosen[0].box, self._looked_at)
            chosen[0] = FrameDetections(chosen[0].box[left], chosen[0].score[left])
        self._left = {frame.number: chosen[0]}
        self._right = {frame.number + (frame.right_lag or 0): chosen[1]} if len(chosen) > 1 else {}
        self.pictures += len(chosen)
        self.count += sum(map(len, chosen))

    @property
    def detections_only(self) -> bool:
        """Whether no people are looked for in the foreground beside them."""
        return self.settings.use == ONLY

    def of(self, frame: int) -> FrameDetections:
        """The boxes of the left camera; raises KeyError for a frame not looked at just now."""
        return self._left[frame]

    def of_right(self, frame: int) -> FrameDetections | None:
        """Those of the right camera; None where it was not looked at."""
        return self._right.get(frame)

    @property
    def boxes(self) -> Columns:
        """`NETWORK_BOX_COLUMNS` of the frame that was looked at last, as a run keeps them."""
        parts = [
            {
                **box_columns(found.box),
                "camera": np.full(len(found), camera, np.uint8),
                "score": found.score,
            }
            for camera, frames in enumerate((self._left, self._right))
            for found in frames.values()
        ]
        none = empty(NETWORK_BOX_COLUMNS)
        return {
            name: np.concatenate([column, *(part[name] for part in parts)], dtype=column.dtype)
            for name, column in none.items()
        }
