"""How alike two rows are, and which rows of a frame may be one person."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Protocol

import numpy as np

from tracking.errors import FormatError, SettingsError
from tracking.scoring.table import Flags, Floats, Integers, ScoringTable

EPS = float(np.finfo(np.float64).eps)
_PAIRS_AT_ONCE = 1 << 20


class Match(Protocol):
    """A way to say how alike two rows are."""

    @property
    def threshold(self) -> float:
        """Rows at least this alike may be one person."""

    def similarity(self, truth: ScoringTable, result: ScoringTable, pairs: Rows) -> Floats:
        """(k,) 0 to 1 for each pair of rows; 0 where it cannot be said."""

    def require(self, table: ScoringTable, side: str) -> None:
        """Refuse a table whose rows have nothing to be matched by; `side` is its name."""


@dataclass(frozen=True, slots=True)
class Rows:
    """Pairs of rows: (k,) row numbers of the truth and of the result."""

    truth: Integers
    result: Integers


@dataclass(frozen=True, slots=True)
class BoxMatch:
    """Boxes in the image, by intersection over union.

    Attributes:
        threshold: least overlap of one person's boxes.
        first_pixel: the number the first pixel bears where corners are added up. It only tells
            how sums round, and so whether an overlap right on the threshold is on it: 1 as for
            tools that read MOTChallenge's files as they are, 0 for those that subtract 1 first.
    """

    threshold: float = 0.5
    first_pixel: float = 1.0

    def __post_init__(self) -> None:
        if not 0 < self.threshold <= 1:
            raise SettingsError(f"overlap {self.threshold} is not in 0 to 1; 0.5 is usual")

    def similarity(self, truth: ScoringTable, result: ScoringTable, pairs: Rows) -> Floats:
        """Intersection over union of the boxes."""
        a_low, a_high = _corners(truth.box[pairs.truth], self.first_pixel)
        b_low, b_high = _corners(result.box[pairs.result], self.first_pixel)
        overlap = np.maximum(np.minimum(a_high, b_high) - np.maximum(a_low, b_low), 0)
        shared = overlap[:, 0] * overlap[:, 1]
        a_area, b_area = _area(a_high - a_low), _area(b_high - b_low)
        union = a_area + b_area - shared
        real = (a_area > EPS) & (b_area > EPS) & (union > EPS)  # False for NaN
        return np.asarray(np.divide(shared, union, out=np.zeros(len(union)), where=real))

    def require(self, table: ScoringTable, side: str) -> None:
        """Boxes are asked for."""
        if len(table) and np.isnan(table.box).any(axis=1).all():
            raise FormatError(f"the {side} has no boxes; match by floor distance (--match floor)")


@dataclass(frozen=True, slots=True)
class FloorMatch:
    """Positions on the floor, by distance.

    Attributes:
        radius_m: greatest distance of one person's positions.
    """

    radius_m: float = 0.5
    threshold: float = field(default=0.5, init=False)

    def __post_init__(self) -> None:
        if not 0 < self.radius_m < np.inf:
            raise SettingsError(f"radius {self.radius_m} m is not above 0; 0.5 is usual")

    def similarity(self, truth: ScoringTable, result: ScoringTable, pairs: Rows) -> Floats:
        """1 at the same place, 0.5 at the radius, 0 from twice the radius on."""
        apart = truth.position[pairs.truth] - result.position[pairs.result]
        distance_m = np.hypot(apart[:, 0], apart[:, 1])
        alike = np.maximum(0.0, 1.0 - distance_m / (2.0 * self.radius_m))
        return np.where(np.isnan(alike), 0.0, alike)

    def require(self, table: ScoringTable, side: str) -> None:
        """Positions are asked for."""
        if len(table) and np.isnan(table.position).any(axis=1).all():
            raise FormatError(f"the {side} has no floor positions; match by boxes (--match box)")


@dataclass(frozen=True, slots=True)
class Frames:
    """Where the frames that hold rows on both sides begin and end in the two tables.

    Attributes:
        truth, result: (f,) first row of a frame. truth_end, result_end: (f,) the row after.
    """

    truth: Integers
    truth_end: Integers
    result: Integers
    result_end: Integers

    @classmethod
    def shared(cls, truth: ScoringTable, result: ScoringTable) -> Frames:
        """The frames with rows on both sides, in order."""
        frames = np.intersect1d(truth.frame, result.frame)
        return cls(
            np.searchsorted(truth.frame, frames, "left"),
            np.searchsorted(truth.frame, frames, "right"),
            np.searchsorted(result.frame, frames, "left"),
            np.searchsorted(result.frame, frames, "right"),
        )

    def shape(self, number: int) -> tuple[int, int]:
        """Rows of the truth and of the result in the shared frame of that number."""
        return (
            int(self.truth_end[number] - self.truth[number]),
            int(self.result_end[number] - self.result[number]),
        )


@dataclass(frozen=True, slots=True)
class Candidates:
    """Pairs of rows of the same frame that are at all alike, by frame, truth row, result row.

    Attributes:
        rows: row numbers.
        similarity: (k,) above 0.
        frame: (k,) number of the shared frame, see `Frames`.
    """

    rows: Rows
    similarity: Floats
    frame: Integers

    def __len__(self) -> int:
        """The number of pairs."""
        return len(self.similarity)

    def some(self, kept: Flags) -> Candidates:
        """The marked pairs."""
        rows = Rows(self.rows.truth[kept], self.rows.result[kept])
        return Candidates(rows, self.similarity[kept], self.frame[kept])


def candidates(
    truth: ScoringTable, result: ScoringTable, frames: Frames, match: Match
) -> Candidates:
    """All pairs within a frame whose similarity is above 0."""
    found = [_alike(truth, result, frames, match, stretch) for stretch in _stretches(frames)]
    return Candidates(
        Rows(
            _joined([part.rows.truth for part in found]),
            _joined([part.rows.result for part in found]),
        ),
        np.concatenate([np.zeros(0), *(part.similarity for part in found)]),
        _joined([part.frame for part in found]),
    )


def _joined(parts: list[Integers]) -> Integers:
    return np.concatenate([np.zeros(0, np.int64), *parts])


def _stretches(frames: Frames) -> Iterator[Integers]:
    """Frame numbers in stretches with a bounded number of pairs."""
    pairs = (frames.truth_end - frames.truth) * (frames.result_end - frames.result)
    block = np.cumsum(pairs) // _PAIRS_AT_ONCE
    cuts = np.flatnonzero(np.diff(block)) + 1
    return iter(np.split(np.arange(len(pairs)), cuts))


def _alike(
    truth: ScoringTable, result: ScoringTable, frames: Frames, match: Match, stretch: Integers
) -> Candidates:
    """The pairs of a stretch of frames, of which the alike are kept."""
    width = (frames.result_end - frames.result)[stretch]
    count = (frames.truth_end - frames.truth)[stretch] * width
    frame = np.repeat(stretch, count)
    within = np.arange(len(frame)) - np.repeat(np.cumsum(count) - count, count)
    down, across = np.divmod(within, np.repeat(width, count))
    rows = Rows(frames.truth[frame] + down, frames.result[frame] + across)
    pairs = Candidates(rows, match.similarity(truth, result, rows), frame)
    return pairs.some(pairs.similarity > 0)


def _corners(box: Floats, first_pixel: float) -> tuple[Floats, Floats]:
    """(n, 2) upper left and lower right corners."""
    low = box[:, :2] + first_pixel
    return low, low + box[:, 2:]


def _area(size: Floats) -> Floats:
    return np.asarray(size[:, 0] * size[:, 1])
