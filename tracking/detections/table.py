"""Boxes of a whole recording, frame by frame, and which of them are used."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracking.arrays import Flags, Floats, Integers, Mask
from tracking.people.detection_source import MOST_BOXES, FrameDetections

_TWO_KINDS, _TWO_KINDS_PER_SHARE = 0.72, 0.14
"""Share of the scores' variance that lies between two kinds of boxes where few are of the lower
one, and by how much it is larger the more are; less, and they are one kind. Cut in the middle, a
uniform distribution has 0.75 and a normal one 0.64; two public detectors have 0.76 and 0.83 with
6 % and 16 % of their boxes in the lower kind, most of which are nobody."""
_MOST_DROPPED = 0.5
_INSIDE, _SAME_FEET = 0.9, 0.15
"""A box of which this share lies in one with a higher score is of the same person, where their
lower sides are closer than this share of the smaller height: who stands behind somebody has feet
farther up."""
_COMPARED = 4 * MOST_BOXES
"""Boxes of a frame that are compared pair by pair, those with the highest scores."""


@dataclass(frozen=True, slots=True, eq=False)
class BoxTable:
    """Boxes of one camera, sorted by frame.

    Attributes:
        frame: (n,) from 0.
        box: (n, 4) left, top, width, height in 0-based px of the picture as recorded.
        score: (n,) larger is surer; all 1 where the file tells none.
    """

    frame: Integers
    box: Floats
    score: Floats

    @classmethod
    def sorted_by_frame(cls, frame: Integers, box: Floats, score: Floats) -> BoxTable:
        """The table of boxes in any order; those of a frame stay in theirs."""
        order = np.argsort(frame, kind="stable")
        return cls(frame[order], box[order], score[order])

    def __len__(self) -> int:
        """The number of boxes."""
        return len(self.frame)

    def of(self, frame: int) -> FrameDetections:
        """All boxes of a frame."""
        start, stop = np.searchsorted(self.frame, (frame, frame + 1))
        return FrameDetections(self.box[start:stop], self.score[start:stop])

    def select(self, kept: Flags) -> BoxTable:
        """Some of the boxes."""
        return BoxTable(self.frame[kept], self.box[kept], self.score[kept])

    def above_score(self, least_score: float | None) -> BoxTable:
        """Those with this score or more; None: with the one that is learnt from the scores."""
        least = learnt_threshold(self.score) if least_score is None else least_score
        return self.select(self.score >= least)

    def in_region(self, looked_at: Mask | None) -> BoxTable:
        """Those in the region of interest, see `are_in_region`; None: all."""
        return self if looked_at is None else self.select(are_in_region(self.box, looked_at))


def are_in_region(box: Floats, looked_at: Mask) -> Flags:
    """(n,) whether the middles of boxes (n, 4) px lie where people are looked for.

    Args:
        looked_at: (height, width) non-zero there, of the picture as recorded.
    """
    height, width = looked_at.shape
    u, v = np.rint(box[:, :2] + box[:, 2:] / 2).T
    inside = (u >= 0) & (v >= 0) & (u < width) & (v < height)
    u, v = (np.where(inside, side, 0).astype(np.intp) for side in (u, v))
    return np.asarray(inside & (looked_at[v, u] > 0))


def learnt_threshold(score: Floats) -> float:
    """The score that parts two kinds of boxes best [Otsu1979]; the lowest if there is one kind.

    Detectors say how sure they are in units of their own; what is common to them is that boxes of
    people have high scores and are more. Without scores it is minus infinity.

    Args:
        score: (n,) finite.
    """
    known = np.sort(score)
    if not len(known):
        return -np.inf
    if known[0] == known[-1]:
        return float(known[0])
    known_less = known - known[0]  # sums of large scores would lose what tells them apart
    rows = np.arange(1, len(known))
    share = rows / len(known)
    sums = np.cumsum(known_less)
    below, above = sums[:-1] / rows, (sums[-1] - sums[:-1]) / (len(known) - rows)
    between = share * (1 - share) * (above - below) ** 2
    between[known[1:] == known[:-1]] = 0.0  # equal scores stay together
    best = int(between.argmax())
    least = _TWO_KINDS + _TWO_KINDS_PER_SHARE * share[best]
    if between[best] < least * known_less.var() or share[best] > _MOST_DROPPED:
        return float(known[0])
    return float(known[best + 1])


def suppress_overlaps(boxes: FrameDetections, max_overlap: float) -> FrameDetections:
    """Non-maximum suppression: the box with the highest score of each person, in their order.

    At most `MOST_BOXES` are kept, those with the highest scores.

    Args:
        boxes: of one frame.
        max_overlap: intersection over union above which two boxes are of one person; 1: none are.
    """
    order = np.argsort(-boxes.score, kind="stable")[:_COMPARED]
    overlap, inside = _overlaps(boxes.box[order])
    within = (inside > _INSIDE) & _same_feet(boxes.box[order]) & (max_overlap < 1.0)
    twice = np.tril((overlap > max_overlap) | within, -1)
    kept = np.ones(len(order), np.bool_)
    for k in np.flatnonzero(twice.any(axis=1)).tolist():
        kept[k] = not (twice[k] & kept).any()
    rows = np.sort(order[kept][:MOST_BOXES])
    return FrameDetections(boxes.box[rows], boxes.score[rows])


def _same_feet(box: Floats) -> Flags:
    """(n, n) whether the lower sides of two boxes are close together."""
    height, feet = box[:, 3], box[:, 1] + box[:, 3]
    least = np.minimum(height[:, None], height)
    return np.asarray(np.abs(feet[:, None] - feet) <= _SAME_FEET * least)


def _overlaps(box: Floats) -> tuple[Floats, Floats]:
    """(n, n) intersection over union, and the share of the n-th box that lies in each other."""
    low, high = box[:, :2], box[:, :2] + box[:, 2:]
    shared = np.minimum(high[:, None], high) - np.maximum(low[:, None], low)
    area, common = box[:, 2:].prod(axis=1), shared.clip(0.0).prod(axis=2)
    union = area[:, None] + area - common
    return common / np.maximum(union, 1e-9), common / np.maximum(area, 1e-9)[:, None]
