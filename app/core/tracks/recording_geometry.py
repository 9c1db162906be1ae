"""The recording as edits of boxes and places need it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.editing import standing_box
from tracking.geometry import View
from tracking.recording import Recording
from tracking.tracks import Box, Columns

Place = tuple[float, float]
"""x, y in metres on the floor."""

_BODY_M = 1.7
"""Height of a person nobody has measured."""
_WHERE = (0.5, 0.6)
"""Where their feet are put in the picture at first, as shares of its size."""
_BOX = (0.46, 0.35, 0.08, 0.3)
"""The same as a box, where there are no metres."""
_SMALLEST_PX = 4.0


@dataclass(frozen=True, slots=True, eq=False)
class RecordingGeometry:
    """The recording as edits need it.

    Attributes:
        view: the left camera over its floor; None: there are no metres.
        frame_count, fps, size: of the recording; size is width and height in px.
    """

    view: View | None
    frame_count: int
    fps: float
    size: tuple[int, int]

    @classmethod
    def of(cls, recording: Recording) -> RecordingGeometry:
        """That of a recording."""
        return cls(recording.view, recording.frame_count, recording.fps, recording.size)

    def first_box(self) -> Box:
        """A box to begin with where nothing is known: a person in the middle of the picture."""
        standing = self._standing_box()
        if standing is not None:
            return standing
        width, height = self.size
        return _BOX[0] * width, _BOX[1] * height, _BOX[2] * width, _BOX[3] * height

    def _standing_box(self) -> Box | None:
        """Of somebody who stands in the picture's middle; None where no floor is seen there."""
        if self.view is None:
            return None
        feet = np.array([[_WHERE[0] * self.size[0], _WHERE[1] * self.size[1]]])
        x, y = self.view.floor_from_pixel(feet)[0].tolist()
        if not np.isfinite(x + y):
            return None
        box = standing_box(self.view, (x, y), _BODY_M)
        fits = np.isfinite(box).all() and _SMALLEST_PX < box[3] < self.size[1]
        return box if fits else None

    def kept_inside(self, box: Box) -> Box:
        """The box with a part of it inside the picture, and not smaller than can be seen."""
        width, height = max(box[2], _SMALLEST_PX), max(box[3], _SMALLEST_PX)
        left = min(max(box[0], _SMALLEST_PX - width), self.size[0] - _SMALLEST_PX)
        top = min(max(box[1], _SMALLEST_PX - height), self.size[1] - _SMALLEST_PX)
        return left, top, width, height


def box_of(row: Columns) -> Box:
    """The box of a single row."""
    left, top, width, height = (float(row[name][0]) for name in ("left", "top", "width", "height"))
    return left, top, width, height
