"""Rows between keyframes: how far each keyframe holds, and how many a file may stand for."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tracking.errors import FormatError

MOST_TRACKS = 200_000
"""Of a file that tells tracks by keyframes."""
MOST_FILLED = 4_000_000
"""Rows between the keyframes of a file: two hours of twenty people at 25 frames a second."""


class FilledRows:
    """Counts the rows between the keyframes of a file, before any of them is made."""

    def __init__(self, path: Path) -> None:
        """The file, as the refusal names it."""
        self._path, self._count = path, 0

    def add(self, count: int) -> None:
        """So many more. Raises FormatError where there are more than `MOST_FILLED`."""
        self._count += count
        if self._count > MOST_FILLED:
            raise FormatError(
                "{path}: its keyframes stand for more than {most} boxes between them",
                "check its frame numbers, or split it",
                path=self._path,
                most=MOST_FILLED,
            )


def held_until(frame: NDArray[np.int64], end: int, frames: int | None) -> NDArray[np.int64]:
    """(n,) the frame behind the last one that each keyframe of a track holds for.

    A keyframe holds until the next one, the last one until the end of the footage. No frame
    beyond the recording is filled: there the keyframes stand alone.

    Args:
        frame: (n,) of the keyframes, ascending. end: the frame behind the last one that the file
            tells. frames: of the recording; None: unknown.
    """
    if not len(frame):
        return frame
    stops: NDArray[np.int64] = np.append(frame[1:], max(end, int(frame[-1]) + 1))
    return stops if frames is None else np.minimum(stops, np.maximum(frames, frame + 1))
