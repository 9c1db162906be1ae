"""Where people walked, as counting reads it: by track, then by frame, only known places."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tracking.arrays import Flags, Floats, Integers
from tracking.errors import CountingError

_FLOOR = ("x", "y")
_BOX = ("left", "top", "width", "height")


@dataclass(frozen=True, slots=True, eq=False)
class Paths:
    """The places of all tracks, sorted by track, then by frame; rows without a place are left out.

    Attributes:
        track, frame: (n,) whose and when; frames from 0.
        place: (n, 2) x, y in metres on the floor, or u, v in pixels of the left image as recorded.
    """

    track: Integers
    frame: Integers
    place: Floats

    @classmethod
    def on_floor(cls, columns: Mapping[str, ArrayLike]) -> Paths:
        """The places on the floor of any table with `frame, track, x, y`; in any order.

        Raises CountingError where a track stands twice in one frame.
        """
        places = _stacked(columns, _FLOOR)
        return cls._sorted(columns, places)

    @classmethod
    def in_picture(cls, columns: Mapping[str, ArrayLike]) -> Paths:
        """The foot of each box: the middle of its lower edge.

        Raises CountingError where a track stands twice in one frame.
        """
        left, top, width, height = _stacked(columns, _BOX).T
        return cls._sorted(columns, np.column_stack((left + width / 2, top + height)))

    @classmethod
    def _sorted(cls, columns: Mapping[str, ArrayLike], places: Floats) -> Paths:
        track = np.asarray(columns["track"]).astype(np.int64)
        frame = np.asarray(columns["frame"]).astype(np.int64)
        known = np.isfinite(places).all(axis=1)
        track, frame, places = track[known], frame[known], places[known]
        if not _in_order(track, frame):
            order = np.lexsort((frame, track))
            track, frame, places = track[order], frame[order], places[order]
        again = np.flatnonzero((np.diff(track) == 0) & (np.diff(frame) == 0))
        if len(again):
            raise CountingError(
                "track {track} stands twice in frame {frame} (from 0); remove one of its rows",
                track=track[again[0]],
                frame=frame[again[0]],
            )
        return cls(track, frame, places)

    def __len__(self) -> int:
        """The number of places."""
        return len(self.frame)

    @property
    def goes_on(self) -> Flags:
        """(n,) whether the row before is of the same track."""
        same = np.zeros(len(self), bool)
        same[1:] = self.track[1:] == self.track[:-1]
        return same

    @property
    def first_row(self) -> Integers:
        """(n,) the number of the first row of each row's track."""
        begins = np.where(self.goes_on, 0, np.arange(len(self)))
        return np.maximum.accumulate(begins) if len(self) else begins


def _stacked(columns: Mapping[str, ArrayLike], names: tuple[str, ...]) -> Floats:
    """(n, k) float64 the named columns side by side; NaN where the table lacks them."""
    count = len(np.asarray(columns["frame"]))
    if not all(name in columns for name in names):
        return np.full((count, len(names)), np.nan)
    parts: list[NDArray[Any]] = [np.asarray(columns[name]) for name in names]
    return np.stack([part.astype(np.float64) for part in parts], axis=1)


def _in_order(track: Integers, frame: Integers) -> bool:
    further = np.diff(track)
    return bool(((further > 0) | ((further == 0) & (np.diff(frame) >= 0))).all())
