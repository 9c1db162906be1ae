"""People who walk alone through one camera's image: their boxes, how they lean, who is who."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

from tracking.arrays import Flags, Floats
from tracking.people import SingleCameraPerception
from tracking.progress import Progress, no_progress, stage_of
from tracking.recording import Recording
from tracking.recording.spread_frames import spread_frames
from tracking.tracks.boxes import overlaps

_LOOKS = 600
"""Frames looked at, at most."""
_LOOK_EVERY_S = 0.15
_LEARNT_FROM = 20
"""Frames that the background is learnt from."""
_LEARNING = 0.1
"""Share of the time that this takes."""
_SHORTEST_PASSAGE = 8
"""Looks at somebody: fewer tell no change with the place, and feet hidden by the same thing in all
of them are taken for a place farther away."""
_SAME_OVERLAP = 0.25
"""A box and the one expected of the same person have this in common at least."""
_INSIDE = 0.5
"""Share of an expected box that lies in a box of somebody: two such people walk as one region."""
_LONGEST_GAP, _MERGED_COUNTS = 6, 3
"""Looks without somebody until the passage ends; of those merged with others each counts so."""
_STEADINESS = 0.5
"""Weight of the last step in somebody's velocity."""
_AROUND, _JUMP = 3, 0.05
"""Looks before and after, and how much a body's height may differ from theirs, as a share: feet or
a head went missing, or somebody else came in."""
_SLIMMEST, _WIDEST = 0.15, 0.9
"""Width over height of a box of one person."""
_LOWEST_SHARE = 0.06
"""Of the image's height: lower boxes say too little."""
_MARGIN_PX = 3.0
"""From the image's edge."""


@dataclass(frozen=True, slots=True)
class PeopleSeen:
    """Boxes of single people in an image, and where they were seen.

    Attributes:
        box: (n, 4) px as recorded: left, top, width, height. frame: (n,).
        person: (n,) number of the passage, from 0.
        lean: (n,) rad between the longest axis of what is seen of the body and the image's
            vertical, positive where feet are right of the head; NaN where it is not known.
        slimness: (n,) 0 for round silhouettes up to 1 for lines: how well they tell the axis.
    """

    box: Floats
    frame: NDArray[np.intp]
    person: NDArray[np.intp]
    lean: Floats
    slimness: Floats

    def select(self, rows: NDArray[np.intp] | Flags) -> PeopleSeen:
        """Those at these rows; passages are numbered anew."""
        chosen: dict[str, Any] = {
            each.name: getattr(self, each.name)[rows] for each in fields(self)
        }
        chosen["person"] = np.unique(chosen["person"], return_inverse=True)[1]
        return PeopleSeen(**chosen)


@dataclass(frozen=True, slots=True)
class _Look:
    """What is seen in one frame: (n, 4) boxes, (n,) leans and slimness, and (n,) who is whole."""

    frame: int
    box: Floats
    lean: Floats
    slimness: Floats
    whole: Flags


@dataclass(slots=True)
class _Walker:
    """Somebody as seen last.

    Attributes:
        person: number. box: (4,) px. step: (2,) px from look to look.
        missed: looks since; each of those merged with others counts as several. Who merged is thus
            expected too far ahead, and is mostly somebody new afterwards: passages linked through
            merges made floors worse.
    """

    person: int
    box: Floats
    step: Floats
    missed: float = 0.0

    def expected(self) -> Floats:
        """(4,) where the box is now."""
        return np.asarray(self.box + np.append(self.step * (self.missed + 1), (0.0, 0.0)))

    def seen_as(self, box: Floats) -> None:
        """Follow on to this box."""
        step = (_head(box) - _head(self.box)) / (self.missed + 1)
        self.step = (1 - _STEADINESS) * self.step + _STEADINESS * step
        self.box, self.missed = box, 0.0


def people_seen(recording: Recording, progress: Progress = no_progress) -> PeopleSeen:
    """Boxes of people who stand alone and whole in the left image."""
    perception = SingleCameraPerception(recording.fps, looked_at=recording.looked_at)
    learning = stage_of(progress, 0.0, _LEARNING)
    samples = spread_frames(recording.frame_count, _LEARNT_FROM, learning)
    perception.learn([recording.read(number) for number in samples])
    progress = stage_of(progress, _LEARNING, 1.0)
    every = max(1, round(_LOOK_EVERY_S * recording.fps), recording.frame_count // _LOOKS)
    passages = Passages()
    for frame in recording.frames():
        if frame.number % every:
            continue
        people = perception.observe(frame).people
        whole = _single(people.box, recording.size) & ~people.truncated
        lean, slimness = axes_of_regions(people.regions, len(people))
        passages.add(_Look(frame.number, people.box, lean, slimness, whole))
        progress(frame.number + 1, recording.frame_count)
    return passages.people()


def axes_of_regions(regions: NDArray[Any], count: int) -> tuple[Floats, Floats]:
    """(count,) lean in rad and slimness of regions 1 to count, by their second moments."""
    v, u = np.nonzero(regions)
    number = regions[v, u].astype(np.intp)

    def mean(values: Any) -> Floats:
        total = np.bincount(number, values, count + 1)
        return np.asarray(total / np.maximum(np.bincount(number, minlength=count + 1), 1))

    right, down = u - mean(u)[number], v - mean(v)[number]
    across, along, both = mean(right**2), mean(down**2), mean(right * down)
    lean = 0.5 * np.arctan2(2 * both, along - across)
    slimness = np.hypot(along - across, 2 * both) / np.maximum(along + across, 1e-9)
    return lean[1:], slimness[1:]


class Passages:
    """Boxes linked from look to look; who merges with others is somebody new afterwards."""

    def __init__(self) -> None:
        self._walkers: list[_Walker] = []
        self._count = 0
        self._kept: list[tuple[_Look, NDArray[np.intp]]] = []

    def add(self, look: _Look) -> None:
        """What is seen next."""
        expected = np.array([walker.expected() for walker in self._walkers]).reshape(-1, 4)
        inside = _share_inside(expected, look.box) > _INSIDE
        crowded = inside.sum(axis=0) > 1
        person = np.full(len(look.box), -1)
        for row, column in _pairs(expected, look.box, crowded):
            person[column] = self._walkers[row].person
            self._walkers[row].seen_as(look.box[column])
        for walker, merged in zip(self._walkers, (inside & crowded).any(axis=1), strict=True):
            if walker.person not in person:
                walker.missed += _MERGED_COUNTS if merged else 1
        self._walkers = [each for each in self._walkers if each.missed <= _LONGEST_GAP]
        for column in np.flatnonzero((person < 0) & ~crowded & look.whole).tolist():
            person[column] = self._count
            self._walkers.append(_Walker(self._count, look.box[column], np.zeros(2)))
            self._count += 1
        self._kept.append((look, person))

    def people(self) -> PeopleSeen:
        """Those seen whole, steadily and often enough."""
        parts: list[tuple[Any, ...]] = [(np.zeros((0, 4)), *np.zeros((4, 0)))]
        for look, person in self._kept:
            rows = (person >= 0) & look.whole
            frame = np.full(int(rows.sum()), look.frame)
            parts.append(
                (look.box[rows], frame, person[rows], look.lean[rows], look.slimness[rows])
            )
        box, frame, person, lean, slimness = map(np.concatenate, zip(*parts, strict=True))
        seen = PeopleSeen(box, frame.astype(np.intp), person.astype(np.intp), lean, slimness)
        return _long(seen.select(_steady(seen)))


def _pairs(expected: Floats, box: Floats, crowded: Flags) -> list[tuple[int, int]]:
    """Rows of expected boxes, and of the boxes that are theirs."""
    shared = overlaps(expected[:, None], box[None])
    rows, columns = linear_sum_assignment(shared, maximize=True)
    same = (shared[rows, columns] >= _SAME_OVERLAP) & ~crowded[columns]
    return list(zip(rows[same].tolist(), columns[same].tolist(), strict=True))


def _share_inside(expected: Floats, box: Floats) -> Floats:
    """(m, n) share of each expected box that lies in each box."""
    one, other = expected[:, None], box[None]
    low = np.maximum(one[..., :2], other[..., :2])
    high = np.minimum(one[..., :2] + one[..., 2:], other[..., :2] + other[..., 2:])
    return np.asarray((high - low).clip(0).prod(axis=2) / one[..., 2:].prod(axis=2).clip(1.0))


def _head(box: Floats) -> Floats:
    """(2,) the middle of a box's upper edge, which is steadier than where its feet end."""
    return np.array([box[0] + box[2] / 2, box[1]])


def _single(box: Floats, size: tuple[int, int]) -> Flags:
    """(n,) boxes of the shape of one person, away from the image's edge."""
    width, height = size
    left, top, wide, tall = box.T
    inside = (left > _MARGIN_PX) & (top > _MARGIN_PX) & (left + wide < width - _MARGIN_PX)
    inside &= top + tall < height - _MARGIN_PX
    shape = wide / np.maximum(tall, 1e-6)
    return np.asarray(
        inside & (tall > _LOWEST_SHARE * height) & (shape > _SLIMMEST) & (shape < _WIDEST)
    )


def _steady(seen: PeopleSeen) -> Flags:
    """(n,) boxes about as high as those of the same person before and after."""
    steady = np.zeros(len(seen.box), bool)
    for person in np.unique(seen.person):
        rows = np.flatnonzero(seen.person == person)
        height = np.log(seen.box[rows, 3])
        around = [
            np.median(height[max(0, at - _AROUND) : at + _AROUND + 1]) for at in range(len(rows))
        ]
        steady[rows] = np.abs(height - around) < _JUMP
    return steady


def _long(seen: PeopleSeen) -> PeopleSeen:
    """Those seen often."""
    often = np.bincount(seen.person, minlength=1)[seen.person] >= _SHORTEST_PASSAGE
    return seen.select(often)
