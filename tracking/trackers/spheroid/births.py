"""Track initiation: blobs of the size of a person in no track's silhouette."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.trackers.shared.gating import WideningGate
from tracking.trackers.spheroid.feet import Feet, feet_scores, part_of
from tracking.trackers.spheroid.floor_cells import FloorCells
from tracking.trackers.spheroid.hypothesis_scores import bounds, enlarge, silhouette
from tracking.trackers.spheroid.sums import Window, sums_inside, window

Floats = NDArray[np.float64]
Picture = NDArray[np.uint8]
Flags = NDArray[np.bool_]

_STEP = 2
"""Rows of the picture that are summed to one line."""
_BALANCE = 0.4
"""B from which on a pixel speaks for a person, below against."""
_COVERAGE = 0.42
"""Share of what counts of a silhouette that must be foreground."""
_GAIN = 0.06
"""What speaks for somebody, less what speaks against, over what counts of the silhouette."""
_FEET = 0.3
"""What is added to it, to tell who is where, if legs end where legs are seen to end."""
_LEAST_COUNTED = 0.4
"""Of a silhouette: less of it is weighed as if it were so much."""
_LIKELY = 0.2
"""Share of a silhouette's box that must be foreground to be looked at closely."""
_LEAST_SEEN = 0.35
"""Share of a silhouette that must count: what peeps out between people is theirs."""
ENLARGED = 1.15
"""Silhouettes of people explain what lies in them when they are so much larger: arms and feet."""
TALLER_M = 0.05
"""Nor do they explain more than somebody so much taller than usual would: a spheroid that grew over
two people leaves the second one to be found."""
_MOST_NEW = 8
_NEAR_M = 0.45
"""Nobody starts closer than this to somebody followed."""
_GATE_M = WideningGate(at_once=0.5, a_second=2.5)
"""Around a candidate, from one search to the next."""


@dataclass(frozen=True, slots=True, eq=False)
class SpheroidCandidates:
    """Where somebody new seems to be.

    Attributes:
        xy: (n, 2) m. velocity: (n, 2) m/s. searches: (n,) in how many searches they were found.
        time_s: of the last search.
    """

    xy: Floats
    velocity: Floats
    searches: NDArray[np.intp]
    time_s: float

    @classmethod
    def none(cls) -> SpheroidCandidates:
        """Nobody."""
        return cls(np.zeros((0, 2)), np.zeros((0, 2)), np.zeros(0, np.intp), 0.0)


def find_candidates(
    ramp: Picture,
    counted: Flags,
    cells: FloorCells,
    taken_xy: Floats,
    footless: Flags | None = None,
) -> Floats:
    """(n, 2) m where people may stand who are not followed, the clearest first.

    The place that explains most is taken, its silhouette masked out, and the next one looked for,
    so that a group that comes in together is taken apart.

    Args:
        ramp: (height, width) uint8, B times 255.
        counted: (height, width) pixels that prove anything: behind nothing and nobody followed.
        cells: where people may stand. taken_xy: (people, 2) m of those followed.
        footless: (height, width) pixels where no feet of those followed may be; None: feet say
            nothing of how far away candidates are.
    """
    counted = counted.copy()
    rows = _likely(ramp, counted, cells, taken_xy)
    found: list[Floats] = []
    while len(rows) and len(found) < _MOST_NEW:
        sums = window(ramp, counted, 0, 0, _STEP)
        gain, coverage = _gain_and_coverage(sums, cells, rows)
        if gain.max() < _GAIN:
            break
        total = gain
        if footless is not None:
            total = gain + _feet_gains(ramp, counted & footless, cells, rows)
        best = int(np.where(gain < _GAIN, -np.inf, total).argmax())
        if coverage[best] < _COVERAGE:
            rows = np.delete(rows, best)
            continue
        found.append(cells.xy[rows[best]])
        _mask_out(counted, cells, int(rows[best]))
        far = np.hypot(*(cells.xy[rows] - found[-1]).T) >= _NEAR_M
        rows = rows[far & (gain > 0.0)]
    return np.array(found).reshape(-1, 2)


def _likely(ramp: Picture, counted: Flags, cells: FloorCells, taken_xy: Floats) -> NDArray[np.intp]:
    """Numbers of the cells whose box holds enough foreground and that are nobody's."""
    if len(cells) == 0:
        return np.zeros(0, np.intp)
    left, top, right, bottom = bounds(cells.outlines, ramp.shape)
    seen = cv2.integral(np.where(counted, ramp, np.uint8(0)), sdepth=cv2.CV_64F)
    inside = seen[bottom, right] - seen[top, right] - seen[bottom, left] + seen[top, left]
    box = np.maximum((bottom - top) * (right - left), 1)
    likely = inside > 255.0 * _LIKELY * box
    rows = np.flatnonzero(likely)
    apart = cells.xy[rows, None] - taken_xy[None]
    near = (np.hypot(apart[..., 0], apart[..., 1]) < _NEAR_M).any(axis=1)
    return np.asarray(rows[~near])


def _gain_and_coverage(
    sums: Window, cells: FloorCells, rows: NDArray[np.intp]
) -> tuple[Floats, Floats]:
    """(n,) gain and coverage of the cells at these rows."""
    inside = sums_inside([sums], cells.outlines[rows][None])
    seen, area = inside.ramp[0], inside.area[0]
    counted = np.maximum(area, _LEAST_COUNTED * cells.area[rows])
    enough = area >= _LEAST_SEEN * np.minimum(cells.area[rows], cells.inside[rows])
    gain = np.where(enough, (seen - _BALANCE * area) / counted, -1.0)
    return gain, seen / np.maximum(area, 1.0)


def _feet_gains(ramp: Picture, counted: Flags, cells: FloorCells, rows: NDArray[np.intp]) -> Floats:
    """(n,) what feet add to the gain of the cells at these rows: the right ones of a column."""
    gain = np.zeros(len(rows))
    flat = np.flatnonzero(~cells.steep[rows])
    legs, below = cells.feet.legs.at(rows[flat]), cells.feet.below.at(rows[flat])
    gain[flat] = _FEET * feet_scores([part_of(ramp, counted)], Feet(legs, below))[0]
    return gain


def _mask_out(counted: Flags, cells: FloorCells, row: int) -> None:
    one = enlarge(cells.outlines[row : row + 1], ENLARGED)
    (left,), (top,), (right,), (bottom,) = bounds(one, counted.shape)
    drawn = silhouette((bottom - top, right - left), one.polygons(40)[0], left, top)
    counted[top:bottom, left:right] &= drawn == 0


def update_candidates(before: SpheroidCandidates, xy: Floats, time_s: float) -> SpheroidCandidates:
    """The places found in this search, those that were found before with how they moved.

    Args:
        before: of the last search. xy: (n, 2) m found now.
    """
    elapsed_s = max(time_s - before.time_s, 1e-3)
    velocity = np.zeros_like(xy)
    searches = np.ones(len(xy), np.intp)
    gate_m = _GATE_M.radius(elapsed_s)
    for row, place in enumerate(xy):
        if len(before.xy) == 0:
            break
        apart = np.hypot(*(before.xy - place).T)
        nearest = int(apart.argmin())
        if apart[nearest] <= gate_m:
            searches[row] = before.searches[nearest] + 1
            velocity[row] = (place - before.xy[nearest]) / elapsed_s / 2
    return SpheroidCandidates(xy, velocity, searches, time_s)
