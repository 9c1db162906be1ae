"""Depth beside the left camera: a picture of 16 bits for each frame."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Protocol

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.errors import RecordingError
from tracking.recording.image_headers import why_not_decoded
from tracking.recording.pictures import PictureSource
from tracking.translation import Message, count_msg, msg

Depth = NDArray[np.float32]
"""(height, width) m along the left camera's optical axis; 0 where it is unknown."""
Units = NDArray[np.uint16]

USUAL_SCALE_M = 0.001
"""Metres of a unit where nothing says otherwise: depth cameras write millimetres."""
LEAST_SCALE_M, MOST_SCALE_M = 1e-6, 1.0
_UNKNOWN = np.iinfo(np.uint16).max
"""What some cameras write, beside 0, where they know no depth."""


class DepthSource(Protocol):
    """Depth by number, from 0, aligned to the left picture of that number."""

    @property
    def name(self) -> str:
        """What it is called in messages."""

    @property
    def frame_count(self) -> int:
        """The number of pictures."""

    @property
    def size(self) -> tuple[int, int]:
        """Width and height in px."""

    @property
    def files(self) -> tuple[Path, ...]:
        """The files it is made of, in order."""

    @property
    def notes(self) -> tuple[Message, ...]:
        """Oddities found up to now, in words."""

    def read(self, number: int) -> Depth:
        """One picture; a broken one is unknown everywhere, and told."""

    def close(self) -> None:
        """Let go of files."""


class DepthImages:
    """Depth pictures that are a file each; see `DepthSource`.

    Args:
        files: the images in order.
        name: what to call them in messages.
        scale_m: metres of a unit.

    Raises:
        RecordingError: there are none, or the first one is not of 16 bits and one channel.
    """

    def __init__(self, files: Sequence[Path], name: str, scale_m: float) -> None:
        if not files:
            raise RecordingError(
                "{name}: no depth images found; check the folder or the pattern", name=name
            )
        self.name = name
        self.files = tuple(files)
        self._scale = np.float32(scale_m)
        self._lost: set[int] = set()
        first = _decoded(self.files[0])
        if first is None:
            raise RecordingError(
                "{path}: cannot be read as an image; check the files of {name}",
                path=self.files[0],
                name=name,
            )
        require_depth(first, str(self.files[0]))
        self.size = (first.shape[1], first.shape[0])

    @property
    def frame_count(self) -> int:
        """The number of images."""
        return len(self.files)

    @property
    def notes(self) -> tuple[Message, ...]:
        """Images found broken up to now."""
        return lost_notes(self.name, self._lost)

    def read(self, number: int) -> Depth:
        """One picture; a broken one, or one of another size, is unknown everywhere."""
        units = _decoded(self.files[number])
        if units is None or units.shape != self.size[::-1] or units.dtype != np.uint16:
            self._lost.add(number)
            return np.zeros(self.size[::-1], np.float32)
        return depth_of_units(units.astype(np.uint16, copy=False), self._scale)

    def close(self) -> None:
        """Nothing is held open."""


def depth_of_units(units: Units, scale_m: np.float32) -> Depth:
    """Metres of what a depth camera wrote."""
    depth = units * scale_m
    depth[units == _UNKNOWN] = 0
    return np.asarray(depth, np.float32)


def require_depth(picture: NDArray[np.generic], where: str) -> None:
    """Raises RecordingError for what is no picture of 16 bits and one channel."""
    channels = 1 if picture.ndim == 2 else picture.shape[2]
    if channels != 1 or picture.dtype != np.uint16:
        raise RecordingError(
            "{where}: depth needs one channel of 16 bits, this image has {channels} of {bits}; "
            "export the depth itself, not a view of it",
            where=where,
            channels=channels,
            bits=8 * picture.dtype.itemsize,
        )


def check_fits(depth: DepthSource, left: PictureSource) -> None:
    """Raises RecordingError where depth is not that of each left picture."""
    if depth.size != left.size:
        raise RecordingError(
            "the depth {name} is {width} x {height} px, the left camera {left_width} x "
            "{left_height}; give depth that is aligned to the left image",
            name=depth.name,
            width=depth.size[0],
            height=depth.size[1],
            left_width=left.size[0],
            left_height=left.size[1],
        )
    if depth.frame_count != left.frame_count:
        raise RecordingError(
            "the depth {name} has {count} images, the left camera {left_count} frames; give one "
            "for each frame, all 0 where there is none",
            name=depth.name,
            count=depth.frame_count,
            left_count=left.frame_count,
        )


def checked_scale(scale_m: float, where: str) -> float:
    """The scale itself; RecordingError where no depth has it, NaN too."""
    if not LEAST_SCALE_M <= scale_m <= MOST_SCALE_M:
        raise RecordingError(
            "{where} must be {least:g} to {most:g} m per unit; 0.001 where depth is in millimetres",
            where=where,
            least=LEAST_SCALE_M,
            most=MOST_SCALE_M,
        )
    return scale_m


def lost_notes(name: str, lost: set[int]) -> tuple[Message, ...]:
    """What is told of pictures that were broken."""
    if not lost:
        return ()
    images = count_msg(len(lost), "{n} depth image", "{n} depth images")
    return (
        msg(
            "{name}: {images} broken or of another size, first {first}; no depth is known there",
            name=name,
            images=images,
            first=min(lost),
        ),
    )


def _decoded(file: Path) -> NDArray[np.generic] | None:
    """The image as stored; None where it cannot be read."""
    try:
        if why_not_decoded(file):
            return None
        image = cv2.imdecode(np.fromfile(file, np.uint8), cv2.IMREAD_UNCHANGED)
    except (OSError, cv2.error):
        return None
    return None if image is None else np.asarray(image)
