"""Which frame of a recording a picture is, by what files of detections call it."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tracking.arrays import Integers
from tracking.recording import Recording
from tracking.translation import Message, msg

_MOST_DIGITS = 9
_NUMBER = re.compile(r"[0-9]+")


@dataclass(frozen=True, slots=True)
class Footage:
    """What is known of the pictures that boxes are of.

    Attributes:
        frames: how many there are. size_px: width and height of each.
        pictures: the names of image files without endings, by frame; none of a video.
    """

    frames: int
    size_px: tuple[int, int]
    pictures: tuple[str, ...] = ()

    @classmethod
    def of(cls, recording: Recording, *, right: bool = False) -> Footage:
        """The left (or only) camera of a recording, or its right one."""
        files = recording.picture_files(right=right)
        by_frame = len(files) == recording.frame_count > 1  # else a video's
        names = tuple(file.stem for file in files) if by_frame else ()
        return cls(recording.frame_count, recording.size, names)

    def frames_of_numbers(self, number: Integers) -> tuple[Integers, Message]:
        """(n,) frames of numbers that count pictures, and what to tell of it.

        They count from 1, as tools do, unless there is a 0.
        """
        first = 0 if not len(number) or number.min() < 1 else 1
        told = msg("its pictures are counted from {first}: number {first} is frame 0", first=first)
        return number - first, told

    def frames_of_names(self, names: Sequence[str]) -> tuple[Integers, Message]:
        """(n,) frames of pictures by their names without endings; -1 where a name tells none.

        The names of the recording's own pictures; else the last number in each.
        """
        own = {name: frame for frame, name in enumerate(self.pictures)}
        if own and names and sum(name in own for name in names) * 2 > len(names):
            return np.array([own.get(name, -1) for name in names], np.int64), Message()
        number = np.array([_last_number(name) for name in names], np.int64)
        known = number >= 0
        frames = np.full(len(names), -1, np.int64)
        frames[known], told = self.frames_of_numbers(number[known])
        return frames, told


def _last_number(name: str) -> int:
    """-1 where there is none, or one no picture has."""
    found = _NUMBER.findall(name)
    return int(found[-1]) if found and len(found[-1].lstrip("0")) <= _MOST_DIGITS else -1
