"""Tracklets of a finished run, each linked over all the frames it was followed in."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.flow.floor import Floor
from tracking.tracks.columns import Columns, places_of
from tracking.tracks.run import Particles, Run

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
Rows = NDArray[np.intp]

_SHORTEST_S = 0.4
"""What was followed for less says little of who it belongs to."""
_USUAL_STRIDE_M, _LONGEST_STRIDE_M, _STRIDE_ROWS = 0.35, 0.6, 200
"""The foreground ends on the foot in front, so much nearer than the body's middle, where too few
rows tell; and at most."""
_OWN_FEET_M = 1.0
"""Feet that are farther from who holds the tracklet are somebody else's."""


@dataclass(frozen=True, slots=True, eq=False)
class TrackletChains:
    """Tracklets over time: a row for each of their frames, sorted by frame.

    Attributes:
        row: (n,) of the run's tracklets.
        frame: (n,) of the recording.
        chain: (n,) the number of the tracklet, 0 to m - 1.
        slope: (n, 2) where its ray goes, see `Floor`.
        held_at: (n, 2) m where the person stood, as far as was known in that frame, who held it;
            NaN: nobody did.
        feet_m: (n,) how far away, along the floor, whoever stands below the point in front of all
            others is, by the feet in the foreground; NaN: not known.
        start: (frames + 1,) where the rows of each frame begin.
        length, first, last: (m,) how many rows, first and last frame of each tracklet.
    """

    row: Rows
    frame: Integers
    chain: Integers
    slope: Floats
    held_at: Floats
    feet_m: Floats
    start: Integers
    length: Integers
    first: Integers
    last: Integers

    def __len__(self) -> int:
        """How many tracklets there are."""
        return len(self.length)

    def of_frames(self, first: int, stop: int) -> Rows:
        """The rows of frames from `first` on, before `stop`."""
        return np.arange(self.start[first], self.start[stop])


def link_chains(run: Run, floor: Floor, fps: float) -> TrackletChains:
    """The tracklets of a run of the flow tracker that were followed for a while."""
    columns = {name: np.asarray(run.tracklets.columns[name]) for name in _COLUMNS}
    frame = np.repeat(np.arange(len(run.tracklets.start) - 1), np.diff(run.tracklets.start))
    chain = _link(run.tracklets, columns)
    slope = floor.slopes(np.stack((columns["u0"], columns["v0"]), axis=1).astype(np.float64))
    known = np.isfinite(slope).all(axis=1)
    length = np.bincount(chain[known], minlength=len(chain) + 1)
    row = np.flatnonzero(known & (length[chain] >= max(2, round(_SHORTEST_S * fps))))
    number = np.unique(chain[row], return_inverse=True)[1]
    count = int(number.max(initial=-1)) + 1
    first, last = np.full(count, len(frame)), np.full(count, -1)
    np.minimum.at(first, number, frame[row])
    np.maximum.at(last, number, frame[row])
    held_at = _held_at(run.tracks, frame[row], columns["track"][row])
    feet_m = _feet_m(columns, row, floor)
    return TrackletChains(
        row=row,
        frame=frame[row],
        chain=number,
        slope=slope[row],
        held_at=held_at,
        feet_m=feet_m + _stride_m(held_at, feet_m),
        start=np.searchsorted(frame[row], np.arange(len(run.tracklets.start))),
        length=np.bincount(number, minlength=count),
        first=first,
        last=last,
    )


_COLUMNS = ("track", "u0", "v0", "u1", "v1", "foot_v")


def _feet_m(columns: Columns, row: Rows, floor: Floor) -> Floats:
    """(n,) m along the floor to where the foreground below tracklets ends."""
    foot = np.stack((columns["u0"][row], columns["foot_v"][row]), axis=1).astype(np.float64)
    return np.asarray(np.hypot(*floor.slopes(foot).T) * floor.camera_m)


def _stride_m(held_at: Floats, feet_m: Floats) -> float:
    """How much nearer than people the foreground below them ends, over all the run.

    How people step and how much of their feet the foreground has differs from footage to footage;
    where their heads and sides are in it says where they stand all the same.
    """
    farther = np.hypot(*held_at.T) - feet_m
    farther = farther[np.abs(farther) < _OWN_FEET_M]  # NaN: not
    if len(farther) < _STRIDE_ROWS:
        return _USUAL_STRIDE_M
    return float(np.clip(np.median(farther), 0.0, _LONGEST_STRIDE_M))


def _link(tracklets: Particles, columns: Columns) -> Integers:
    """(n,) the same number for rows of one tracklet: where one is was where the other is now."""
    start = tracklets.start
    now, before = (_as_key(columns[u], columns[v]) for u, v in (("u0", "v0"), ("u1", "v1")))
    chain = np.arange(len(now))
    for frame in range(1, len(start) - 1):
        old, new = slice(start[frame - 1], start[frame]), slice(start[frame], start[frame + 1])
        order = np.argsort(now[old], kind="stable")
        place = np.searchsorted(now[old][order], before[new])
        place[place == len(order)] = 0
        if not len(order):
            continue
        row = order[place]
        hit = now[old][row] == before[new]
        once = np.zeros(len(row), bool)
        once[np.unique(np.where(hit, row, -1), return_index=True)[1]] = True
        hit &= once
        chain[new][hit] = chain[old][row[hit]]
    return chain


def _as_key(u: NDArray[np.float32], v: NDArray[np.float32]) -> NDArray[np.uint64]:
    """(n,) one number for each point: its coordinates bit by bit."""
    bits = np.stack((u, v), axis=1).astype(np.float32).view(np.uint32).astype(np.uint64)
    return np.asarray(bits[:, 0] << np.uint64(32) | bits[:, 1])


def _held_at(tracks: Columns, frame: Integers, track: NDArray[np.int32]) -> Floats:
    """(n, 2) m where the tracks (n,) are in those frames; NaN where they are not."""
    place = np.full((len(frame), 2), np.nan)
    if not len(tracks["frame"]):
        return place
    wide = 1 + int(max(tracks["track"].max(), track.max(initial=0)))
    keys = tracks["frame"].astype(np.int64) * wide + tracks["track"]
    order = np.argsort(keys, kind="stable")
    wanted = frame * wide + track
    at = order[np.minimum(np.searchsorted(keys[order], wanted), len(order) - 1)]
    hit = (keys[at] == wanted) & (track > 0)
    place[hit] = places_of(tracks, at[hit])
    return place
