"""What the picture tells of each row: who overlaps there, and whose track begins or ends beside it.

Where one camera places people, or those far away are placed, metres are rough; boxes that overlap
are not.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats
from tracking.review.core.evidence import Evidence, Rows
from tracking.review.core.material import Material

_OVERLAP_S = (-0.5, -0.2, 0.2)
_BESIDE = 0.6
"""Of a box's height: so near its foot somebody else's track begins or ends beside it."""
_LONGEST_S = 1.0
FEATURES = (
    *(f"overlap_{seconds:+}s" for seconds in _OVERLAP_S),
    "begun_beside_s",
    "ended_beside_s",
)
"""Names, in the order of the columns."""


def picture_features(material: Material) -> NDArray[np.float32]:
    """(n, features) of every row; NaN where nothing is known or nobody is.

    Overlaps are intersection over union with whoever overlaps most, some time before and after;
    times, in s, go from the nearest begin (end) of another track beside the row to it.
    """
    evidence = material.evidence
    overlap = _greatest_overlap(evidence)
    columns = [_at(evidence, overlap, seconds) for seconds in _OVERLAP_S]
    columns += [_since(evidence, rows) for rows in (material.first, material.last)]
    return np.stack(columns, axis=1).astype(np.float32)


def _at(evidence: Evidence, values: Floats, seconds: float) -> Floats:
    """(n,) the value of each row's track so much later; NaN where it has no row there."""
    frames = int(np.copysign(evidence.frames_of(abs(seconds)), seconds))
    then = evidence.later(np.arange(len(evidence)), frames)
    return np.where(then >= 0, values[then], np.nan)


def _greatest_overlap(evidence: Evidence) -> Floats:
    """(n,) intersection over union of each box with the one that overlaps it most."""
    one, other = _side_by_side(evidence)
    left, top, width, height = evidence.box.T
    both = [
        np.minimum((low + size)[one], (low + size)[other]) - np.maximum(low[one], low[other])
        for low, size in ((left, width), (top, height))
    ]
    shared = np.clip(both[0], 0.0, None) * np.clip(both[1], 0.0, None)
    area = np.maximum(width * height, 1.0)
    share = shared / (area[one] + area[other] - shared)
    greatest = np.zeros(len(evidence))
    for rows in (one, other):
        np.maximum.at(greatest, rows, share)
    return greatest


def _side_by_side(evidence: Evidence) -> tuple[Rows, Rows]:
    """(k,), (k,) rows of one frame whose boxes share some of the picture's columns.

    A sweep over each frame's boxes from left to right, as that of `neighbours`.
    """
    left, width = evidence.box[:, 0], evidence.box[:, 2]
    known = np.flatnonzero(np.isfinite(evidence.box).all(axis=1))
    order = known[np.lexsort((left[known], evidence.frame[known]))]
    frame, start, end = evidence.frame[order], left[order], (left + width)[order]
    found: list[tuple[Rows, Rows]] = [(order[:0], order[:0])]
    alive, step = np.arange(len(order)), 0
    while len(alive):
        step += 1
        alive = alive[alive + step < len(order)]
        beside = alive + step
        alive = alive[(frame[alive] == frame[beside]) & (start[beside] < end[alive])]
        found.append((order[alive], order[alive + step]))
    one, other = (np.concatenate(parts) for parts in zip(*found, strict=True))
    return one, other


def _since(evidence: Evidence, events: Rows) -> Floats:
    """(n,) s since the nearest in time of other tracks' events beside each row; NaN for none.

    Args:
        events: rows at which something happens.
    """
    order = np.argsort(evidence.frame, kind="stable")
    frame, reach = evidence.frame[order], evidence.frames_of(_LONGEST_S)
    low = np.searchsorted(frame, evidence.frame[events] - reach)
    count = np.searchsorted(frame, evidence.frame[events] + reach, "right") - low
    within = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count)
    row, event = order[np.repeat(low, count) + within], np.repeat(events, count)
    near = (evidence.track[row] != evidence.track[event]) & _beside(evidence.box, row, event)
    row, event = row[near], event[near]
    since_s = (evidence.frame[row] - evidence.frame[event]) / evidence.fps
    # Of what is written to one place several times the last stays: the nearest.
    nearest = np.argsort(-np.abs(since_s), kind="stable")
    found = np.full(len(evidence), np.nan)
    found[row[nearest]] = since_s[nearest]
    return found


def _beside(box: Floats, row: Rows, other: Rows) -> NDArray[np.bool_]:
    """(k,) whether two boxes stand beside each other, told by the first one's height."""
    across, foot = box[:, 0] + box[:, 2] / 2, box[:, 1] + box[:, 3]
    reach = _BESIDE * np.maximum(box[row, 3], 1.0)
    near = np.abs(across[row] - across[other]) < reach
    return np.asarray(near & (np.abs(foot[row] - foot[other]) < reach))
