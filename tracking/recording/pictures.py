"""What every source of pictures gives, whatever it is made of."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from pathlib import Path
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from tracking.errors import RecordingError
from tracking.recording.frame import Image
from tracking.translation import Message, count_msg, msg


def check_number(name: str | Path, number: int, count: int) -> None:
    """Raise RecordingError where a source of so many pictures has none of that number."""
    if not 0 <= number < count:
        raise RecordingError(
            "{name}: frame {number} is not among 0 to {last}",
            name=name,
            number=number,
            last=count - 1,
        )


def broken_frames(name: str, lost: Collection[int]) -> Message:
    """Tells of the frames, at least one, that were found broken."""
    return msg(
        "{name}: {frames}, first {first}; the image before is shown",
        name=name,
        frames=count_msg(len(lost), "{n} broken frame", "{n} broken frames"),
        first=min(lost),
    )


def broken_images(name: str, count: int, first: str) -> Message:
    """Tells of so many image files, the first of that name, that were found broken."""
    return msg(
        "{name}: {images} broken or of another size, first {first}; the image before is shown",
        name=name,
        images=count_msg(count, "{n} image", "{n} images"),
        first=first,
    )


def beside(
    lefts: Iterable[Image], right: PictureSource, numbers: NDArray[np.intp]
) -> Iterator[tuple[Image, Image]]:
    """Left pictures, each with the right one of its number; `right` is read once.

    Args:
        numbers: at least one, ascending; those of the right pictures.
    """
    first, last = int(numbers[0]), int(numbers[-1])
    rights = enumerate(right.pictures(first, last + 1), first)
    number, image = next(rights)
    for left, target in zip(lefts, numbers, strict=True):
        while number < target:
            number, image = next(rights)
        yield left, image


class PictureSource(Protocol):
    """Pictures by number, from 0; all of one size. Reads may come from several threads."""

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
    def fps(self) -> float | None:
        """Pictures a second as the source says; None where it does not."""

    @property
    def times_s(self) -> NDArray[np.float64] | None:
        """(frame_count,) seconds since the first picture; None where the source has no times."""

    @property
    def stamps_ns(self) -> NDArray[np.int64] | None:
        """(frame_count,) ns on a clock that the cameras share; None where there is none."""

    @property
    def files(self) -> tuple[Path, ...]:
        """The files it is made of, in order."""

    @property
    def notes(self) -> tuple[Message, ...]:
        """Oddities found up to now, in words."""

    def read(self, number: int) -> Image:
        """One picture. A broken one is shown as the last good one before it, and told."""

    def pictures(self, start: int, stop: int) -> Iterator[Image]:
        """Pictures start to stop (half-open) in order, read apart from `read`."""

    def close(self) -> None:
        """Let go of files."""
