"""Both cameras of a recording, from two sources, one, or one that holds both."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from typing import Literal, Protocol

import numpy as np
from numpy.typing import NDArray

from tracking.errors import RecordingError
from tracking.recording.frame import Image
from tracking.recording.frame_pairs import pair_frames
from tracking.recording.interleaved_video import ImagesByTurns, check_rows, field_of
from tracking.recording.pictures import PictureSource, beside
from tracking.translation import Message

Layout = Literal["side-by-side", "top-bottom", "row-interleaved", "frame-sequential"]
LAYOUTS: tuple[Layout, ...] = ("side-by-side", "top-bottom", "row-interleaved", "frame-sequential")
"""How one source holds both cameras: beside each other, one above the other, rows by turns in each
image, or images by turns."""
Side = Literal["left", "right"]
ImagePair = tuple[Image, Image | None]
MOST_LAG = 60
"""Frames by which a camera may be late at the most: of pictures that hold both cameras, so many
halves wait in memory."""


class ImagePairs(Protocol):
    """Pairs of pictures by number."""

    @property
    def frame_count(self) -> int:
        """The number of pairs."""

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of one camera's pictures in px."""

    @property
    def is_stereo(self) -> bool:
        """Whether there is a right camera."""

    @property
    def sources(self) -> tuple[PictureSource, ...]:
        """What the pictures come from, the left (or only) one first."""

    @property
    def notes(self) -> tuple[Message, ...]:
        """Oddities of the pairing, in words."""

    def read(self, number: int, right_number: int) -> ImagePair:
        """The left picture of one pair and the right one of another; None with one camera."""

    def pairs(self, start: int, stop: int, lag: int = 0) -> Iterator[ImagePair]:
        """Left pictures start to stop (half-open) in order, each with a right one.

        The right picture is that of the pair `lag` later; beyond the first and the last pair,
        that of these.
        """


class OneCamera:
    """A monocular recording; see `ImagePairs`."""

    def __init__(self, source: PictureSource) -> None:
        self.sources: tuple[PictureSource, ...] = (source,)
        self.frame_count = source.frame_count
        self.size = source.size
        self.is_stereo = False
        self.notes: tuple[Message, ...] = ()

    def read(self, number: int, right_number: int) -> ImagePair:  # noqa: ARG002 - as all pairs
        """One picture, and no right one."""
        return self.sources[0].read(number), None

    def pairs(self, start: int, stop: int, lag: int = 0) -> Iterator[ImagePair]:  # noqa: ARG002
        """Pictures start to stop in order."""
        for image in self.sources[0].pictures(start, stop):
            yield image, None


class TwoSources:
    """A source for each camera; see `ImagePairs`.

    Raises:
        RecordingError: the cameras differ in size.
    """

    def __init__(self, left: PictureSource, right: PictureSource) -> None:
        if left.size != right.size:
            raise RecordingError(
                "the cameras differ in size: {name} is {left_width} x {left_height} px, "
                "{right_name} {right_width} x {right_height}; give two of one size",
                name=left.name,
                left_width=left.size[0],
                left_height=left.size[1],
                right_name=right.name,
                right_width=right.size[0],
                right_height=right.size[1],
            )
        pairing = pair_frames(left, right)
        self.sources: tuple[PictureSource, ...] = (left, right)
        self.is_stereo = True
        self.frame_count = len(pairing.right)
        self.size = left.size
        self.notes = pairing.notes
        self._right_number = pairing.right

    def read(self, number: int, right_number: int) -> ImagePair:
        """One picture of each camera."""
        left, right = self.sources
        return left.read(number), right.read(int(self._right_number[right_number]))

    def pairs(self, start: int, stop: int, lag: int = 0) -> Iterator[ImagePair]:
        """Pairs start to stop in order; both sources are read once, and no picture waits."""
        if stop <= start:
            return
        wanted = self._right_number[_partners(start, stop, lag, self.frame_count)]
        yield from beside(self.sources[0].pictures(start, stop), self.sources[1], wanted)


def both_cameras(source: PictureSource, layout: Layout, first: Side) -> ImagePairs:
    """The pairs of one source that holds both cameras.

    Raises:
        RecordingError: its pictures cannot hold two.
    """
    if layout == "frame-sequential":
        return ImagesByTurns(source, left_first=first == "left")
    return SplitSource(source, layout, first)


class SplitSource:
    """One source each of whose pictures holds both cameras; see `ImagePairs`.

    Raises:
        RecordingError: the picture cannot be halved.
    """

    def __init__(self, source: PictureSource, layout: Layout, first: Side) -> None:
        width, height = source.size
        self._beside = layout == "side-by-side"
        self._rows = layout == "row-interleaved"
        self._left_first = first == "left"
        if (width if self._beside else height) < 2:
            raise RecordingError(
                "{name}: {width} x {height} px cannot hold both cameras",
                name=source.name,
                width=width,
                height=height,
            )
        self.sources: tuple[PictureSource, ...] = (source,)
        self.is_stereo = True
        self.frame_count = source.frame_count
        self.size = (width // 2, height) if self._beside else (width, height // 2)
        if self._rows:
            check_rows(source)
            self.size = width, height
        self.notes: tuple[Message, ...] = ()

    def read(self, number: int, right_number: int) -> ImagePair:
        """One picture, cut into its cameras; or each camera of another one."""
        left, right = self._cut(self.sources[0].read(number))
        if right_number != number:
            right = self._cut(self.sources[0].read(right_number))[1]
        return left, right

    def pairs(self, start: int, stop: int, lag: int = 0) -> Iterator[ImagePair]:
        """Images start to stop in order, cut in two; of a late camera's, one waits."""
        if stop <= start:
            return
        partners = _partners(start, stop, lag, self.frame_count)
        first, last = min(start, int(partners[0])), max(stop, int(partners[-1]) + 1)
        pictures = enumerate(self.sources[0].pictures(first, last), first)
        waiting: deque[tuple[int, Image]] = deque()
        newest = first - 1
        for number, partner in enumerate(partners, start):
            while newest < max(number, partner):
                newest, image = next(pictures)
                left, right = self._cut(image)
                if lag and newest >= (start if lag > 0 else partners[0]):
                    # A copy: the half may be a view that keeps the whole picture.
                    waiting.append((newest, (left if lag > 0 else right).copy()))
            while waiting and waiting[0][0] < min(number, partner):
                waiting.popleft()
            yield (
                waiting[0][1] if lag > 0 else left,
                waiting[0][1] if lag < 0 else right,
            )

    def _cut(self, image: Image) -> tuple[Image, Image]:
        if self._rows:
            one, two = field_of(image, 0), field_of(image, 1)
            return (one, two) if self._left_first else (two, one)
        width, height = self.size
        one = image[:height, :width]
        two = image[:height, width : 2 * width] if self._beside else image[height : 2 * height]
        left, right = (one, two) if self._left_first else (two, one)
        return np.ascontiguousarray(left), np.ascontiguousarray(right)


def _partners(start: int, stop: int, lag: int, count: int) -> NDArray[np.intp]:
    """The pair whose right picture goes with each left one."""
    return (np.arange(start, stop) + lag).clip(0, count - 1)
