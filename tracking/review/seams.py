"""Where edits have joined, parted or exchanged tracks: the review item there is about the edit.

The hazard was fitted to trackers' errors. Where a person puts one right, the tracks change over in
one frame, which it takes for an error of a tracker: of its own it cannot tell the two apart.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from tracking.arrays import Flags
from tracking.review.core.evidence import Rows
from tracking.review.review_item import ReviewItem, ReviewItemKey
from tracking.tracks import LARGEST_NUMBER, Columns, TrackTable, row_keys

_PLACE = "left", "top", "width", "height", "x", "y"


def corrected_items(
    items: Iterable[ReviewItem], begun: TrackTable, table: TrackTable
) -> frozenset[ReviewItemKey]:
    """The items that show a frame in which one of their tracks was corrected.

    Args:
        begun: the tracks as they began. table: as they are now.
    """
    known = seams(begun, table)
    if not len(known):
        return frozenset()
    return frozenset(one.key for one in items if _shows(one, known))


def _shows(item: ReviewItem, known: Rows) -> bool:
    tracks = np.array(item.tracks, np.int64)
    start, end = np.full_like(tracks, item.start), np.full_like(tracks, item.end)
    low = np.searchsorted(known, row_keys(tracks, start))
    return bool((np.searchsorted(known, row_keys(tracks, end)) > low).any())


def seams(begun: TrackTable, table: TrackTable) -> Rows:
    """(k,) `row_keys` of tracks and frames, ascending: on both sides of each cut and joint.

    A row is the same before and after where it has the same box and place; a box that was moved
    within its track is no seam.
    """
    old, new = (each.by_track(("track", "frame", *_PLACE)) for each in (begun, table))
    keys = [row_keys(rows["track"], rows["frame"]) for rows in (old, new)]
    same, place = _same(old, new, *keys)
    if same.all() and len(same) == len(keys[1]):
        return np.empty(0, np.int64)
    untouched = np.zeros(len(keys[1]), np.bool_)
    untouched[place[same]] = True
    now, was = old["track"].astype(np.int64), new["track"].astype(np.int64)
    left, others = (_rows(old, ~same), _rows(new, ~untouched))
    now[~same], was[~untouched] = _found_again(left, others), _found_again(others, left)
    moved = (now == 0) & np.isin(keys[0], keys[1][was == 0])
    now = np.where(moved, old["track"], now)
    parted = _changes(old["track"], now)
    there = was > 0
    joined = _changes(new["track"][there], was[there])
    # Of what parted the ids after the edit have a seam, of what was joined the track itself.
    found = [row_keys(now[row], old["frame"][row]) for row in parted]
    found += [row_keys(new["track"][there][row], new["frame"][there][row]) for row in joined]
    every = np.unique(np.concatenate(found))
    nobody = row_keys(np.zeros(1, np.int64), np.full(1, LARGEST_NUMBER))  # rows that were deleted
    return np.asarray(every[every > nobody], np.int64)


def _same(old: Columns, new: Columns, key: Rows, other: Rows) -> tuple[Flags, Rows]:
    """(n,) whether an old row is a new one of the same track, and where that would stand."""
    place = np.searchsorted(other, key)
    if not len(other):
        return np.zeros(len(key), np.bool_), place
    place = np.minimum(place, len(other) - 1)
    same = other[place] == key
    for name in _PLACE:
        one, there = old[name], new[name][place]
        same &= (one == there) | (np.isnan(one) & np.isnan(there))
    return same, place


def _rows(columns: Columns, wanted: Flags) -> Columns:
    return {name: column[wanted] for name, column in columns.items()}


def _found_again(rows: Columns, others: Columns) -> Rows:
    """(n,) the track that rows of the same frame, box and place have among others; 0: none."""
    count = len(rows["frame"])
    marks = _numbers(rows, others)
    known, first = np.unique(marks[count:], return_index=True)
    if not len(known):
        return np.zeros(count, np.int64)
    at = np.minimum(np.searchsorted(known, marks[:count]), len(known) - 1)
    found = known[at] == marks[:count]
    return np.where(found, others["track"][first[at]], 0).astype(np.int64)


def _numbers(rows: Columns, others: Columns) -> Rows:
    """A number for each row of both; those of one frame, box and place have the same."""
    names = "frame", *_PLACE
    every = np.stack([np.nan_to_num(np.concatenate([rows[n], others[n]])) for n in names], 1)
    order = np.lexsort(every.T[::-1])
    another = np.append(True, (np.diff(every[order], axis=0) != 0).any(axis=1))[: len(order)]
    number = np.empty(len(order), np.int64)
    number[order] = np.cumsum(another)
    return number


def _changes(track: Rows, other: Rows) -> tuple[Rows, Rows]:
    """The rows before and after each change of the other track within a track."""
    at = np.flatnonzero((np.diff(track) == 0) & (np.diff(other) != 0))
    return at, at + 1
