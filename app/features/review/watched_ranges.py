"""What a person has watched: the stretch just now, and how much of the footage in all."""

from __future__ import annotations

import numpy as np

_FARTHEST_STEP_S = 1.0


class WatchedRanges:
    """Follows which frames were shown one after the other.

    Playing and stepping go on with a stretch, a jump of more than a second begins another one.
    """

    def __init__(self, frame_count: int, fps: float) -> None:
        self._fps = fps
        self._farthest = max(1, round(_FARTHEST_STEP_S * fps))
        self._seen = np.zeros(frame_count, bool)
        self._stretch = (0, 0)
        self._last: int | None = None

    @property
    def stretch(self) -> tuple[int, int]:
        """The half-open range of frames watched without a jump; (0, 0) before there is any."""
        start, end = self._stretch
        return self._stretch if end - start > 1 else (0, 0)

    @property
    def minutes(self) -> float:
        """How much of the footage was watched; what was seen twice counts once."""
        return float(np.count_nonzero(self._seen)) / self._fps / 60.0

    def saw(self, frame: int) -> None:
        """A frame is shown."""
        last, self._last = self._last, frame
        if last is None or abs(frame - last) > self._farthest:
            self._stretch = (frame, frame + 1)
            return
        low, high = min(frame, last), max(frame, last) + 1
        self._seen[low:high] = True
        self._stretch = (min(self._stretch[0], low), max(self._stretch[1], high))
