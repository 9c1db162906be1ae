"""Recordings as poorer or failing cameras see them, made of sound ones."""

from __future__ import annotations

import hashlib
import shutil
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np

from tracking.recording import Recording, open_recording
from tracking.recording.frame import Image
from tracking.synthesis.video import VideoWriter

_CAMERAS = ("left.mp4", "right.mp4")
_FLICKER_RAD = 2.4
"""From one frame to the next: lamps go on and off faster than cameras take pictures."""


@dataclass(frozen=True, slots=True)
class Trouble:
    """What is wrong with the cameras.

    Attributes:
        name: in tables and of folders.
        lag: frames by which the right camera is late; negative: it is ahead of the left one.
        dark: the right camera shows black.
        still: the right camera shows its last picture.
        start_s, end_s: half-open, when it is dark or still.
        noise: standard deviation in both cameras, grey levels.
        flicker: share of the light that comes and goes, at other instants in the other camera.
        blurred_px: standard deviation by which the right camera is out of focus.
        lower_px, turned_deg: by which the right camera is out of level.
    """

    name: str
    lag: int = 0
    dark: bool = False
    still: bool = False
    start_s: float = 0.0
    end_s: float = np.inf
    noise: float = 0.0
    flicker: float = 0.0
    blurred_px: float = 0.0
    lower_px: float = 0.0
    turned_deg: float = 0.0

    @property
    def is_optical(self) -> bool:
        """Whether pictures look different; else other ones are shown."""
        return any((self.noise, self.flicker, self.blurred_px, self.lower_px, self.turned_deg))

    def shown(self, number: int, fps: float) -> int:
        """Which of the right camera's pictures is shown in a frame; -1: none."""
        failing = self.start_s <= number / fps < self.end_s
        if failing and self.dark:
            return -1
        if failing and self.still:
            number = round(self.start_s * fps) - 1
        return max(0, number - self.lag)

    def seen(self, picture: Image, frame: int, side: int) -> Image:
        """A picture as it is seen; side: 0 left, 1 right."""
        if side and self.blurred_px:
            picture = np.asarray(cv2.GaussianBlur(picture, (0, 0), self.blurred_px), np.uint8)
        if side and (self.lower_px or self.turned_deg):
            picture = self._out_of_level(picture)
        if self.flicker:
            light = 1 + self.flicker * np.sin(_FLICKER_RAD * frame + 0.7 * side)
            picture = np.asarray(cv2.convertScaleAbs(picture, alpha=light), np.uint8)
        if self.noise:
            random = np.random.default_rng((frame, side))
            grain = random.standard_normal(picture.shape, np.float32) * np.float32(self.noise)
            picture = np.rint((picture + grain).clip(0, 255)).astype(np.uint8)
        return picture

    def _out_of_level(self, picture: Image) -> Image:
        size = (picture.shape[1], picture.shape[0])
        moved = cv2.getRotationMatrix2D((size[0] / 2, size[1] / 2), self.turned_deg, 1)
        moved[1, 2] += self.lower_px
        return np.asarray(
            cv2.warpAffine(picture, moved, size, borderMode=cv2.BORDER_REPLICATE), np.uint8
        )


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
    Trouble("noise of 6 grey levels", noise=6.0),
    Trouble("lamps flicker by 4 per cent, unlike in both cameras", flicker=0.04),
    Trouble("right camera out of focus by 1.2 px", blurred_px=1.2),
    Trouble("right camera 1 px lower and turned by 0.2 degrees", lower_px=1.0, turned_deg=0.2),
)


def troubled(folder: Path, trouble: Trouble) -> Path:
    """A copy of a rendered recording whose cameras are troubled, made once, beside it."""
    made = beside(folder, trouble, Path(__file__))
    if made.is_dir():
        return made
    sides = (0, 1) if trouble.is_optical else (1,)
    with tempfile.TemporaryDirectory(dir=folder.parent) as part:
        copy = Path(part) / made.name
        anew = shutil.ignore_patterns(*(_CAMERAS[side] for side in sides))
        shutil.copytree(folder, copy, ignore=anew)
        with open_recording(folder) as recording:
            for side in sides:
                with VideoWriter(copy / _CAMERAS[side], recording.size, recording.fps) as video:
                    for picture in _pictures(recording, trouble, side):
                        video.write(picture)
        copy.replace(made)
    return made


def beside(folder: Path, trouble: Trouble, source: Path) -> Path:
    """Where a clip is kept that is made of another one, by what is done to it and by which code.

    Args:
        folder: of the other one. source: the module that does it.
    """
    said = hashlib.sha256(repr(trouble).encode() + source.read_bytes()).hexdigest()[:8]
    name = trouble.name.replace(" ", "-").replace(",", "")
    return folder.with_name(f"{folder.name}-{name}-{said}")


def _pictures(recording: Recording, trouble: Trouble, side: int) -> Iterator[Image]:
    """What a camera shows, frame by frame."""
    dark = np.zeros((recording.size[1], recording.size[0], 3), np.uint8)
    last, picture = -1, dark
    for frame in range(recording.frame_count):
        shown = trouble.shown(frame, recording.fps) if side else frame
        number = min(shown, recording.frame_count - 1)
        if number not in (-1, last):
            read = recording.read(number)
            last, picture = number, read.right if side else read.left
            assert picture is not None
        yield dark if number < 0 else trouble.seen(picture, frame, side)
