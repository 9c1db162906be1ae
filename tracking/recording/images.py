"""A folder of images as pictures by number."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.errors import RecordingError
from tracking.recording.frame import Image
from tracking.recording.image_headers import looks_odd, why_not_decoded
from tracking.recording.pace import pace_of
from tracking.recording.pictures import broken_images, check_number
from tracking.translation import Message, count_msg, msg

IMAGE_SUFFIXES = frozenset(
    (".png", ".jpg", ".jpeg", ".bmp", ".pgm", ".ppm", ".tif", ".tiff", ".webp")
)
VIDEO_SUFFIXES = frozenset(
    (".mp4", ".m4v", ".mov", ".avi", ".mkv", ".webm", ".ts", ".mts", ".m2ts", ".mpg", ".mpeg")
)
_MOST_LOOKED_OVER = 5000
_NUMBER = re.compile(r"(\d+)")


def image_files(files: Sequence[Path]) -> list[Path]:
    """Those that are images, in natural order: 2 before 10."""
    images = [file for file in files if file.suffix.lower() in IMAGE_SUFFIXES]
    return sorted(images, key=_natural)


def frame_numbers(files: Sequence[Path]) -> list[int] | None:
    """The number each file name ends in; None unless all have one and no two the same."""
    found = [_NUMBER.findall(file.stem) for file in files]
    if not all(found):
        return None
    numbers = [int(digits[-1]) for digits in found]
    return numbers if len(set(numbers)) == len(numbers) else None


class ImageSource:
    """Pictures that are a file each; see `PictureSource`.

    Args:
        files: the images in order.
        name: what to call them in messages.
        stamps_ns: when each was taken, increasing; None where nothing says so.

    Raises:
        RecordingError: there are none, or none of the first ones can be read.
    """

    def __init__(
        self, files: Sequence[Path], name: str, stamps_ns: NDArray[np.int64] | None = None
    ) -> None:
        if not files:
            raise RecordingError(
                "{name}: no images found; check the folder or the pattern", name=name
            )
        self.name = name
        self._files = tuple(files)
        self.stamps_ns = stamps_ns
        self._times_s = None if stamps_ns is None else (stamps_ns - stamps_ns[0]) / 1e9
        self._pace = pace_of(self._times_s, None)
        self._size = self._usual_size()
        self._lost: set[int] = set()
        self._look_over()

    @property
    def frame_count(self) -> int:
        """The number of images."""
        return len(self._files)

    @property
    def size(self) -> tuple[int, int]:
        """Width and height in px."""
        return self._size

    @property
    def fps(self) -> float | None:
        """Images a second by their times; None where they have none."""
        return self._pace.fps

    @property
    def times_s(self) -> NDArray[np.float64] | None:
        """(frame_count,) seconds since the first image; None where nothing says so."""
        return self._times_s

    @property
    def files(self) -> tuple[Path, ...]:
        """The images."""
        return self._files

    @property
    def notes(self) -> tuple[Message, ...]:
        """Numbers missing among the file names, and images found broken up to now."""
        notes = [msg("{name}: {note}", name=self.name, note=note) for note in self._pace.notes]
        numbers = frame_numbers(self._files) if self.stamps_ns is None else None
        gaps = numbers[-1] - numbers[0] + 1 - len(numbers) if numbers else 0
        if 0 < gaps < self.frame_count:
            notes.append(
                msg(
                    "{name}: {numbers} missing among the images; frames are counted image by image",
                    name=self.name,
                    numbers=count_msg(gaps, "{n} number", "{n} numbers"),
                )
            )
        if self._lost:
            first = self._files[min(self._lost)].name
            notes.append(broken_images(self.name, len(self._lost), first))
        return tuple(notes)

    def read(self, number: int) -> Image:
        """One image; a broken one is shown as the last good one before it."""
        check_number(self.name, number, self.frame_count)
        for candidate in (*range(number, -1, -1), *range(number + 1, self.frame_count)):
            image = self._good(candidate)
            if image is not None:
                return image
        raise RecordingError(
            "{name}: none of the images can be read; check the files", name=self.name
        )

    def pictures(self, start: int, stop: int) -> Iterator[Image]:
        """Images start to stop (half-open) in order."""
        for number in range(start, stop):
            yield self.read(number)

    def close(self) -> None:
        """Nothing is held open."""

    def _good(self, number: int) -> Image | None:
        if number in self._lost:
            return None
        image = _decoded(self._files[number])
        if image is not None and image.shape[1::-1] == self._size:
            return image
        self._lost.add(number)
        return None

    def _look_over(self) -> None:
        """Find what is broken as far as first bytes tell, so that it is told on opening."""
        step = -(-self.frame_count // _MOST_LOOKED_OVER)
        for number in range(0, self.frame_count, step):
            if looks_odd(self._files[number], self._size):
                self._good(number)

    def _usual_size(self) -> tuple[int, int]:
        """The size most of a few images have: the first may be of another kind."""
        last = len(self._files) - 1
        sample = sorted({min(number, last) for number in (0, 1, 2, last // 2, last)})
        images = (_decoded(self._files[number]) for number in sample)
        sizes = Counter(image.shape[1::-1] for image in images if image is not None)
        if not sizes:
            why = _why_lost(self._files[0])
            raise RecordingError(
                "{path}: {why}; check the files of {name}",
                path=self._files[0],
                why=why,
                name=self.name,
            )
        width, height = sizes.most_common(1)[0][0]
        return width, height


def _decoded(file: Path) -> Image | None:
    """The image in BGR, 8 bits; None where it cannot be read."""
    try:
        if why_not_decoded(file):
            return None
        image = cv2.imdecode(np.fromfile(file, np.uint8), cv2.IMREAD_COLOR)
    except (OSError, cv2.error):
        return None
    return None if image is None else np.asarray(image, np.uint8)


def _why_lost(file: Path) -> str:
    """Why an image cannot be shown, in words that follow the file's name."""
    try:
        return why_not_decoded(file) or msg("cannot be read as an image")
    except OSError as error:
        return msg("cannot be read ({reason})", reason=error.strerror)


def _natural(file: Path) -> list[tuple[int, str]]:
    parts = _NUMBER.split(file.name)  # text and number in turn
    return [(int(part), "") if at % 2 else (-1, part.lower()) for at, part in enumerate(parts)]
