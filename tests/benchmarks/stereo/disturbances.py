"""Recordings as poorer cameras see them, made of sound ones."""

from __future__ import annotations

import shutil
import tempfile
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np

from tests.benchmarks.kept_results import beside
from tracking.recording import open_recording
from tracking.recording.frame import Image
from tracking.synthesis.video import VideoWriter

_EYES = ("left.mp4", "right.mp4")
_FLICKER_RAD = 2.4
"""From one frame to the next: lamps go on and off faster than cameras take pictures."""


@dataclass(frozen=True, slots=True)
class Disturbance:
    """What is poor about the cameras.

    Attributes:
        name: in tables and of folders.
        noise: standard deviation in both cameras, grey levels.
        flicker: share of the light that comes and goes, at other instants in the other camera.
        blurred_px: standard deviation by which the right camera is out of focus.
        lower_px, turned_deg: by which the right camera is out of level.
    """

    name: str
    noise: float = 0.0
    flicker: float = 0.0
    blurred_px: float = 0.0
    lower_px: float = 0.0
    turned_deg: float = 0.0

    def seen(self, picture: Image, frame: int, side: int) -> Image:
        """A picture as it is seen; camera: 0 left, 1 right."""
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


DISTURBANCES = (
    Disturbance("noise of 6 grey levels", noise=6.0),
    Disturbance("lamps flicker by 4 per cent, unlike in both cameras", flicker=0.04),
    Disturbance("right camera out of focus by 1.2 px", blurred_px=1.2),
    Disturbance("right camera 1 px lower and turned by 0.2 degrees", lower_px=1.0, turned_deg=0.2),
)


def disturbed(folder: Path, disturbance: Disturbance) -> Path:
    """A rendered recording as it is seen with a disturbance, made once, beside it."""
    made = beside(folder, disturbance, Path(__file__))
    if made.is_dir():
        return made
    with tempfile.TemporaryDirectory(dir=folder.parent) as part:
        copy = Path(part) / made.name
        shutil.copytree(folder, copy, ignore=shutil.ignore_patterns(*_EYES))
        _write(copy, folder, disturbance)
        copy.replace(made)
    return made


def _write(copy: Path, folder: Path, disturbance: Disturbance) -> None:
    with open_recording(folder) as recording:
        size, fps = recording.size, recording.fps
        with (
            VideoWriter(copy / _EYES[0], size, fps) as left,
            VideoWriter(copy / _EYES[1], size, fps) as right,
        ):
            for frame in recording.frames(0, recording.frame_count):
                assert frame.right is not None
                left.write(disturbance.seen(frame.left, frame.number, 0))
                right.write(disturbance.seen(frame.right, frame.number, 1))
