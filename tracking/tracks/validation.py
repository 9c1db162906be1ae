"""Tables are checked once, at the door; behind it nobody asks again."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tracking.errors import EditError
from tracking.tracks.columns import Columns, Types
from tracking.translation import joined

LARGEST_NUMBER = 2**31 - 1
"""Frames and track ids are 32-bit integers in the file; one past the last frame fits, too."""


def checked_columns(
    columns: Mapping[str, ArrayLike], types: Types, what: str = "table"
) -> dict[str, NDArray[Any]]:
    """The columns as 1-D arrays of equal length and of the given types; others are left out.

    Raises EditError where a column is missing, has another length, or holds numbers its type
    cannot (NaN or fractions where whole numbers belong).
    """
    missing = [name for name in types if name not in columns]
    if missing:
        raise EditError(
            "{what}: column {column} is missing; needed are {types}",
            what=what,
            column=missing[0],
            types=joined(", ", types),
        )
    checked = {name: _column(columns[name], types[name], name, what) for name in types}
    lengths = {name: len(column) for name, column in checked.items()}
    if len(set(lengths.values())) > 1:
        raise EditError(
            "{what}: the columns have different lengths: {lengths}", what=what, lengths=lengths
        )
    return checked


def _column(values: ArrayLike, dtype: np.dtype[Any], name: str, what: str) -> NDArray[Any]:
    array = np.asarray(values)
    if array.ndim != 1:
        raise EditError(
            "{what}: column {name} has shape {shape}; one number a row is needed",
            what=what,
            name=name,
            shape=array.shape,
        )
    if array.dtype.kind not in "iufb":
        raise EditError(
            "{what}: column {name} holds {dtype}; numbers are needed",
            what=what,
            name=name,
            dtype=array.dtype,
        )
    if dtype.kind in "iu" and array.dtype != dtype:
        _refuse_what_does_not_fit(array, dtype, name, what)
    return array.astype(dtype, copy=False)


def _refuse_what_does_not_fit(
    array: NDArray[Any], dtype: np.dtype[Any], name: str, what: str
) -> None:
    if array.dtype.kind == "f" and not bool(np.all(np.isfinite(array) & (array % 1 == 0))):
        raise EditError(
            "{what}: column {name} holds NaN or fractions; whole numbers are needed",
            what=what,
            name=name,
        )
    limits = np.iinfo(dtype)
    if len(array) and (array.min() < limits.min or array.max() > limits.max):
        raise EditError(
            "{what}: column {name} holds numbers beyond {least}..{most}",
            what=what,
            name=name,
            least=limits.min,
            most=limits.max,
        )


def check_tracks(columns: Columns, what: str = "table") -> None:
    """Raise EditError unless rows are sorted by frame then track, unique, from frame 0, id 1 on."""
    frame, track = columns["frame"], columns["track"]
    if not len(frame):
        return
    if int(frame.min()) < 0:
        raise EditError(
            "{what}: frame {frame} is negative; frames count from 0",
            what=what,
            frame=int(frame.min()),
        )
    if int(frame.max()) >= LARGEST_NUMBER:
        raise EditError(
            "{what}: frame {largest}; frames go up to {last}",
            what=what,
            largest=LARGEST_NUMBER,
            last=LARGEST_NUMBER - 1,
        )
    if int(track.min()) < 1:
        raise EditError(
            "{what}: track id {track}; ids are positive", what=what, track=int(track.min())
        )
    later = frame[1:] > frame[:-1]
    same = frame[1:] == frame[:-1]
    wrong = ~(later | (same & (track[1:] > track[:-1])))
    if not bool(wrong.any()):
        return
    row = int(np.argmax(wrong)) + 1
    if same[row - 1] and track[row] == track[row - 1]:
        raise EditError(
            "{what}: track {track} stands twice in frame {frame}",
            what=what,
            track=track[row],
            frame=frame[row],
        )
    raise EditError(
        "{what}: row {row} is out of order; rows are sorted by frame, then track",
        what=what,
        row=row,
    )


def is_sorted_strictly(numbers: NDArray[Any]) -> bool:
    """Whether each number is larger than the one before."""
    return bool(np.all(numbers[1:] > numbers[:-1]))


def between(frames: NDArray[np.int32], start: int, end: int) -> slice:
    """Where ascending frames lie in the half-open range, as a slice with start and stop."""
    # Bounds of the frames' own type: of any other, NumPy would first convert all the frames.
    bounds = [min(max(number, 0), LARGEST_NUMBER) for number in (start, end)]
    first, last = frames.searchsorted(np.array(bounds, np.int32)).tolist()
    return slice(first, last)
