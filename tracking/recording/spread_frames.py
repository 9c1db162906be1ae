"""Frames spread evenly over a recording."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tracking.progress import Progress, no_progress


def spread_frames(frame_count: int, most: int, progress: Progress = no_progress) -> Iterator[int]:
    """Numbers of frames, first and last among them; all of a short recording.

    Args:
        most: frames, at most. progress: told of each once it is worked on.
    """
    spread = np.linspace(0, frame_count - 1, min(most, frame_count))
    numbers = np.unique(spread.astype(int)).tolist()
    for done, number in enumerate(numbers, 1):
        yield number
        progress(done, len(numbers))
