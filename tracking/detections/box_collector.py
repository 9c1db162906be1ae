"""What every reader of detections collects: boxes as they come, and what is wrong with some."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from tracking.arrays import Flags, Floats, Integers
from tracking.detections.table import BoxTable
from tracking.errors import FormatError
from tracking.formats.read_result import MOST_BAD, Reading
from tracking.formats.row_rules import MAX_FRAME, MAX_PIXELS, MAX_SHARE
from tracking.translation import Message, msg

MOST_IN_ALL = 5_000_000
"""Boxes of one camera: a hundred in each frame of half an hour."""


class BoxCollector:
    """Collects the boxes of one file; invalid ones are told and left out.

    Attributes:
        reading: the file as messages name it, with the rows that are invalid.
        held: what the file holds; nothing of a folder.
        files: what each file of a folder holds, by its name; none of a file.
        no_score: a score that stands for none.
        counts_pixels: corners count from where pictures do, which is from 1 in this format.
        counts_pictures: frames are numbers that count pictures, from 0 or from 1.
        has_zero: one of these is 0.
    """

    def __init__(self, reading: Reading) -> None:
        self.reading = reading
        self.held, self.files = b"", dict[str, bytes]()
        self.no_score = np.nan
        self.counts_pixels = self.counts_pictures = self.has_zero = False
        self._frames: list[Integers] = []
        self._boxes: list[Floats] = []
        self._scores: list[Floats] = []
        self._count = 0

    def count(self, number: Floats | Integers) -> None:
        """(n,) numbers that count pictures, all of them, also of those without boxes."""
        self.counts_pictures = True
        self.has_zero |= bool((number == 0).any())

    def add(
        self, frame: Floats, box: Floats, score: Floats, place_of: Callable[[int], str]
    ) -> None:
        """Some boxes.

        Args:
            frame: (n,) from 0, or what counts pictures. box: (n, 4) in px. score: (n,) NaN where
                none is told.
            place_of: where in the file one of them stands.

        Raises FormatError where there are more than `MOST_IN_ALL`, or hardly any is valid.
        """
        good = np.ones(len(frame), np.bool_)
        for wrong, reason in _broken_rules(frame, box, score):
            for row in np.flatnonzero(wrong & good)[: MOST_BAD + 1].tolist():
                self.reading.bad(place_of(row), reason)
            good &= ~wrong
        self._count += int(good.sum())
        if self._count > MOST_IN_ALL:
            raise FormatError(
                "{path} has more than {most} boxes; split it first",
                path=self.reading.path,
                most=MOST_IN_ALL,
            )
        self._frames.append(frame[good].astype(np.int64))
        self._boxes.append(box[good])
        self._scores.append(score[good])

    def table(self, first: int) -> BoxTable:
        """All boxes that are valid, where pictures are counted from `first`.

        Boxes without a score are as sure as half of the others. Raises FormatError where there is
        no box.
        """
        if not self._count:
            raise self._nothing()
        frame, box = np.concatenate(self._frames), np.concatenate(self._boxes)
        if self.counts_pictures:
            frame -= first
            if not self.counts_pixels or first == 0:
                self.reading.notes.append(
                    msg(
                        "its pictures are counted from {first}: number {first} is frame 0",
                        first=first,
                    )
                )
        if self.counts_pixels:
            box[:, :2] -= first
        score = np.concatenate(self._scores)
        known = np.isfinite(score) & (score != self.no_score)
        score[~known] = np.median(score[known]) if known.any() else 1.0
        return BoxTable.sorted_by_frame(frame, box, score)

    def _nothing(self) -> FormatError:
        if not self.reading.bad_count:
            return FormatError("{path} holds no boxes", "give another", path=self.reading.path)
        first = self.reading.bad_rows[0]
        return FormatError(
            "{path}: none of its boxes can be used, the first in {place}: {reason}",
            path=self.reading.path,
            place=first.place,
            reason=first.reason,
        )


def _broken_rules(frame: Floats, box: Floats, score: Floats) -> Iterator[tuple[Flags, Message]]:
    """Marks of boxes that break a rule, and the rule; each may rely on those before it."""
    finite = np.isfinite(frame) & np.isfinite(box).all(axis=1) & ~np.isinf(score)
    yield ~finite, msg("a value is not a finite number")
    yield np.floor(frame) != frame, msg("the frame must be a whole number")
    yield (
        (frame < 0) | (frame >= MAX_FRAME),
        msg("the frame number is not one of {max_frame} frames", max_frame=MAX_FRAME),
    )
    far, flat = np.abs(box) > MAX_PIXELS, box[:, 2:] <= 0
    yield np.logical_or.reduce(far, axis=1), msg("the box lies outside any image")
    yield np.logical_or.reduce(flat, axis=1), msg("the box has no size")
    yield np.abs(score) > MAX_SHARE, msg("the score is no such number")
