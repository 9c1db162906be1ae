"""Which frame of a recording a picture is, by what files of detections call it."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tracking.arrays import Integers
from tracking.recording import Recording

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

    def numbers_of_names(self, names: Sequence[str]) -> tuple[Integers, bool]:
        """(n,) numbers of pictures by their names without endings; -1 where a name tells none.

        Those of the recording's own pictures are their frames; else it is the last number in each,
        which counts pictures from 0 or from 1. Returns also whether it does.
        """
        own = {name: frame for frame, name in enumerate(self.pictures)}
        if own and names and sum(name in own for name in names) * 2 > len(names):
            return np.array([own.get(name, -1) for name in names], np.int64), False
        return np.array([_last_number(name) for name in names], np.int64), True


def _last_number(name: str) -> int:
    """-1 where there is none, or one no picture has."""
    found = _NUMBER.findall(name)
    return int(found[-1]) if found and len(found[-1].lstrip("0")) <= _MOST_DIGITS else -1
