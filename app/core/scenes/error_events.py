"""Errors as a user meets them: many misses of one person in a row are one stretch."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.core.i18n import tr
from tracking.scoring import NOBODY, ErrorKind, ErrorTable

Integers = NDArray[np.int64]
_ONE_BY_ONE = (ErrorKind.SWITCH, ErrorKind.FRAGMENTATION)


@dataclass(frozen=True, slots=True, eq=False)
class ErrorEvents:
    """Stretches of errors by their first frame; switches and fragmentations stand alone.

    Attributes:
        kind: (n,) see `ErrorKind`. start, end: (n,) half-open frames.
        truth, result, earlier: (n,) ids, `NOBODY` for none; see `ErrorTable`.
    """

    kind: NDArray[np.uint8]
    start: Integers
    end: Integers
    truth: Integers
    result: Integers
    earlier: Integers

    def __len__(self) -> int:
        return len(self.kind)

    def rows(self, kept: NDArray[np.bool_] | Integers) -> ErrorEvents:
        """Some of them."""
        return ErrorEvents(
            self.kind[kept],
            self.start[kept],
            self.end[kept],
            self.truth[kept],
            self.result[kept],
            self.earlier[kept],
        )

    def of_kinds(self, kinds: Collection[ErrorKind]) -> ErrorEvents:
        """Those of some kinds."""
        return self.rows(np.isin(self.kind, [int(kind) for kind in kinds]))

    def at(self, first: int, end: int) -> ErrorEvents:
        """Those of which a part lies in a half-open range of frames."""
        return self.rows((self.start < end) & (self.end > first))

    def next_start(self, frame: int, step: int) -> int | None:
        """The nearest first frame of any after (step 1) or before (-1) a frame; None: no more."""
        starts = self.start[self.start > frame] if step > 0 else self.start[self.start < frame]
        return int(starts[0] if step > 0 else starts[-1]) if len(starts) else None

    def beginning_at(self, frame: int) -> ErrorEvents:
        """Those whose first frame it is."""
        return self.rows(self.start == frame)

    def words(self) -> list[str]:
        """What each of them is."""
        columns = (self.kind, self.start, self.end, self.truth, self.result, self.earlier)
        rows = zip(*(column.tolist() for column in columns), strict=True)
        return [_said(*row) for row in rows]

    @property
    def tracks(self) -> list[int]:
        """The result's tracks they are about, each once."""
        both = np.concatenate((self.result, self.earlier))
        named: list[int] = [track for track in both.tolist() if track != NOBODY]
        return list(dict.fromkeys(named))


def events_of(errors: ErrorTable) -> ErrorEvents:
    """The errors as stretches, by first frame, then kind."""
    order = np.lexsort((errors.frame, errors.result, errors.truth, errors.kind))
    kind, frame = errors.kind[order], errors.frame[order]
    truth, result = errors.truth[order], errors.result[order]
    goes_on = ~np.isin(kind, [int(one) for one in _ONE_BY_ONE])
    begins = np.ones(len(order), bool)
    begins[1:] = (
        (np.diff(kind.astype(np.int64)) != 0)
        | (np.diff(truth) != 0)
        | (np.diff(result) != 0)
        | (np.diff(frame) != 1)
        | ~goes_on[1:]
    )
    first = np.flatnonzero(begins)
    last = np.append(first[1:], len(order)) - 1 if len(order) else first
    earlier = errors.earlier[order][first]
    found = ErrorEvents(
        kind[first], frame[first], frame[last] + 1, truth[first], result[first], earlier
    )
    return found.rows(np.lexsort((found.kind, found.start)))


def _said(kind: int, start: int, end: int, truth: int, result: int, earlier: int) -> str:
    last = end - 1
    many = end - start > 1
    if kind == ErrorKind.SWITCH:
        return tr(
            "person {truth} changes from track {earlier} to {result}",
            truth=truth,
            earlier=earlier,
            result=result,
        )
    if kind == ErrorKind.FRAGMENTATION:
        return tr("person {truth} is found again as track {result}", truth=truth, result=result)
    if kind == ErrorKind.MISS:
        said = tr("person {truth} is missed")
        long = tr("person {truth} is missed in frames {start} to {last}")
        return (long if many else said).format(truth=truth, start=start, last=last)
    said = tr("track {result} is a false alarm")
    long = tr("track {result} is a false alarm in frames {start} to {last}")
    return (long if many else said).format(result=result, start=start, last=last)
