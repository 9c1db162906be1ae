"""The columns a comparison needs, checked at the door."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Flags, Floats, Integers
from tracking.errors import FormatError
from tracking.tracks.columns import Columns

_WHOLE = 1 << 62
"""A frame and a track fit into one number below this."""


_PERSON = 1
_DISTRACTORS = (2, 7, 8, 12)
"""People on vehicles, people who never move, distractors, reflections."""

_Flags = NDArray[np.bool_]


@dataclass(frozen=True, slots=True)
class ScoringTable:
    """Tracks to be compared, sorted by frame; rows of one frame keep their order.

    Attributes:
        frame: (n,) from 0.
        track: (n,) ids.
        box: (n, 4) left, top, width, height in pixels, 0-based; NaN where unknown.
        position: (n, 2) x, y on the floor in metres; NaN where unknown.
        counted: (n,) False for rows that are neither found nor missed.
        dont_care: (n,) which of those take a result row that matches them away; None: all.
        confidence: (n,) how sure the tracker is; None where nobody says.
    """

    frame: Integers
    track: Integers
    box: Floats
    position: Floats
    counted: Flags
    confidence: Floats | None = None
    dont_care: Flags | None = None

    @property
    def placed(self) -> bool:
        """Whether a row has a position on the floor."""
        return not np.isnan(self.position).all()

    @classmethod
    def from_columns(cls, columns: Columns, *, dont_cares: bool = False) -> ScoringTable:
        """The table of a session's or a file's columns.

        Args:
            columns: `frame, track, left, top, width, height` and, where known, `x, y` and
                `confidence`.
            dont_cares: rows with `confidence` 0 are don't-cares, as in MOT text used as truth;
                see `rows_that_count` for truth with classes.

        Raises:
            FormatError: an id stands twice in one frame.
        """
        order = _by_frame(columns["frame"])
        counted, ignored = np.ones(len(columns["frame"]), bool), None
        if dont_cares and "confidence" in columns:
            counted, ignored = rows_that_count(columns)
        table = cls(
            frame=columns["frame"][order].astype(np.int64),
            track=columns["track"][order].astype(np.int64),
            box=_stacked(columns, ("left", "top", "width", "height"), order),
            position=_stacked(columns, ("x", "y"), order),
            counted=counted[order],
            confidence=_column(columns, "confidence", order),
            dont_care=None if ignored is None else ignored[order],
        )
        table._refuse_repeated()
        return table

    def __len__(self) -> int:
        """The number of rows."""
        return len(self.frame)

    def rows(self, kept: Flags | slice) -> ScoringTable:
        """The table of some of its rows."""
        return ScoringTable(
            self.frame[kept],
            self.track[kept],
            self.box[kept],
            self.position[kept],
            self.counted[kept],
            None if self.confidence is None else self.confidence[kept],
            None if self.dont_care is None else self.dont_care[kept],
        )

    def within(self, start: int, stop: int) -> ScoringTable:
        """The table of the frames start to stop - 1, counted from start on."""
        part = self.rows((self.frame >= start) & (self.frame < stop))
        return replace(part, frame=part.frame - start)

    def _refuse_repeated(self) -> None:
        if not len(self) or not self._repeats():
            return
        order = np.lexsort((self.track, self.frame))
        frame, track = self.frame[order], self.track[order]
        twice = np.flatnonzero((np.diff(frame) == 0) & (np.diff(track) == 0))
        if not len(twice):
            return
        first = twice[0]
        raise FormatError(
            "track {track} stands twice in frame {frame} (from 0); remove one of its rows",
            track=track[first],
            frame=frame[first],
        )

    def _repeats(self) -> bool:
        """Whether an id may stand twice in one frame."""
        least = int(self.track.min())
        ids = int(self.track.max()) - least + 1
        if abs(int(self.frame[-1])) >= _WHOLE // ids or abs(int(self.frame[0])) >= _WHOLE // ids:
            return True
        both = np.sort(self.frame * ids + (self.track - least))
        return bool((both[1:] == both[:-1]).any())


def _by_frame(frame: NDArray[Any]) -> Integers | slice:
    """What puts the rows in order of frames; those of one stay in order."""
    if (frame[1:] >= frame[:-1]).all():
        return slice(None)
    return np.argsort(frame, kind="stable")


def _column(columns: Columns, name: str, order: Integers | slice) -> Floats | None:
    return columns[name][order].astype(np.float64) if name in columns else None


def _stacked(columns: Columns, names: tuple[str, ...], order: Integers | slice) -> Floats:
    """(n, k) the named columns side by side; NaN, not to be written to, where they are missing."""
    stacked = (len(columns["frame"]), len(names))
    if not all(name in columns for name in names):
        return np.broadcast_to(np.nan, stacked)
    found = np.empty(stacked)
    for place, name in enumerate(names):
        found[:, place] = columns[name][order]
    return found


def rows_that_count(columns: Columns) -> tuple[_Flags, _Flags | None]:
    """What a truth's `confidence` and `class` say of its rows.

    Without classes rows with `confidence` 0 are don't-cares. With classes it is as TrackEval has
    it: people whose `confidence` is not 0 count, distractors are don't-cares, and all else neither
    counts nor takes a result row away.

    Args:
        columns: `confidence` and, where known, `class`; NaN: none.

    Returns:
        (n,) rows that count; (n,) don't-cares, None where they are all the others.
    """
    counted = np.asarray(columns["confidence"] != 0)
    kind = columns.get("class")
    if kind is None or np.isnan(kind).all():
        return counted, None
    person = (kind == _PERSON) | np.isnan(kind)
    return np.asarray(counted & person), np.isin(kind, _DISTRACTORS)
