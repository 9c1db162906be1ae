"""Who joins the people followed, and who is let go."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from tracking.people import Detections
from tracking.trackers.three_part.bodies import covered_shares
from tracking.trackers.three_part.claims import Claims
from tracking.trackers.three_part.people import Flags, Floats, Indices, PartPeople
from tracking.trackers.three_part.settings import WholeBodySettings
from tracking.tracks.boxes import share_inside

_SAME = 0.5
"""Share of a region's box in an earlier one's from which on it is the same region."""
_OCCUPIED = 0.5
"""Share of a region's box in a person's, and of theirs in it, from which on they are the same."""
_INSIDE = 0.85
"""Share of a region's box in a person's from which on it is a piece of theirs."""
_LEAST_HEIGHT_PX = 30.0
"""Of somebody whose parts can be told apart."""
_AT_EDGE_S = 2.0
"""How long a region at the picture's edge is waited for: it is walking in."""
_SUPPORTED = 0.3
"""Share of foreground under somebody's parts from which on they are there."""
_AT_THE_EDGE = 0.9
_OUT_OF_VIEW = 0.4
"""Share of a body inside the picture below which somebody not seen has left it."""
_GONE = 0.15
"""The same below which nobody is followed."""


_REACH, _WITHIN_REACH, _PIECE = 0.6, 0.7, 0.72
"""How far somebody's limbs go to either side, in heights; share of a region's box there, and its
height against theirs, from which and up to which it is a piece of them."""


@dataclass(frozen=True, slots=True, eq=False)
class TentativeRegions:
    """Regions nobody followed is in, waited for until they are somebody.

    Attributes:
        box: (n, 4) left, top, width, height px.
        seen_s: (n,) for how long. clear_s: (n,) for how long away from the picture's edge.
        pace: (n, 2) px/s, how the box's middle moves.
    """

    box: Floats = field(default_factory=lambda: np.zeros((0, 4)))
    seen_s: Floats = field(default_factory=lambda: np.zeros(0))
    clear_s: Floats = field(default_factory=lambda: np.zeros(0))
    pace: Floats = field(default_factory=lambda: np.zeros((0, 2)))


def free_regions(seen: Detections, claims: Claims, boxes: Floats) -> Indices:
    """The regions in which nobody followed can be; boxes (people, 4) of those followed."""
    covered, covering = covered_shares(seen.box, boxes), covered_shares(boxes, seen.box).T
    # One before the other covers most of a box; the same person is in both.
    same = (covered >= _OCCUPIED) & ((covering >= _OCCUPIED) | (covered >= _INSIDE))
    tall = seen.box[:, 3] >= _LEAST_HEIGHT_PX
    elsewhere = seen.from_detector | ~same.any(axis=1)  # boxes of people followed are theirs
    return np.flatnonzero(~claims.is_taken & elsewhere & ~seen.merged & tall)


def without_pieces(free: Indices, seen: Detections, boxes: Floats, height: Floats) -> Indices:
    """The free regions that cannot be a bent person's head and arms, or what else sticks out.

    A region within somebody's reach that is much lower than they are upright is a piece of them.

    Args:
        boxes: (people, 4) left, top, width, height of those followed. height: (people,) px upright.
    """
    middle, foot = boxes[:, 0] + boxes[:, 2] / 2, boxes[:, 1] + boxes[:, 3]
    reach = np.column_stack(
        (middle - _REACH * height, foot - height, 2 * _REACH * height, 1.1 * height)
    )
    near = covered_shares(seen.box[free], reach) >= _WITHIN_REACH
    low = (_heights_seen(seen, free)[:, None] < _PIECE * height) & ~seen.from_detector[free, None]
    return free[~(near & low).any(axis=1)]


def _heights_seen(seen: Detections, rows: Indices) -> Floats:
    """(n,) px from the highest to the lowest pixel seen; boxes reach down to hidden feet."""
    heights = np.zeros(len(rows))
    for at, row in enumerate(rows):
        left, top, width, height = seen.box[row]
        across = slice(max(int(left), 0), max(int(np.ceil(left + width)) + 1, 0))
        down = slice(max(int(top), 0), max(int(np.ceil(top + height)) + 1, 0))
        found = np.flatnonzero((seen.regions[down, across] == row + 1).any(axis=1))
        heights[at] = found[-1] - found[0] + 1 if len(found) else 0
    return heights


def update_tentative(
    tentative: TentativeRegions, seen: Detections, free: Indices, elapsed_s: float
) -> TentativeRegions:
    """The free regions with how long each has been there, in the order of `free`."""
    box = seen.box[free]
    if not len(tentative.box) or not len(box) or elapsed_s <= 0.0:
        return TentativeRegions(
            box, np.zeros(len(box)), np.zeros(len(box)), np.zeros((len(box), 2))
        )
    same = np.minimum(covered_shares(box, tentative.box), covered_shares(tentative.box, box).T)
    best = same.argmax(axis=1)
    known = same.max(axis=1) >= _SAME
    old = tentative.box[best]
    step = (box[:, :2] + box[:, 2:] / 2 - old[:, :2] - old[:, 2:] / 2) / elapsed_s
    seen_s = tentative.seen_s[best]
    frames = seen_s / elapsed_s
    mean = tentative.pace[best] + (step - tentative.pace[best]) / (frames[:, None] + 1.0)
    clear = known & (~seen.truncated[free] | seen.from_detector[free])
    return TentativeRegions(
        box,
        np.where(known, seen_s + elapsed_s, 0.0),
        np.where(clear, tentative.clear_s[best] + elapsed_s, 0.0),
        np.where(known[:, None], mean, 0.0),
    )


def confirm_regions(
    tentative: TentativeRegions, seen: Detections, free: Indices, settings: WholeBodySettings
) -> Indices:
    """Which of the free regions are people by now, as rows of `free`."""
    whole = ~seen.truncated[free] | seen.from_detector[free]
    at_edge = seen.truncated[free] & (tentative.seen_s >= max(_AT_EDGE_S, settings.confirm_s))
    ready = at_edge | (whole & (tentative.clear_s >= settings.confirm_s))
    covered = covered_shares(tentative.box, tentative.box)
    taller = tentative.box[None, :, 3] > tentative.box[:, None, 3]
    piece = (taller & (covered >= _OCCUPIED) & ready).any(axis=1)
    return np.flatnonzero(ready & ~piece)


def is_supported(claims: Claims, cut: Flags) -> Flags:
    """(people,) whose parts lie on foreground; (people, parts) those cut off say nothing."""
    parts = np.maximum((~cut).sum(axis=1), 1)
    return np.asarray((claims.support * ~cut).sum(axis=1) / parts >= _SUPPORTED)


def should_keep(
    people: PartPeople, boxes: Floats, size: tuple[int, int], settings: WholeBodySettings
) -> Flags:
    """(people,) who is followed on."""
    inside = share_inside(boxes, size)
    patience_s = np.where(inside < _AT_THE_EDGE, settings.delete_at_edge_s, settings.delete_after_s)
    patience_s = np.where(people.hidden, settings.delete_occluded_s, patience_s)
    missed = people.missed_s > 0.0
    left = (inside < _GONE) | (missed & (inside < _OUT_OF_VIEW))
    return np.asarray(~left & (people.missed_s <= patience_s))
