"""A region of Label Studio's on its way to this program's rows; see `label_studio`."""

from __future__ import annotations

import re
from array import array
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.formats.filled_rows import held_until
from tracking.formats.json_numbers import number_of, whole_of
from tracking.formats.label_text import label_of, unescaped
from tracking.formats.row_rules import BOX, MAX_FRAME
from tracking.tracks import LARGEST_NUMBER, Source, TrackLabel
from tracking.translation import joined, msg

FIRST_FRAME = 1
PERCENT = 100.0
PREDICTION = "prediction"
"""The origin of a region that a model made and nobody changed."""
TRACK_PREFIX = "track-"
"""A region written here is called by it and the track's id."""

COLON_WITHIN = ":(?= )"
"""In an attribute's key: it would be told for its end."""
_SIDES = ("x", "y", "width", "height")
_TRACK_ID = re.compile(rf"(?:{TRACK_PREFIX})?(\d{{1,10}})")
_FULL_TURN = 360.0
_SHOWN_AS = 3
"""Whole numbers kept of a keyframe: its frame, whether it is enabled, and its number."""
_NUMBERS = len(BOX) + 2
"""And its sides, turn and time."""


@dataclass(frozen=True, slots=True)
class ShownRows:
    """The rows in which a region is in view.

    Attributes:
        frame: (n,) from 0, ascending. boxes: (n, 4) left, top, width and height in percent, and
            turn: (n,) degrees around the top left corner. keyframe: (n,) the number of the
            keyframe a row is, -1 between two.
    """

    frame: NDArray[np.int64]
    boxes: Floats
    turn: Floats
    keyframe: NDArray[np.int64]


@dataclass(slots=True)
class Region:
    """What a file says of one region.

    Attributes:
        place: in the file, as messages name it. said, value: its members that are kept.
    """

    place: str
    said: dict[str, Any] = field(default_factory=dict)
    value: dict[str, Any] = field(default_factory=dict)
    _whole: array[int] = field(default_factory=lambda: array("q"))
    _numbers: array[float] = field(default_factory=lambda: array("d"))

    def take(self, number: int, keyframe: Any) -> str:
        """Add a keyframe; says why it is invalid where it is."""
        if not isinstance(keyframe, Mapping):
            return msg("is no object")
        frame = whole_of(keyframe.get("frame"))
        if frame is None or not FIRST_FRAME <= frame < MAX_FRAME:
            return msg(
                "its frame is not one of {max_frame}, counted from {first_frame}",
                max_frame=MAX_FRAME,
                first_frame=FIRST_FRAME,
            )
        sides = [number_of(keyframe.get(name)) for name in _SIDES]
        turn = number_of(keyframe.get("rotation", 0))
        known = [side for side in (*sides, turn) if side is not None]
        if len(known) <= len(_SIDES):
            return msg("{sides} and rotation are not five numbers", sides=joined(", ", _SIDES))
        if min(known[2:4]) < 0:
            return msg("the box has a negative size")
        time = number_of(keyframe.get("time"))
        self._whole.extend((frame - FIRST_FRAME, keyframe.get("enabled", True) is True, number))
        self._numbers.extend((*known, np.nan if time is None else time))
        return ""

    @property
    def keyframes(self) -> int:
        """How many it has."""
        return len(self._whole) // _SHOWN_AS

    @property
    def kept_id(self) -> int | None:
        """The id that its name keeps; None where it is called otherwise."""
        found = _TRACK_ID.fullmatch(str(self.said.get("id", "")))
        kept = int(found[1]) if found else 0
        return kept if 0 < kept <= LARGEST_NUMBER else None

    @property
    def frames(self) -> int | None:
        """Of the footage, as Label Studio counts them; None where that is not told."""
        count = whole_of(self.value.get("framesCount"))
        return count if count is not None and 0 < count <= MAX_FRAME else None

    @property
    def fps(self) -> float | None:
        """Frames a second, by the times of its keyframes."""
        whole, numbers = self._columns()
        frame, time = whole[:, 0] + FIRST_FRAME, numbers[:, -1]
        timed = np.flatnonzero(time > 0)
        if not len(timed):
            return None
        last = timed[int(frame[timed].argmax())]
        return round(float(frame[last] / time[last]), 3)

    @property
    def label(self) -> TrackLabel:
        """Its label as a class, and of the texts beside it the name, then attributes."""
        labels, meta = self.value.get("labels"), self.said.get("meta")
        kind = labels[0] if isinstance(labels, list) and labels else ""
        text = meta.get("text", "") if isinstance(meta, dict) else ""
        name, *others = (text if isinstance(text, list) else [text]) or [""]
        about = (other.partition(": ") for other in others if isinstance(other, str))
        attributes = {unescaped(key): value for key, colon, value in about if colon}
        kind = kind if isinstance(kind, str) else ""
        return label_of(name if isinstance(name, str) else "", kind, attributes)

    @property
    def placed(self) -> int:
        """Who placed its keyframes, as `Source` has it."""
        return Source.TRACKER if self.said.get("origin") == PREDICTION else Source.PERSON

    @property
    def size_px(self) -> tuple[int, int] | None:
        """Of the picture, where it tells."""
        sizes = (
            (whole_of(held.get("original_width")), whole_of(held.get("original_height")))
            for held in (self.said, self.value)
        )
        return next(((w, h) for w, h in sizes if w and h and w > 0 and h > 0), None)

    def rows_filled(self, stop: int | None, frames: int | None) -> int:
        """How many rows `shown` makes beside the keyframes themselves."""
        _, lengths = self._spans(stop, frames)
        return int(np.maximum(lengths - 1, 0).sum())

    def shown(self, stop: int | None, frames: int | None) -> ShownRows:
        """The rows in which it is in view.

        Args:
            stop: the frame behind the last one that the file tells; None: unknown.
            frames: of the recording, beyond which nothing is filled; None: unknown.
        """
        whole, numbers = self._columns()
        frame, lengths = self._spans(stop, frames)
        before = np.repeat(np.arange(len(frame)), lengths)
        shown = (
            frame[before]
            + np.arange(len(before))
            - np.repeat(np.cumsum(lengths) - lengths, lengths)
        )
        turn = np.unwrap(numbers[:, len(BOX)], period=_FULL_TURN)  # the shorter way round
        between = [np.interp(shown, frame, column) for column in (*numbers[:, : len(BOX)].T, turn)]
        return ShownRows(
            shown,
            np.column_stack(between[:-1]),
            between[-1],
            np.where(shown == frame[before], whole[before, 2], -1),
        )

    def repeated(self) -> list[int]:
        """The numbers of keyframes whose frame an earlier one has; they are taken out."""
        whole, numbers = self._columns()
        _, first = np.unique(whole[:, 0], return_index=True)
        again = np.setdiff1d(np.arange(len(whole)), first)
        if len(again):
            self._whole = array("q", whole[first].ravel().tolist())
            self._numbers = array("d", numbers[first].ravel().tolist())
        return [int(number) for number in whole[again, 2]]

    def _columns(self) -> tuple[NDArray[np.int64], Floats]:
        """(n, 3) `_SHOWN_AS` and (n, 6) `_NUMBERS`, by frame."""
        whole = np.array(self._whole, np.int64).reshape(-1, _SHOWN_AS)
        order = np.argsort(whole[:, 0], kind="stable")
        return whole[order], np.array(self._numbers).reshape(-1, _NUMBERS)[order]

    def _spans(
        self, stop: int | None, frames: int | None
    ) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """(n,) the frames of keyframes, and in how many frames each is shown from there on."""
        whole, _ = self._columns()
        frame, enabled = whole[:, 0], whole[:, 1].astype(bool)
        lengths = held_until(frame, stop or 0, frames) - frame
        return frame, np.where(enabled, lengths, 1)


def upright(rows: ShownRows, size_px: tuple[int, int]) -> Floats:
    """(n, 4) left, top, width and height in pixels of the upright boxes around those of rows."""
    left, top, width, height = (rows.boxes * np.tile(size_px, 2) / PERCENT).T
    if not rows.turn.any():
        return np.column_stack([left, top, width, height])
    cosine, sine = np.cos(np.radians(rows.turn)), np.sin(np.radians(rows.turn))
    nothing = np.zeros(len(left))
    across = np.stack([nothing, width * cosine, -height * sine, width * cosine - height * sine])
    down = np.stack([nothing, width * sine, height * cosine, width * sine + height * cosine])
    return np.column_stack(
        [left + across.min(0), top + down.min(0), np.ptp(across, axis=0), np.ptp(down, axis=0)]
    )
