"""Which lanes are shown, in which order and how high."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

import numpy as np
from numpy.typing import NDArray

from app.core.plots.axis import TimeAxis
from app.core.plots.strips import spans_in_view
from app.core.scenes import Lane


class LaneOrder(Enum):
    """What lanes are sorted by."""

    FIRST_FRAME = "first"
    NUMBER = "number"


class LaneHeight(Enum):
    """How high a lane is, in lines of text."""

    LOW = 0.6
    MIDDLE = 1.45
    HIGH = 2.2


@dataclass(frozen=True, slots=True)
class Arrangement:
    """The user's choice of lanes. `in_view_only`: those with rows among the frames shown."""

    order: LaneOrder = LaneOrder.FIRST_FRAME
    in_view_only: bool = False
    height: LaneHeight = LaneHeight.MIDDLE


class LaneRows:
    """The lanes of a scene as rows; a thousand are sorted and sifted in a moment."""

    def __init__(self) -> None:
        self._lanes: tuple[Lane, ...] = ()
        self._lives: NDArray[np.int64] = np.zeros((0, 2), np.int64)
        self._shown: NDArray[np.int64] = np.zeros(0, np.int64)

    def __len__(self) -> int:
        return len(self._shown)

    def take(self, lanes: tuple[Lane, ...]) -> None:
        """Take other lanes; they are shown once they are arranged."""
        self._lanes = lanes
        self._lives = np.array([_life(lane) for lane in lanes], np.int64).reshape(-1, 2)

    def arrange(self, arrangement: Arrangement, axis: TimeAxis) -> None:
        """Sort and sift them."""
        shown = np.arange(len(self._lanes))
        if arrangement.order is LaneOrder.NUMBER:
            shown = np.argsort([lane.track for lane in self._lanes], kind="stable")
        if arrangement.in_view_only:
            overlaps = self._lives[:, 0] < axis.start + axis.frames
            overlaps &= self._lives[:, 1] > axis.start
            # Who is selected is never taken out of sight.
            overlaps |= np.array([lane.selected for lane in self._lanes], np.bool_)
            shown = shown[overlaps[shown]]
            shown = shown[[self._is_in_view(self._lanes[at], axis) for at in shown]]
        self._shown = shown

    def lane(self, row: int) -> Lane | None:
        """The lane of a row; None below the last."""
        return self._lanes[int(self._shown[row])] if 0 <= row < len(self._shown) else None

    def row_of(self, track: int) -> int | None:
        """The row of a track; None where it is not shown."""
        rows = (row for row, at in enumerate(self._shown) if self._lanes[at].track == track)
        return next(rows, None)

    def living_at(self, frame: int) -> NDArray[np.int64]:
        """The rows of those whose life spans a frame."""
        lives = self._lives[self._shown]
        return np.flatnonzero((lives[:, 0] <= frame) & (frame < lives[:, 1]))

    @staticmethod
    def _is_in_view(lane: Lane, axis: TimeAxis) -> bool:
        return lane.selected or len(spans_in_view(lane.spans, axis)) > 0


def _life(lane: Lane) -> tuple[int, int]:
    return (int(lane.spans[0, 0]), int(lane.spans[-1, 1])) if len(lane.spans) else (0, 0)
