"""Who is tracked rightly, part by part, by the measure of [ZhaoLee2009] section 5.2.

A part is right while less than half of its rectangle holds something else: what lies outside of
the box of that very part of that very person counts as something else, be it another part,
another person or the floor. The paper says "regions of other objects" and judges by eye; exact
truth leaves no room, so ours is the stricter reading. Two things the paper leaves open:

- a rectangle that covers less than a twentieth of the part is wrong: a dot inside holds nothing
  else; the inner rectangle of a part seen exactly covers a tenth to a third of its box;
- a person's first frame is the first in which all of the person is in the picture, at least seven
  tenths seen, and a track stands on the person. That track is followed whatever its rectangles do;
  another id on the same person is worth nothing. Who has no track within a second counts as wrong
  from the first frame on, and a track that ends is wrong from there on.

Frames in which somebody is not wholly in the picture end the judging.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.benchmarks.parts.truth import PARTS, Truth, bounding

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]

LEAST_SEEN = 0.7
LEAST_COVERED = 0.05
LATEST_START_S = 1.0


@dataclass(frozen=True, slots=True, eq=False)
class Judged:
    """One person from its first frame on; m frames.

    Attributes:
        person: true id.
        track: id of the track that was followed; 0: none.
        first_frame: number of the first frame judged.
        parts: (m, 3) whether head, torso and hip-leg are right.
        person_right: (m,) whether the person's rectangle is.
        foreign: (m, 3) share of each part's rectangle outside of the part; NaN without one.
    """

    person: int
    track: int
    first_frame: int
    parts: Bools
    person_right: Bools
    foreign: Floats


@dataclass(frozen=True, slots=True, eq=False)
class Tracked:
    """What a tracker said, by track id; corners are left, top, right, bottom, NaN where none.

    Attributes:
        parts: (f, 3, 4) of each track; all NaN where a tracker knows no parts.
        person: (f, 4) of each track.
    """

    parts: Mapping[int, Floats]
    person: Mapping[int, Floats]


def tracked_parts(columns: Mapping[str, NDArray[Any]], frames: int) -> Tracked:
    """The rectangles of a run's parts; a person is the box round all three."""
    corners = _corners(columns["cx"], columns["cy"], columns["width"], columns["height"])
    parts = {}
    for track in np.unique(columns["track"]):
        rows = columns["track"] == track
        parts[int(track)] = table = np.full((frames, len(PARTS), 4), np.nan)
        table[columns["frame"][rows], columns["part"][rows]] = corners[rows]
    return Tracked(parts, {track: bounding(table) for track, table in parts.items()})


def tracked_people(columns: Mapping[str, NDArray[Any]], frames: int) -> Tracked:
    """The boxes of a run's tracks, without parts."""
    width, height = columns["width"], columns["height"]
    middle = columns["left"] + width / 2, columns["top"] + height / 2
    corners = _corners(*middle, width, height)
    people = {}
    for track in np.unique(columns["track"]):
        rows = columns["track"] == track
        people[int(track)] = table = np.full((frames, 4), np.nan)
        table[columns["frame"][rows]] = corners[rows]
    nothing = np.full((frames, len(PARTS), 4), np.nan)
    return Tracked(dict.fromkeys(people, nothing), people)


def _corners(cx: Floats, cy: Floats, width: Floats, height: Floats) -> Floats:
    return np.column_stack((cx - width / 2, cy - height / 2, cx + width / 2, cy + height / 2))


def foreign_share(rectangles: Floats, true: Floats) -> Floats:
    """Share (...) of rectangles (..., 4) that lies outside of the true boxes (..., 4)."""
    return np.asarray(1.0 - _common(rectangles, true) / np.maximum(_area(rectangles), 1e-9))


def right(rectangles: Floats, true: Floats) -> Bools:
    """Whether rectangles (..., 4) hold what they should; False where there is none."""
    covered = _common(rectangles, true) / np.maximum(_area(true), 1e-9)
    enough = covered >= LEAST_COVERED
    return np.asarray(enough & (foreign_share(rectangles, true) < 0.5), np.bool_)


def _area(corners: Floats) -> Floats:
    size = np.maximum(corners[..., 2:] - corners[..., :2], 0.0)
    return np.asarray(size[..., 0] * size[..., 1])


def _common(one: Floats, other: Floats) -> Floats:
    low = np.maximum(one[..., :2], other[..., :2])
    high = np.minimum(one[..., 2:], other[..., 2:])
    return _area(np.concatenate((low, high), axis=-1))


def judge(truth: Truth, tracked: Tracked, fps: float) -> list[Judged]:
    """Everybody who is ever wholly in the picture and well seen."""
    people, whole = truth.people, truth.whole
    judged = []
    for row, person in enumerate(truth.track):
        begins = np.flatnonzero(whole[:, row] & (truth.visibility[:, row] >= LEAST_SEEN))
        if not len(begins):
            continue
        first, end = int(begins[0]), _end(whole[:, row], int(begins[0]))
        latest = min(first + round(LATEST_START_S * fps) + 1, end)
        track, start = _begin(tracked.person, people, row, first, latest)
        judged.append(_judged(int(person), row, track, (start, end), truth, tracked))
    return judged


def _end(whole: Bools, first: int) -> int:
    """The first frame from `first` on in which the person is not whole in the picture."""
    out = np.flatnonzero(~whole[first:])
    return first + int(out[0]) if len(out) else len(whole)


def _begin(
    tracks: Mapping[int, Floats], people: Floats, row: int, first: int, latest: int
) -> tuple[int, int]:
    """The track that stands on a person earliest, best if several do, and since when; or 0.

    A track stands on whomever it overlaps most: behind each other, people share rectangles.
    """
    for frame in range(first, latest):
        fits = {}
        for track, boxes in tracks.items():
            overlaps = [_overlap(boxes[frame], person) for person in people[frame]]
            if overlaps[row] == max(overlaps) and right(boxes[frame], people[frame, row]):
                fits[track] = overlaps[row]
        if fits:
            return max(fits, key=lambda track: fits[track]), frame
    return 0, first


def _overlap(one: Floats, other: Floats) -> float:
    """Intersection over union of two boxes (4,); 0 where one is none."""
    common = float(_common(one, other))
    return common / (float(_area(one) + _area(other)) - common) if common > 0 else 0.0


def _judged(
    person: int, row: int, track: int, span: tuple[int, int], truth: Truth, tracked: Tracked
) -> Judged:
    frames = slice(*span)
    true = truth.parts[frames, row]
    none = np.full(true.shape, np.nan)
    parts = tracked.parts[track][frames] if track else none
    whole = tracked.person[track][frames] if track else none[:, 0]
    return Judged(
        person,
        track,
        span[0],
        right(parts, true),
        right(whole, truth.people[frames, row]),
        foreign_share(parts, true),
    )
