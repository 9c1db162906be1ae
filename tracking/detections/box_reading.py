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


class BoxReading:
    """Collects the boxes of one file; invalid ones are told and left out.

    Attributes:
        reading: the file as messages name it, with the rows that are invalid.
        no_score: a file that has this as the score of all its boxes tells none.
    """

    def __init__(self, reading: Reading) -> None:
        self.reading = reading
        self.no_score = np.nan
        self._frames: list[Integers] = []
        self._boxes: list[Floats] = []
        self._scores: list[Floats] = []
        self._count = 0

    def add(
        self, frame: Floats, box: Floats, score: Floats, place_of: Callable[[int], str]
    ) -> None:
        """Some boxes.

        Args:
            frame: (n,) from 0. box: (n, 4) in 0-based px. score: (n,) NaN where none is told.
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

    def table(self) -> BoxTable:
        """All boxes that are valid.

        Raises FormatError where there is none.
        """
        if not self._count:
            raise self._nothing()
        score = np.concatenate(self._scores)
        known = np.isfinite(score)
        if not known.any() or (score == self.no_score).all():
            score = np.ones(len(score))
        else:
            score[~known] = score[known].min()
        return BoxTable.sorted_by_frame(
            np.concatenate(self._frames), np.concatenate(self._boxes), score
        )

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
    yield frame % 1 != 0, msg("the frame must be a whole number")
    yield (
        (frame < 0) | (frame >= MAX_FRAME),
        msg("the frame number is not one of {max_frame} frames", max_frame=MAX_FRAME),
    )
    far, flat = np.abs(box) > MAX_PIXELS, box[:, 2:] <= 0
    yield np.logical_or.reduce(far, axis=1), msg("the box lies outside any image")
    yield np.logical_or.reduce(flat, axis=1), msg("the box has no size")
    yield np.abs(score) > MAX_SHARE, msg("the score is no such number")
