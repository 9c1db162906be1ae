"""Boxes that somebody without one in a frame may get: where they were last, and what was found."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from scipy.optimize import linear_sum_assignment

from tracking.arrays import Floats, Mask
from tracking.tracks import Box, Columns, Source, TrackTable
from tracking.tracks.boxes import overlaps, share_inside
from tracking.tracks.columns import boxes_of

REACH_S: Final = 5.0
"""Who was seen longer ago has probably left."""
_LEAST_INSIDE = 0.1
"""Who is expected to be seen no more than this has left the picture."""
_SPEED_S = 1.0
"""How fast somebody goes is told from so much of their track."""
_SAME = 0.5
"""Boxes that overlap more, as intersection over union, are of one person, as scores take it."""
_GATE = 3.0
"""So many standard deviations from where somebody is expected a box may be theirs."""
_DRAWN, _WALK, _STRAY = 0.1, 0.4, 0.15
"""Standard deviations across, in heights of the person: of a box; of a second's walk (1.3 m/s, or
0.76 heights, is usual) by who was seen once; of one that goes on as before."""
_THERE: Final = -1
"""In place of a track: somebody who has a box in the frame."""
_FEET, _TALLER = 0.5, 0.15
"""Of the feet, as a share of that across; of the logarithm of the height."""


@dataclass(frozen=True, slots=True)
class Ghost:
    """Where somebody was who has no box in a frame.

    Attributes:
        track: who. frame: of that box, the last before, else the first after. box: it.
        expected: the same box, gone on as fast as they went there. spread: how far from there they
            may be by now, a standard deviation in heights of theirs.
    """

    track: int
    frame: int
    box: Box
    expected: Box
    spread: float

    def is_inside(self, size: tuple[int, int]) -> bool:
        """Whether some of the box that is expected lies in a picture of this size."""
        return bool(share_inside(np.array([self.expected]), size)[0] > _LEAST_INSIDE)


@dataclass(frozen=True, slots=True)
class FoundBoxes:
    """What was found in a frame.

    Attributes:
        boxes: that no track has. alone: boxes of tracks that none of those found overlaps much.
    """

    boxes: tuple[Box, ...]
    alone: tuple[Box, ...] = ()


@dataclass(frozen=True, slots=True)
class SuggestedBox:
    """A box that was found in a frame where no track has one; track: whose it may be, 0: nobody."""

    box: Box
    track: int = 0


def find_ghost(table: TrackTable, track: int, frame: int, fps: float) -> Ghost | None:
    """The ghost of a track; None where it has a box in the frame or none near to it."""
    reach, speed = round(REACH_S * fps), max(1, round(_SPEED_S * fps))
    if not track or track not in table or len(table.of_track(track, frame, frame + 1)["frame"]):
        return None
    before = table.of_track(track, max(0, frame - reach), frame)
    if len(before["frame"]):
        near = before["frame"] >= before["frame"][-1] - speed
        return _ghost(track, frame, fps, _some(before, near), -1)
    after = table.of_track(track, frame, frame + reach + 1)
    if not len(after["frame"]):
        return None
    near = after["frame"] <= after["frame"][0] + speed
    return _ghost(track, frame, fps, _some(after, near), 0)


def _ghost(track: int, frame: int, fps: float, rows: Columns, at: int) -> Ghost | None:
    """From the rows of a second, of which the one at an end is the nearest."""
    boxes, frames = boxes_of(rows, slice(None)), rows["frame"].astype(np.float64)
    if not np.isfinite(boxes[at]).all():
        return None
    middles = boxes[:, :2] + boxes[:, 2:] / 2
    span = frames[-1] - frames[0]
    speed = (middles[-1] - middles[0]) / span if span else np.zeros(2)
    moved = np.nan_to_num(speed) * (frame - frames[at])
    expected = np.concatenate((boxes[at, :2] + moved, boxes[at, 2:]))
    seconds = abs(frame - frames[at]) / fps
    spread = _DRAWN + seconds * (_STRAY if span else _WALK)
    return Ghost(track, int(frames[at]), _box(boxes[at]), _box(expected), float(spread))


def _some(rows: Columns, chosen: Mask) -> Columns:
    return {name: column[chosen] for name, column in rows.items()}


def ghosts_before(
    table: TrackTable, frame: int, fps: float, *, drawn_only: bool = False
) -> tuple[Ghost, ...]:
    """The ghosts of all who were there shortly before a frame.

    drawn_only: of those who were drawn by hand.
    """
    reach, found = round(REACH_S * fps), []
    for track in table.track_ids:
        start, end = table.frame_range(track)
        if start >= frame or end <= frame - reach:
            continue
        rows = table.of_track(track, max(0, frame - reach), frame)
        if not drawn_only or np.any(rows["source"] != Source.TRACKER):
            found.append(find_ghost(table, track, frame, fps))
    return tuple(ghost for ghost in found if ghost is not None)


def unclaimed(sources: Iterable[Floats], there: Floats) -> FoundBoxes:
    """The boxes that no track has, each person once, and the tracks' boxes that none overlaps.

    Args:
        sources: (n, 4) each, the one that is trusted most first.
        there: (m, 4) boxes of the tracks in the frame.
    """
    there = there[np.isfinite(there).all(axis=1)]
    kept, alone = there, np.ones(len(there), bool)
    found: list[Box] = []
    for boxes in sources:
        for box in boxes[np.isfinite(boxes).all(axis=1)]:
            same = overlaps(box[None], kept) > _SAME if len(kept) else np.zeros(0, bool)
            alone &= ~same[: len(there)]
            if not same.any():
                kept = np.vstack((kept, box))
                found.append(_box(box))
    return FoundBoxes(tuple(found), tuple(_box(box) for box in there[alone]))


def suggest_boxes(
    boxes: Sequence[Box], ghosts: Sequence[Ghost], alone: Sequence[Box] = ()
) -> tuple[SuggestedBox, ...]:
    """Each box with the track it may be of: those that together lie nearest to the expected.

    alone: of people in the frame none of whose own boxes was found: a box that fits one of them
        better than whoever is missing is theirs, and is left out.
    """
    people = (*ghosts, *(Ghost(_THERE, 0, box, box, _DRAWN) for box in alone))
    owners = _assigned(np.array(boxes, np.float64).reshape(-1, 4), people)
    return tuple(
        SuggestedBox(box, owners.get(at, 0))
        for at, box in enumerate(boxes)
        if owners.get(at) != _THERE
    )


def _assigned(boxes: Floats, ghosts: Sequence[Ghost]) -> Mapping[int, int]:
    """The track of each box, by its number, that lies near to where one is expected."""
    if not len(boxes) or not ghosts:
        return {}
    expected = np.array([ghost.expected for ghost in ghosts], np.float64)
    away = _away(expected, np.array([ghost.spread for ghost in ghosts]), boxes)
    near = away <= _GATE**2
    # What is less certain spreads wider: a likelihood, across and at the feet, not a mere distance.
    cost = away + 4 * np.log([ghost.spread / _DRAWN for ghost in ghosts])[:, None]
    far = (1 + len(ghosts)) * max(1.0, float(cost[near].max(initial=0.0)))
    rows, columns = linear_sum_assignment(np.where(near, cost, far))
    pairs = zip(rows.tolist(), columns.tolist(), strict=True)
    return {box: ghosts[ghost].track for ghost, box in pairs if near[ghost, box]}


def _away(expected: Floats, spread: Floats, boxes: Floats) -> Floats:
    """(g, b) squared Mahalanobis distances: across, at the feet and in height.

    People walk along the picture more than towards it: feet go up and down less than across.
    """
    one, other = expected[:, None], boxes[None]
    heights, spread = one[..., 3], spread[:, None]
    across = (other[..., 0] + other[..., 2] / 2 - one[..., 0] - one[..., 2] / 2) / heights
    feet = (other[..., 1] + other[..., 3] - one[..., 1] - one[..., 3]) / heights
    taller = np.log(np.maximum(other[..., 3], 1e-9) / heights)
    parts = across / spread, feet / (_FEET * spread), taller / _TALLER
    return np.asarray(np.sum(np.square(parts), axis=0))


def suggestion_at(found: Sequence[SuggestedBox], x: float, y: float) -> SuggestedBox | None:
    """The smallest box around a place of the picture; None where there is none."""
    around = [one for one in found if _holds(one.box, x, y)]
    return min(around, key=lambda one: one.box[2] * one.box[3], default=None)


def _holds(box: Box, x: float, y: float) -> bool:
    return box[0] <= x <= box[0] + box[2] and box[1] <= y <= box[1] + box[3]


def _box(values: Floats) -> Box:
    left, top, width, height = (float(value) for value in values)
    return left, top, width, height
