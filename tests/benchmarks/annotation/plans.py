"""What a person draws to label a recording, and what that takes in CVAT by its documentation."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import numpy as np

from tracking.arrays import Floats
from tracking.formats import read_mot
from tracking.tracks.boxes import overlaps
from tracking.tracks.columns import boxes_of

_GOING_THERE, _ROUNDS = 1.0, 4
_FAR = 10
"""Frames that one key goes: Shift and an arrow here, V and C there."""
KEYFRAME_MARGIN = 0.1
"""Boxes that are put by hand fit better than those between them need to."""


@dataclass(frozen=True, slots=True, eq=False)
class TrueTrack:
    """The boxes of one person: frames (n,) without a gap, boxes (n, 4) in px."""

    frames: Floats
    boxes: Floats

    def box(self, frame: int) -> Floats:
        """(4,) of a frame."""
        return np.asarray(self.boxes[frame - self.first])

    def covers(self, frame: int) -> bool:
        """Whether they are there."""
        return self.first <= frame <= self.last

    @property
    def first(self) -> int:
        """The first frame."""
        return int(self.frames[0])

    @property
    def last(self) -> int:
        """The last frame."""
        return int(self.frames[-1])


def true_tracks_of(truth: Path) -> dict[int, TrueTrack]:
    """The people of a ground truth."""
    rows = read_mot(truth)
    true_tracks = {}
    for person in np.unique(rows["track"]).tolist():
        mine = rows["track"] == person
        true_tracks[person] = TrueTrack(
            rows["frame"][mine].astype(float), boxes_of(rows, mine).astype(float)
        )
    return true_tracks


def keyframes_of(true_tracks: Mapping[int, TrueTrack], least: float) -> dict[int, list[int]]:
    """Everybody's keyframes, between which straight lines overlap all boxes by at least so much.

    As few as can be, of which as many as can be lie in the same frames: each frame is gone to.
    """
    ends = {
        end for true_track in true_tracks.values() for end in (true_track.first, true_track.last)
    }
    plans: dict[int, list[int]] = {person: [] for person in true_tracks}
    for _ in range(_ROUNDS):
        for person, true_track in true_tracks.items():
            others = (frames for other, frames in plans.items() if other != person)
            plans[person] = _keyframes(true_track, least, ends.union(*others))
    return plans


def _keyframes(true_track: TrueTrack, least: float, visited: set[int]) -> list[int]:
    """Of one person; a frame that is not visited for others costs more."""
    count = len(true_track.frames)
    cost, before = [0.0, *[np.inf] * (count - 1)], [0] * count
    for end in range(1, count):
        beside = 0.0 if true_track.first + end in visited else _GOING_THERE
        for start in range(end):
            total = cost[start] + 1.0 + beside
            if total < cost[end] and _fits(true_track, start, end, least):
                cost[end], before[end] = total, start
    found, at = [count - 1], count - 1
    while at:
        at = before[at]
        found.append(at)
    return [true_track.first + one for one in sorted(set(found))]


def _fits(true_track: TrueTrack, start: int, end: int, least: float) -> bool:
    if end - start < 2:
        return True
    share = (np.arange(start + 1, end) - start)[:, None] / (end - start)
    between = true_track.boxes[start] + (true_track.boxes[end] - true_track.boxes[start]) * share
    return bool(overlaps(between, true_track.boxes[start + 1 : end]).min() >= least)


def keys_between(start: int, end: int) -> int:
    """The fewest keys from a frame to another: one of them goes a frame, another ten."""
    whole, rest = divmod(abs(end - start), _FAR)
    return whole + min(rest, _FAR - rest + 1)


def keys_through(frames: Iterable[int]) -> int:
    """The keys from the first frame of the footage through all of these, ascending."""
    return sum(keys_between(*pair) for pair in pairwise([0, *sorted(set(frames))]))


def by_frame(plans: Mapping[int, Iterable[int]]) -> dict[int, list[int]]:
    """Who is drawn in which frame, ascending."""
    found: dict[int, list[int]] = defaultdict(list)
    for person, frames in plans.items():
        for frame in frames:
            found[frame].append(person)
    return dict(sorted(found.items()))


@dataclass(frozen=True, slots=True)
class CvatCount:
    """Actions in CVAT, all people frame by frame.

    Attributes:
        first_boxes, changed_boxes, ends: of tracks. frames: gone to, after the first.
        keys: the same by the keys that go a frame or ten.
    """

    first_boxes: int
    changed_boxes: int
    ends: int
    frames: int
    keys: int

    def total(self, *, by_keys: bool) -> int:
        """All of them."""
        put = self.first_boxes + self.changed_boxes + self.ends
        return put + (self.keys if by_keys else self.frames)


def count_cvat(
    true_tracks: Mapping[int, TrueTrack], plans: Mapping[int, list[int]], least: float
) -> CvatCount:
    """The same keyframes in CVAT's track mode, by its documentation.

    Going to a frame: a click on the slider (1). A first box: N, which draws as last time, and two
    points (3). A keyframe: the box is moved (1), and resized where its old size does not fit there
    (1 more). A track that ends before the footage: O over the box in the next frame (1); its last
    keyframe is left out where the one before it, which CVAT holds until then, fits to the end.
    The first box of all takes the tool and Track instead of N (1 more); the label is free.
    """
    stop = max(true_track.last for true_track in true_tracks.values())
    changed, ends, visited = 0, 0, set[int]()
    for person, keys in plans.items():
        true_track = true_tracks[person]
        held = overlaps(
            true_track.box(keys[-2])[None], true_track.boxes[keys[-2] - true_track.first :]
        )
        kept = keys[:-1] if held.min() >= least else keys
        for before, frame in pairwise(kept):
            changed += 1 if _moved_fits(true_track.box(before), true_track.box(frame), least) else 2
        visited.update(kept)
        if true_track.last < stop:
            ends += 1
            visited.add(true_track.last + 1)
    frames = len(visited | {0}) - 1
    return CvatCount(1 + 3 * len(plans), changed, ends, frames, keys_through(visited))


def _moved_fits(before: Floats, now: Floats, least: float) -> bool:
    """Whether a box that is moved over another's middle fits without being resized."""
    middle = now[:2] + now[2:] / 2
    moved = np.concatenate((middle - before[2:] / 2, before[2:]))
    return bool(overlaps(moved[None], now[None])[0] >= least + KEYFRAME_MARGIN)
