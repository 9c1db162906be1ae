"""What the doctor looks at: a few frames, images without people, and points in both cameras."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tracking.arrays import Picture
from tracking.doctor.matches import Matches, consistent, match_points
from tracking.progress import Progress
from tracking.recording import Recording

SAMPLES = 12
"""Frames looked at: their median shows no people, and reading them takes about a second."""
_MARGIN = 0.03
"""Share of the recording left out at either end: black, shaky or faded pictures."""


@dataclass(frozen=True, slots=True, eq=False)
class Samples:
    """Frames spread over a recording.

    Attributes:
        numbers: of the frames. lefts, rights: their images, (h, w, 3) uint8; no rights with one
            camera.
    """

    numbers: tuple[int, ...]
    lefts: tuple[Picture, ...]
    rights: tuple[Picture, ...]

    def part(self, start: int, stop: int) -> Samples:
        """Those from start to stop (half-open)."""
        kept = slice(start, stop)
        return Samples(self.numbers[kept], self.lefts[kept], self.rights[kept])


@dataclass(frozen=True, slots=True, eq=False)
class StillPair:
    """Images of both cameras without people, and points that both show."""

    left: Picture
    right: Picture
    matches: Matches


def read_samples(recording: Recording, tell: Progress) -> Samples:
    """A few frames, spread evenly; every one of a very short recording.

    Raises:
        RecordingError: a frame cannot be read.
    """
    last = recording.frame_count - 1
    count = min(SAMPLES, recording.frame_count)
    spread = np.linspace(_MARGIN * last, (1 - _MARGIN) * last, count)
    numbers = sorted({int(number) for number in spread.round()})
    lefts, rights = [], []
    for done, number in enumerate(numbers):
        tell(done, len(numbers))
        frame = recording.read(number)
        lefts.append(frame.left)
        if frame.right is not None:
            rights.append(frame.right)
    tell(len(numbers), len(numbers))
    return Samples(tuple(numbers), tuple(lefts), tuple(rights))


def still_pair(samples: Samples) -> StillPair:
    """Both cameras without people, matched; the samples are of two cameras that stand still."""
    left, right = _still(samples.lefts), _still(samples.rights)
    return StillPair(left, right, consistent(match_points(left, right)))


def _still(images: Sequence[Picture]) -> Picture:
    """The median of each pixel: where people pass, the floor behind them."""
    return np.asarray(np.median(np.stack(images), axis=0), np.uint8)
