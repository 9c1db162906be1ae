"""Recordings whose right camera fails or lags, made of sound ones."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tests.benchmarks.kept_results import beside
from tracking.recording import Recording, open_recording
from tracking.recording.frame import Image
from tracking.synthesis.video import VideoWriter

_RIGHT = "right.mp4"


@dataclass(frozen=True, slots=True)
class Trouble:
    """A fault of the right camera: it is late throughout, or fails for some seconds.

    Attributes:
        name: in tables and of folders.
        lag: frames by which it is late; negative: it is ahead of the left one.
        dark: it shows black.
        still: it shows its last picture.
        start_s, end_s: half-open, when it is dark or still.
    """

    name: str
    lag: int = 0
    dark: bool = False
    still: bool = False
    start_s: float = 0.0
    end_s: float = np.inf

    def shown(self, number: int, fps: float) -> int:
        """Which of the right camera's pictures is shown in a frame; -1: none."""
        failing = self.start_s <= number / fps < self.end_s
        if failing and self.dark:
            return -1
        if failing and self.still:
            number = round(self.start_s * fps) - 1
        return max(0, number - self.lag)


TROUBLES = (
    Trouble("right camera two frames late", lag=2),
    Trouble("right camera twelve frames late", lag=12),
    Trouble("right camera eight frames ahead", lag=-8),
    Trouble("right camera dark for four seconds", dark=True, start_s=12.0, end_s=16.0),
    Trouble("right camera stands still for four seconds", still=True, start_s=12.0, end_s=16.0),
    Trouble(
        "right camera twelve frames late, and still for four seconds",
        lag=12,
        still=True,
        start_s=12.0,
        end_s=16.0,
    ),
)


def troubled(folder: Path, trouble: Trouble) -> Path:
    """A copy of a rendered recording whose right camera is troubled, made once, beside it."""
    made = beside(folder, trouble, Path(__file__))
    if made.is_dir():
        return made
    with tempfile.TemporaryDirectory(dir=folder.parent) as part:
        copy = Path(part) / made.name
        shutil.copytree(folder, copy, ignore=shutil.ignore_patterns(_RIGHT))
        with open_recording(folder) as recording:
            _write(copy / _RIGHT, recording, trouble)
        copy.replace(made)
    return made


def _write(path: Path, recording: Recording, trouble: Trouble) -> None:
    with VideoWriter(path, recording.size, recording.fps) as video:
        for picture in _pictures(recording, trouble):
            video.write(picture)


def _pictures(recording: Recording, trouble: Trouble) -> Iterator[Image]:
    """What the right camera shows, frame by frame."""
    dark = np.zeros((recording.size[1], recording.size[0], 3), np.uint8)
    last, picture = -1, dark
    for frame in range(recording.frame_count):
        number = min(trouble.shown(frame, recording.fps), recording.frame_count - 1)
        if number not in (-1, last):
            right = recording.read(number).right
            assert right is not None
            last, picture = number, right
        yield dark if number < 0 else picture
