"""Which rows of two tables are one person: those that stand at one place in one frame."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Flags, Floats
from tracking.tracks import Columns, row_keys
from tracking.tracks.boxes import overlaps

Indices = NDArray[np.int64]

SAME_M, SAME_OVERLAP = 0.3, 0.5
"""Farther apart than this a person has moved: on the floor, or by overlap of boxes without it."""
HERE_M, HERE_OVERLAP = 0.5, 0.4
"""Farther apart than this two rows are two people."""
_BOXES_BELOW = 0.99
"""Nearly no box is larger than this share's."""
_FARTHEST_CELL = 8000
_ROWS_AT_ONCE = 100_000


@dataclass(frozen=True, slots=True, eq=False)
class Places:
    """Where rows stand.

    Attributes:
        frame: (n,). floor: (n, 2) m, NaN where unknown. box: (n, 4) px.
    """

    frame: NDArray[np.int64]
    floor: Floats
    box: Floats

    @classmethod
    def of(cls, rows: Columns) -> Places:
        """The places of a table's rows."""
        box = [rows[name] for name in ("left", "top", "width", "height")]
        floor = np.column_stack((rows["x"], rows["y"]))
        return cls(rows["frame"].astype(np.int64), floor, np.column_stack(box))

    def some(self, rows: NDArray[np.integer]) -> Places:
        """The places of some of the rows, by number."""
        return Places(self.frame[rows], self.floor[rows], self.box[rows])


def off(one: Places, other: Places, metres: float, overlap: float) -> Floats:
    """(n,) how far pairs of rows are apart: up to 1 they are as near as asked for.

    On the floor where both places are known there, else by what their boxes have in common.
    """
    apart = one.floor - other.floor
    on_floor = np.hypot(apart[:, 0], apart[:, 1]) / metres
    unknown = np.flatnonzero(np.isnan(on_floor))
    if len(unknown):
        shared = overlaps(one.box[unknown], other.box[unknown])
        on_floor[unknown] = (1.0 - shared) / (1.0 - overlap)
    return on_floor


def counterparts(one: Places, other: Places) -> Indices:
    """(n,) for each row of `one` the row of `other` that is the same person; -1: none.

    Two rows are one person where each is the nearest of the other side to the other.
    """
    found = np.full(len(one.frame), -1)
    if not len(one.frame) or not len(other.frame):
        return found
    parts = list(_near_pairs(one, other))
    row, mate, away = (np.concatenate(column) for column in zip(*parts, strict=True))
    # Written farthest first, so that the nearest one stands in the end.
    order = np.argsort(-away, kind="stable")
    row, mate, pair = row[order], mate[order], np.arange(len(order))
    of_row, of_mate = np.zeros(len(one.frame), np.int64), np.zeros(len(other.frame), np.int64)
    of_row[row], of_mate[mate] = pair, pair
    both = (of_row[row] == pair) & (of_mate[mate] == pair)
    found[row[both]] = mate[both]
    return found


def same_keys(found: Columns, corrected: Columns) -> Indices:
    """(found,) the corrected row of the same id and frame; -1: none. Both sides are sorted."""
    mine, theirs = _keys(found), _keys(corrected)
    place = np.searchsorted(theirs, mine)
    there = np.append(theirs, -1)[place] == mine
    return np.where(there, place, -1)


def _keys(rows: Columns) -> Indices:
    return row_keys(rows["frame"], rows["track"])


def mates(found: Columns, corrected: Columns, own: Indices) -> tuple[Indices, Flags]:
    """(found,) the corrected row of the same person, and whether it has the same id and place.

    Args:
        own: (found,) the corrected row of the same id and frame; -1: none.
    """
    mate = np.full(len(own), -1)
    here, there = Places.of(found), Places.of(corrected)
    pairs = np.flatnonzero(own >= 0)
    near = off(here.some(pairs), there.some(own[pairs]), SAME_M, SAME_OVERLAP) <= 1.0
    mate[pairs[near]] = own[pairs[near]]
    same = mate >= 0
    left = np.flatnonzero(~same)
    alone = np.ones(len(there.frame), bool)
    alone[mate[same]] = False
    rest = np.flatnonzero(alone)
    other = counterparts(here.some(left), there.some(rest))
    mate[left[other >= 0]] = rest[other[other >= 0]]
    return mate, same


def _near_pairs(one: Places, other: Places) -> Iterator[tuple[Indices, Indices, Floats]]:
    """Rows, rows and how far they are apart, of all pairs in one frame that may be one person."""
    known = [np.asarray(np.isfinite(side.floor).all(axis=1)) for side in (one, other)]
    rows, mates = np.flatnonzero(known[0]), np.flatnonzero(known[1])
    cells = one.floor[rows] / HERE_M, other.floor[mates] / HERE_M
    yield from _within(one, other, rows, mates, cells)
    if known[0].all() and known[1].all():
        return
    size = np.nanquantile(np.concatenate((one.box[:, 2:], other.box[:, 2:])), _BOXES_BELOW, axis=0)
    centres = [place.box[:, :2] + place.box[:, 2:] / 2 for place in (one, other)]
    scaled = [np.nan_to_num(centre / np.maximum(size / 2, 1.0)) for centre in centres]
    everybody = np.arange(len(one.frame)), np.arange(len(other.frame))
    for row, mate, away in _within(one, other, *everybody, (scaled[0], scaled[1])):
        boxes = ~(known[0][row] & known[1][mate])
        yield row[boxes], mate[boxes], away[boxes]


def _within(
    one: Places, other: Places, rows: Indices, mates: Indices, scaled: tuple[Floats, Floats]
) -> Iterator[tuple[Indices, Indices, Floats]]:
    """The pairs in neighbouring cells of a grid that are near enough.

    Args:
        rows, mates: which of both sides to take. scaled: their places; a cell is 1 wide.
    """
    theirs = _cells(other.frame[mates], scaled[1])
    order = np.argsort(theirs, kind="stable")
    theirs = theirs[order]
    mates = mates[order]
    for start in range(0, max(len(rows), 1), _ROWS_AT_ONCE):
        part = slice(start, start + _ROWS_AT_ONCE)
        mine = _cells(one.frame[rows[part]], scaled[0][part])
        for aside in (-1, 0, 1):
            line = mine + aside * _FARTHEST_CELL * 4
            low = np.searchsorted(theirs, line - 1)
            count = np.searchsorted(theirs, line + 2) - low
            row = np.repeat(rows[part], count)
            step = np.arange(len(row)) - np.repeat(np.cumsum(count) - count, count)
            mate = mates[np.repeat(low, count) + step]
            away = off(one.some(row), other.some(mate), HERE_M, HERE_OVERLAP)
            near = away <= 1.0
            yield row[near], mate[near], away[near]


def _cells(frame: NDArray[np.int64], scaled: Floats) -> NDArray[np.int64]:
    """(n,) one number a frame and cell; cells above each other are neighbours in it."""
    far = _FARTHEST_CELL
    column, row = np.clip(np.floor(scaled), -far, far).astype(np.int64).T + 2 * far
    return np.asarray((frame * 4 * far + column) * 4 * far + row)
