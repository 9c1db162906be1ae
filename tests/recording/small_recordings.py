"""Small recordings of numbered pictures, and what is expected of them."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
from numbered_videos import number_in, numbered_picture, write_video

from tracking.geometry import Camera, StereoCalibration
from tracking.recording import Recording

COUNT = 12
RIGHT_OFFSET = 100
"""The right camera's pictures carry their number plus this."""


def numbers_of(recording: Recording) -> list[tuple[int, int | None]]:
    """Numbers drawn into the left and the right picture of all frames, read in order."""
    return [
        (number_in(f.left), None if f.right is None else number_in(f.right))
        for f in recording.frames()
    ]


def pairs(count: int = COUNT) -> list[tuple[int, int | None]]:
    return [(n, n + RIGHT_OFFSET) for n in range(count)]


def ones(count: int = COUNT) -> list[tuple[int, int | None]]:
    return [(n, None) for n in range(count)]


def write_images(folder: Path, numbers: range | list[int], offset: int = 0) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    for number in numbers:
        cv2.imwrite(str(folder / f"{number:06d}.png"), numbered_picture(number + offset))
    return folder


def write_pair(folder: Path, right_count: int = COUNT) -> None:
    write_video(folder / "left.mp4", range(COUNT))
    write_video(folder / "right.mp4", range(RIGHT_OFFSET, RIGHT_OFFSET + right_count))


def rig(size: tuple[int, int] = (128, 96)) -> StereoCalibration:
    matrix = np.array([[100.0, 0, 64], [0, 100, 48], [0, 0, 1]])
    camera = Camera(matrix, np.zeros(5), *size)
    return StereoCalibration(camera, camera, np.eye(3), np.array([-0.1, 0, 0]))
