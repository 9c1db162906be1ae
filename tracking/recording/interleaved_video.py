"""Both cameras in one video by turns: rows by turns in each image, or images by turns."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.errors import RecordingError
from tracking.recording.frame import Image
from tracking.recording.pictures import PictureSource, beside
from tracking.translation import Message

_LEAST_ROWS = 4


def field_of(image: Image, phase: int) -> Image:
    """Every other row of an image, at the image's full height.

    Rows between are interpolated, so that what is seen stays where the lens has it.

    Args:
        image: (height, width, 3). phase: 0 for the even rows, 1 for the odd ones.
    """
    height, width = image.shape[:2]
    place = np.array([[1.0, 0.0, 0.0], [0.0, 2.0, float(phase)]])
    stretched = cv2.warpAffine(
        np.ascontiguousarray(image[phase::2]),
        place,
        (width, height),
        flags=cv2.INTER_LINEAR,
        borderMode=cv2.BORDER_REPLICATE,
    )
    return np.asarray(stretched, np.uint8)


def check_rows(source: PictureSource) -> None:
    """Raise RecordingError where images have too few rows for two cameras."""
    width, height = source.size
    if height < _LEAST_ROWS:
        raise RecordingError(
            "{name}: {width} x {height} px cannot hold both cameras",
            name=source.name,
            width=width,
            height=height,
        )


class _EveryOther:
    """Every other image of a source, as one camera's; see `PictureSource`."""

    def __init__(self, source: PictureSource, phase: int) -> None:
        self._source, self._phase = source, phase
        self.frame_count = source.frame_count // 2

    @property
    def name(self) -> str:
        return self._source.name

    @property
    def size(self) -> tuple[int, int]:
        return self._source.size

    @property
    def fps(self) -> float | None:
        return None if self._source.fps is None else self._source.fps / 2

    @property
    def times_s(self) -> NDArray[np.float64] | None:
        times = self._source.times_s
        if times is None:
            return None
        own = times[self._phase :: 2][: self.frame_count]
        return np.asarray(own - own[0])

    @property
    def stamps_ns(self) -> NDArray[np.int64] | None:
        stamps = self._source.stamps_ns
        return None if stamps is None else stamps[self._phase :: 2][: self.frame_count]

    @property
    def files(self) -> tuple[Path, ...]:
        return self._source.files

    @property
    def notes(self) -> tuple[Message, ...]:
        return self._source.notes

    def read(self, number: int) -> Image:
        return self._source.read(2 * number + self._phase)

    def pictures(self, start: int, stop: int) -> Iterator[Image]:
        for row, image in enumerate(self._source.pictures(2 * start, 2 * stop)):
            if row % 2 == self._phase:
                yield image

    def close(self) -> None:
        self._source.close()


class ImagesByTurns:
    """A source whose images are of either camera by turns; see `ImagePairs`.

    The second camera's image is half a frame later than the first one's.

    Args:
        left_first: image 0 is the left camera's.

    Raises:
        RecordingError: there are not two images.
    """

    def __init__(self, source: PictureSource, *, left_first: bool) -> None:
        if source.frame_count < 2:
            raise RecordingError(
                "{name}: one image cannot hold both cameras by turns", name=source.name
            )
        self._left = _EveryOther(source, 0 if left_first else 1)
        self._right = _EveryOther(source, 1 if left_first else 0)
        self._source, self._left_first = source, left_first
        self.sources: tuple[PictureSource, ...] = (self._left,)
        self.is_stereo = True
        self.frame_count = self._left.frame_count
        self.size = source.size
        self.notes: tuple[Message, ...] = ()

    def read(self, number: int, right_number: int) -> tuple[Image, Image | None]:
        """One image of each camera."""
        return self._left.read(number), self._right.read(right_number)

    def pairs(self, start: int, stop: int, lag: int = 0) -> Iterator[tuple[Image, Image | None]]:
        """Pairs start to stop in order."""
        if stop <= start:
            return
        if lag == 0:
            images = self._source.pictures(2 * start, 2 * stop)
            for one, other in zip(images, images, strict=True):
                yield (one, other) if self._left_first else (other, one)
            return
        partners = (np.arange(start, stop) + lag).clip(0, self.frame_count - 1)
        yield from beside(self._left.pictures(start, stop), self._right, partners)
