"""Track initiation: blobs of the size of a person in no track's silhouette."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from tracking.filtering import nearest_first
from tracking.trackers.shared.gating import WideningGate
from tracking.trackers.spheroid.feet import Feet, feet_scores, part_of
from tracking.trackers.spheroid.floor_cells import FloorCells
from tracking.trackers.spheroid.hypothesis_scores import bounds, enlarge, silhouette
from tracking.trackers.spheroid.sums import Window, sums_inside, window
from tracking.trackers.spheroid.weights import FEET, LEGS_BALANCE, LEGS_WEIGHT, SHARPNESS

Floats = NDArray[np.float64]
Picture = NDArray[np.uint8]
Flags = NDArray[np.bool_]

_STEP = 2
"""Rows of the picture that are summed to one line."""
_BALANCE = 0.4
"""B from which on a pixel speaks for a person, below against."""
_GAIN = 0.06
"""What speaks for somebody, less what speaks against, over what counts of the silhouette."""
_FEET = FEET / SHARPNESS
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
_DEPTH_GATE = 0.25
"""Share of the distance by which a candidate's may differ from one search to the next."""
_GATE_M = WideningGate(at_once=0.5, a_second=2.5)
"""Around a candidate, from one search to the next."""


@dataclass(frozen=True, slots=True, eq=False)
class NewPlace:
    """A place where somebody may stand, and those that the foreground tells hardly from it.

    Attributes:
        xy: (2,) m, the best of them. cells_xy: (cells, 2) m, along_m: (cells, 2) m to the next one
            behind each. weight: (cells,) of them, sums to 1.
    """

    xy: Floats
    cells_xy: Floats
    along_m: Floats
    weight: Floats

    def draw(self, count: int, random: np.random.Generator) -> Floats:
        """(count, 2) m hypotheses of where that somebody stands."""
        cell = random.choice(len(self.weight), count, p=self.weight)
        between = random.uniform(-0.5, 0.5, (count, 1))
        return self.cells_xy[cell] + between * self.along_m[cell]


@dataclass(frozen=True, slots=True, eq=False)
class SpheroidCandidates:
    """Where somebody new seems to be.

    Attributes:
        places: (n). velocity: (n, 2) m/s. searches: (n,) in how many searches they were found.
        time_s: of the last search.
    """

    places: tuple[NewPlace, ...]
    velocity: Floats
    searches: NDArray[np.intp]
    time_s: float

    @classmethod
    def none(cls) -> SpheroidCandidates:
        """Nobody."""
        return cls((), np.zeros((0, 2)), np.zeros(0, np.intp), 0.0)

    @property
    def xy(self) -> Floats:
        """(n, 2) m."""
        return np.array([place.xy for place in self.places]).reshape(-1, 2)

    def select(self, chosen: Flags) -> SpheroidCandidates:
        """Some of them."""
        places = tuple(self.places[row] for row in np.flatnonzero(chosen))
        return SpheroidCandidates(places, self.velocity[chosen], self.searches[chosen], self.time_s)

    def draw(self, count: int, random: np.random.Generator) -> Floats:
        """(n, count, 2) m hypotheses of where they stand."""
        drawn = [place.draw(count, random) for place in self.places]
        return np.array(drawn).reshape(-1, count, 2)


def find_candidates(
    ramp: Picture,
    counted: Flags,
    cells: FloorCells,
    taken_xy: Floats,
    footless: Flags | None = None,
) -> tuple[NewPlace, ...]:
    """(n) where people may stand who are not followed, the clearest first.

    The place that explains most is taken, its silhouette masked out, and the next one looked for,
    so that a group that comes in together is taken apart. All that a place explains counts, not
    its share of the silhouette: a trunk alone would fill that of somebody smaller and farther away.

    Args:
        ramp: (height, width) uint8, B times 255.
        counted: (height, width) pixels that prove anything: behind nothing and nobody followed.
        cells: where people may stand. taken_xy: (people, 2) m of those followed.
        footless: (height, width) pixels where no feet of those followed may be; None: as
            published, the place whose silhouette is fullest is taken.
    """
    counted = counted.copy()
    rows = _likely(ramp, counted, cells, taken_xy)
    found: list[NewPlace] = []
    while len(rows) and len(found) < _MOST_NEW:
        sums = window(ramp, counted, 0, 0, _STEP)
        gain, body = _gains(sums, cells, rows)
        enough = gain >= _GAIN
        rows, explained = rows[enough], gain[enough]
        if len(rows) == 0:
            break
        if footless is not None:
            feet = _feet_gains(ramp, counted & footless, cells, rows)
            explained = (body[enough] + feet) * cells.area[rows]
        best = int(explained.argmax())
        found.append(_place(cells, rows, explained, best))
        _mask_out(counted, cells, int(rows[best]))
        rows = rows[np.hypot(*(cells.xy[rows] - found[-1].xy).T) >= _NEAR_M]
    return tuple(found)


def _place(cells: FloorCells, rows: NDArray[np.intp], explained: Floats, best: int) -> NewPlace:
    """The best of the cells at these rows, and how likely those are that it hides."""
    outlines = cells.outlines[rows]
    own = outlines[best : best + 1]
    about = (np.abs(outlines.u - own.u) < np.sqrt(own.uu)) & (
        np.abs(outlines.v - own.v) < np.sqrt(own.vv)
    )
    near = rows[about]
    less = (explained[about] - explained[best]) / cells.area[rows[best]]
    weight = np.exp(SHARPNESS * less)
    xy = cells.xy[near]
    away_m = np.maximum(np.hypot(*xy.T), 1e-6)[:, None]
    along_m = xy / away_m * cells.step_m[near, None]
    return NewPlace(cells.xy[rows[best]], xy, along_m, weight / weight.sum())


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


def _gains(sums: Window, cells: FloorCells, rows: NDArray[np.intp]) -> tuple[Floats, Floats]:
    """(n,) what speaks for somebody less what speaks against, a pixel of the cells at these rows.

    First by the whole silhouette, -1 where too little of it counts; then with legs, which leave a
    gap, in the lower half of who is seen from the side.
    """
    inside = sums_inside([sums], cells.outlines[rows][None])
    seen, area, low_seen, low_area = (
        one[0] for one in (inside.ramp, inside.area, inside.low_ramp, inside.low_area)
    )
    counted = np.maximum(area, _LEAST_COUNTED * cells.area[rows])
    enough = area >= _LEAST_SEEN * np.minimum(cells.area[rows], cells.inside[rows])
    as_body = seen - _BALANCE * area
    legs = LEGS_WEIGHT * (low_seen - LEGS_BALANCE * low_area) - (low_seen - _BALANCE * low_area)
    with_legs = as_body + np.where(cells.steep[rows], 0.0, legs)
    return np.where(enough, as_body / counted, -1.0), with_legs / counted


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


def update_candidates(
    before: SpheroidCandidates,
    places: tuple[NewPlace, ...],
    time_s: float,
    camera_position: Floats,
) -> SpheroidCandidates:
    """The places found in this search, those that were found before with how they moved.

    Seen from low above, a place jumps along its line of sight from search to search: the gate is
    longer there by a share of the distance, and of such moves as much is believed as is seen.

    Args:
        before: of the last search. places: (n) found now. camera_position: (3,) m.
    """
    elapsed_s = max(time_s - before.time_s, 1e-3)
    velocity = np.zeros((len(places), 2))
    searches = np.ones(len(places), np.intp)
    if places and before.places:
        xy = np.array([place.xy for place in places])
        away_m = np.hypot(*(xy - camera_position[:2]).T)[:, None]
        sight = ((xy - camera_position[:2]) / np.maximum(away_m, 1e-6))[:, None]
        moved = xy[:, None] - before.xy
        along_m = (moved * sight).sum(axis=-1)
        across = moved - along_m[..., None] * sight
        gate_m = _GATE_M.radius(elapsed_s)
        aside = np.hypot(across[..., 0], across[..., 1]) / gate_m
        apart = np.hypot(aside, along_m / (gate_m + _DEPTH_GATE * away_m))
        pairs = nearest_first(apart, apart <= 1.0)
        searches[pairs.track] += before.searches[pairs.detection]
        seen = camera_position[2] ** 2 / (camera_position[2] ** 2 + away_m**2)
        believed = across + (along_m * seen)[..., None] * sight
        velocity[pairs.track] = believed[pairs.track, pairs.detection] / elapsed_s / 2
    return SpheroidCandidates(places, velocity, searches, time_s)
