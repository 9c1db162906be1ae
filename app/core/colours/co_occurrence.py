"""Where tracks are present together, and how near each other."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from tracking.tracks import Columns

_NEAR_M = 5.0
"""Who comes no nearer is not near at all."""
FAR = 0.3
"""How near people are who are not near at all, but there at the same time."""
_USUAL_HEIGHT_M = 1.7
_LOOKS = 300
"""In so many frames, evenly spread, it is looked who is near whom."""
_PAIRS_AT_ONCE = 1_000_000
_MOST_PEOPLE = 1_000
"""Of more in one frame only so many are looked at, so that pairs do not fill the memory."""
_SMALL_IDS = 1_000_000
"""Up to here ids are places in an array."""
_PLACE = ("x", "y", "left", "top", "width", "height")

Ids = NDArray[np.int64]
Floats = NDArray[np.float64]
_NOBODY: tuple[Ids, Floats] = np.zeros(0, np.int64), np.zeros(0)


@dataclass(frozen=True, slots=True)
class CoOccurrences:
    """Who is there when, and near whom.

    Attributes:
        stays: first frame, last frame and id of each track, in this order.
        nearness: of an id those who come near (k,), and how near (k,): up to 1, in one place.
    """

    stays: tuple[tuple[int, int, int], ...] = ()
    nearness: Mapping[int, tuple[Ids, Floats]] = field(default_factory=dict)

    def near_of(self, track: int) -> tuple[Ids, Floats]:
        """Who comes near, and how near: from `FAR` to 1."""
        return self.nearness.get(track, _NOBODY)


def find_co_occurrences(rows: Columns) -> CoOccurrences:
    """Co-occurrences in rows that stand by frame; places are sampled."""
    frame, track = rows["frame"], rows["track"]
    if not len(frame):
        return CoOccurrences()
    starts, sizes = _looks(frame)
    pairs = [_pairs(rows, starts[part], sizes[part]) for part in _portions(sizes)]
    ids, others, much = (np.concatenate(column) for column in zip(*pairs, strict=True))
    return CoOccurrences(_stays(frame, track), _both_ways(*_nearest(ids, others, much)))


def pairs_in(rows: Columns) -> int:
    """How many pairs `find_co_occurrences` looks at: its work, beside one pass over the rows."""
    frame = rows["frame"]
    return int((np.square(_looks(frame)[1]).sum()) // 2) if len(frame) else 0


def closeness(rows: Columns, track: int) -> dict[int, float]:
    """How near all others of one frame's rows are to one of them, from `FAR` to 1.

    Nobody is near to one who is not there.
    """
    ids, places = rows["track"], _places(rows)
    own = places[ids == track][:1]
    if not len(own):
        return {}
    apart = np.linalg.norm(places - own, axis=1)
    near = np.where(apart < _NEAR_M, _much(apart), FAR)
    return {one: how for one, how in zip(ids.tolist(), near.tolist(), strict=True) if one != track}


def _looks(frame: Ids) -> tuple[Ids, Ids]:
    """First row and number of rows, (k,) each, of frames that are spread evenly over rows."""
    looks = np.unique(frame[np.linspace(0, len(frame) - 1, _LOOKS).astype(int)])
    starts = np.searchsorted(frame, looks)
    sizes = np.searchsorted(frame, looks, "right") - starts
    return starts, np.minimum(sizes, _MOST_PEOPLE)


def _portions(sizes: Ids) -> list[slice]:
    """Looks one after the other, so many at once that their pairs are not too much for memory."""
    until = np.cumsum(np.square(sizes)) // _PAIRS_AT_ONCE
    cuts = [0, *(np.flatnonzero(np.diff(until)) + 1).tolist(), len(sizes)]
    return [slice(*ends) for ends in pairwise(cuts)]


def _pairs(rows: Columns, starts: Ids, sizes: Ids) -> tuple[Ids, Ids, Floats]:
    """Ids of those near each other in one of some frames, the lower first, and how near at most."""
    first, second = _of_one_frame(sizes)
    begun = np.cumsum(sizes) - sizes
    taken = np.arange(sizes.sum()) + np.repeat(starts - begun, sizes)
    part = {name: rows[name][taken] for name in ("track", *_PLACE)}
    places = _places(part)
    apart = np.hypot(*(places[first] - places[second]).T)
    near = apart < _NEAR_M
    ids = part["track"].astype(np.int64)
    one, other = ids[first[near]], ids[second[near]]
    return _nearest(np.minimum(one, other), np.maximum(one, other), _much(apart[near]))


def _of_one_frame(sizes: Ids) -> tuple[Ids, Ids]:
    """Of rows that stand by frame, so many in each, every two of one frame, the earlier first."""
    stop = np.repeat(np.cumsum(sizes), sizes)  # for each row one past the last of its frame
    row = np.arange(len(stop))
    later = stop - row - 1
    first = np.repeat(row, later)
    second = first + 1 + np.arange(len(first)) - np.repeat(np.cumsum(later) - later, later)
    return first, second


def _nearest(ids: Ids, others: Ids, much: Floats) -> tuple[Ids, Ids, Floats]:
    """Every two once, and how near they are at most."""
    key = (ids << 32) | others
    order = np.argsort(key)
    key = key[order]
    start = np.flatnonzero(np.diff(key, prepend=-1))
    if len(start):
        much = np.maximum.reduceat(much[order], start)
    return key[start] >> 32, key[start] & 0xFFFFFFFF, much


def _both_ways(ids: Ids, others: Ids, much: Floats) -> dict[int, tuple[Ids, Floats]]:
    """Of each id who comes near, and how near."""
    one, other = np.concatenate((ids, others)), np.concatenate((others, ids))
    order = np.argsort(one, kind="stable")
    one, other, much = one[order], other[order], np.tile(much, 2)[order]
    known, first = np.unique(one, return_index=True)
    ends = pairwise([*first.tolist(), len(one)])
    return {
        track: (other[start:stop], much[start:stop])
        for track, (start, stop) in zip(known.tolist(), ends, strict=True)
    }


def _much(apart: Floats) -> Floats:
    """How near people are who are so far apart (n,) m."""
    return FAR + (1.0 - FAR) * np.square(1.0 - apart / _NEAR_M)


def _places(rows: Columns) -> NDArray[np.float64]:
    """(n, 2) m on the floor; where nobody's is known in the picture, bodies of usual height."""
    floor = np.column_stack((rows["x"], rows["y"])).astype(float)
    if np.isfinite(floor).all(axis=1).any() or not len(floor):
        return floor
    height = np.nanmedian(rows["height"]) if np.isfinite(rows["height"]).any() else np.nan
    middle = rows["left"] + rows["width"] / 2, rows["top"] + rows["height"] / 2
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.column_stack(middle).astype(float) * _USUAL_HEIGHT_M / height


def _stays(frame: NDArray[np.int32], track: NDArray[np.int32]) -> tuple[tuple[int, int, int], ...]:
    ids = np.arange(int(track.max()) + 1) if track.max() < _SMALL_IDS else np.unique(track)
    at = track if len(ids) and ids[-1] + 1 == len(ids) else np.searchsorted(ids, track)
    first, last = np.full(len(ids), -1), np.full(len(ids), -1)
    first[at[::-1]], last[at] = frame[::-1], frame  # what is written last stays
    known = np.flatnonzero(last >= 0)
    stays = zip(first[known].tolist(), last[known].tolist(), ids[known].tolist(), strict=True)
    return tuple(sorted(stays))
