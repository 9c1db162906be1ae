"""People who hold on to their tracklets: what the flow tracker does beyond its paper."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.flow.births import Newcomer, newcomer
from tracking.trackers.flow.floor import Floor, sight_axes
from tracking.trackers.flow.flow_frame import POSITIONS, Seen, speeds
from tracking.trackers.flow.kernels import KernelTable
from tracking.trackers.flow.mode_updates import Gathering
from tracking.trackers.flow.settings import FlowSettings
from tracking.trackers.flow.sightings import FloorGrid, Sightings
from tracking.trackers.flow.silhouettes import cover_of, drawn
from tracking.trackers.flow.track_retention import lasting
from tracking.trackers.flow.tracklet_owners import Holds, adapted, moved, released, said
from tracking.trackers.flow.unclaimed_tracklets import claims
from tracking.trackers.flow.walkers import (
    Walkers,
    begun,
    measured,
    nobody,
    predicted,
    proven,
    put_at,
)

Floats = NDArray[np.float64]
Indices = NDArray[np.intp]

_NEW_M_S = 0.3
"""Slower clusters are nobody new."""
_FILL, _SEEN, _OWN = 0.5, 0.2, 0.3
"""Least score, seen and own (see `Fit`) of a cluster that is somebody new."""
_SIGHTED = (0.5, 0.15, 0.4)
"""The same where nothing but foreground says that somebody is there."""
_EMPTY = 0.35
"""Score below which nothing is where somebody should be."""
_FEWEST = 2
"""Tracklets by which somebody counts as seen."""
_APART_M = 0.4
"""So near to somebody there is nobody new."""
_WALKED_M = 0.12
"""So far must go who is sighted before they are followed."""
_LOOK_S = 0.15
"""People who are not followed yet are looked for about so often."""
_LOST_S = 0.15
"""Who is missed for longer is out of sight."""
_STRAY_M, _STRAY_M_S, _FARTHEST_STRAY_M = 0.4, 0.4, 1.2
_OTHER_PACE_M_S = 1.2
"""They may turn up so far from where they are thought to be: at once, more for each second, at
most; and so much faster or slower."""
_WEAKER = 0.3
"""Of two at one place the one with a smaller share of the other's tracklets is not the person."""
_LONGER = 1.6
"""How much farther apart along the line of sight two may be found and be one."""


class HeldPeople:
    """People on the floor, each with the tracklets that move as its body does.

    Beyond [Yoneji2013], whose clusters are made anew in each frame:
        - a tracklet keeps its place in its person's body: height and offset from the upright axis.
          So a few of them tell where the person is, whichever they are, and people who hide each
          other are told apart by how they move over a longer time;
        - a Kalman filter on the floor predicts who is hidden;
        - feet seen in the foreground say how far away somebody is, which low cameras need;
        - tracklets that nobody has are clustered as in the paper; clusters are new people.
    """

    def __init__(self, settings: FlowSettings, table: KernelTable, floor: Floor) -> None:
        """Nobody is followed yet."""
        self._settings = settings
        self._floor = floor
        self._holds = Holds.none()
        self._gathering = Gathering(settings.clusters, table)
        self._grid = FloorGrid(floor)
        self._sightings = Sightings.none()
        self._unlooked_s = 0.0
        self.walkers = nobody()
        self.last_id = 0

    @property
    def owner(self) -> NDArray[np.int32]:
        """(n,) the track of each tracklet of the last frame; 0: nobody's."""
        return self._holds.owner

    def step(self, seen: Seen) -> None:
        """Take one frame further."""
        walkers = predicted(self.walkers, seen.elapsed_s)
        holds = self._holds.of(seen.tracklets.id)
        walkers, holds = self._measured(walkers, holds, seen)
        walkers = proven(walkers, self._settings.walked_m)
        walkers, holds = self._ended(walkers, holds)
        rows, who = claims(walkers, holds, seen, self._floor)
        holds = holds.given(
            rows, walkers.track[who], walkers.place[who], seen.slope[rows], self._floor
        )
        self.walkers, self._holds = self._with_newcomers(walkers, holds, seen)

    def take_over(self, walkers: Walkers, seen: Seen, last_id: int) -> None:
        """Go on with these people, who get the tracklets that move with them."""
        holds = Holds.none().of(seen.tracklets.id)
        rows, who = claims(walkers, holds, seen, self._floor)
        self._holds = holds.given(
            rows, walkers.track[who], walkers.place[who], seen.slope[rows], self._floor
        )
        self.walkers, self.last_id = walkers, last_id

    def _measured(self, walkers: Walkers, holds: Holds, seen: Seen) -> tuple[Walkers, Holds]:
        """Everybody where their tracklets and feet say; tracklets that move otherwise set free."""
        if not len(walkers):
            return walkers, holds
        told = said(walkers, holds, seen.slope, self._floor)
        walkers = measured(walkers, told.place, told.error_m)
        found = told.count >= _FEWEST
        holds = released(holds, told.misfit, seen.elapsed_s)
        if self._settings.silhouettes:
            walkers, holds, score = self._drawn(walkers, holds, seen)
            found &= np.isfinite(score)  # foreground alone may be somebody else's
        missed_s = np.where(found, 0.0, walkers.missed_s)
        walkers = replace(walkers, count=told.count, missed_s=missed_s)
        return walkers, adapted(walkers, holds, seen.slope, self._floor, seen.elapsed_s)

    def _drawn(self, walkers: Walkers, holds: Holds, seen: Seen) -> tuple[Walkers, Holds, Floats]:
        """Everybody drawn to the foreground, their tracklets with them; (m,) how it suits them."""
        cover = cover_of(walkers.place, self._floor)
        to = drawn(walkers.place, seen.mask, cover, self._floor)
        before = walkers.place
        walkers = measured(walkers, to.place, to.error_m)
        holds = moved(walkers, holds, seen.slope, walkers.place - before, self._floor)
        empty_s = np.where(to.score < _EMPTY, walkers.empty_s + seen.elapsed_s, 0.0)
        return replace(walkers, empty_s=empty_s), holds, to.score

    def _with_newcomers(self, walkers: Walkers, holds: Holds, seen: Seen) -> tuple[Walkers, Holds]:
        settings = self._settings
        free = np.flatnonzero((holds.owner == 0) & seen.known)
        moving = speeds(seen.tracklets.select(free), POSITIONS, seen.fps, self._floor) > _NEW_M_S
        free = free[moving]
        clusters = self._gathering.of(seen.vectors(free))
        cover = cover_of(walkers.place, self._floor)
        for number in range(len(clusters)):
            rows = free[clusters.label == number]
            if np.median(seen.age_s[rows]) < settings.birth_s:
                continue
            new = newcomer(
                *(seen.slope[rows], seen.before[rows], seen.over_s),
                *(seen.mask, cover, self._floor),
            )
            if not _convincing(new) or _crowded(walkers, new.place):
                continue
            walkers, row = self._begun(walkers, new.place, new.pace)
            axis = np.broadcast_to(new.place, (len(rows), 2))
            owner = np.full(len(rows), walkers.track[row], np.int32)
            holds = holds.given(rows, owner, axis, seen.slope[rows], self._floor)
        return self._with_sighted(walkers, holds, seen)

    def _with_sighted(self, walkers: Walkers, holds: Holds, seen: Seen) -> tuple[Walkers, Holds]:
        """Whoever is seen for a while, and moves, where nobody is followed yet."""
        if not self._settings.silhouettes:
            return walkers, holds
        self._unlooked_s += seen.elapsed_s
        if self._unlooked_s < _LOOK_S:
            return walkers, holds
        place = self._grid.sighted(walkers.place, seen.mask, _SIGHTED, _APART_M)
        self._sightings = self._sightings.then(place, self._unlooked_s)
        self._unlooked_s = 0.0
        ready = self._sightings.age_s >= self._settings.birth_s
        way = self._sightings.place - self._sightings.first
        ready &= np.hypot(way[:, 0], way[:, 1]) > _WALKED_M
        for row in np.flatnonzero(ready):
            place = self._sightings.place[row]
            pace = way[row] / self._sightings.age_s[row]
            walkers, _ = self._begun(walkers, place, pace)
        rows, who = claims(walkers, holds, seen, self._floor)
        holds = holds.given(
            rows, walkers.track[who], walkers.place[who], seen.slope[rows], self._floor
        )
        return walkers, holds

    def _begun(self, walkers: Walkers, place: Floats, pace: Floats) -> tuple[Walkers, int]:
        """With somebody at a place, and the row: who was lost near there, else somebody new."""
        lost = _lost_near(walkers, place, pace)
        if lost is not None:
            return put_at(walkers, lost, place, pace), lost
        self.last_id += 1
        one = begun(np.array([self.last_id], np.int32), place[None], pace[None])
        return walkers.and_also(one), len(walkers)

    def _ended(self, walkers: Walkers, holds: Holds) -> tuple[Walkers, Holds]:
        """Without those who are gone; of two at one place the surer one has the tracklets."""
        kept = lasting(walkers, self._settings, self._floor)
        kept &= walkers.empty_s < self._settings.empty_s
        heir = _heirs(walkers, kept, self._settings.closest_m)
        row = holds.rows_of(walkers)
        owner = np.where(row >= 0, np.append(walkers.track, 0)[np.append(heir, -1)[row]], 0)
        kept &= heir == np.arange(len(walkers))
        holds = replace(holds, owner=owner.astype(np.int32))
        gone = ~np.isin(holds.owner, walkers.track[kept])
        return walkers.select(kept), holds.freed(gone)


def _convincing(new: Newcomer) -> bool:
    """Whether enough of the body is seen, in the foreground, where nobody else explains it."""
    return new.score >= _FILL and new.seen >= _SEEN and new.own >= _OWN


def _crowded(walkers: Walkers, place: Floats) -> bool:
    """Whether somebody stands there already."""
    return bool((np.hypot(*(walkers.place - place).T) < _APART_M).any())


def _lost_near(walkers: Walkers, place: Floats, pace: Floats) -> int | None:
    """The row of whoever is out of sight and may have come to the place; None: nobody."""
    away = np.hypot(*(walkers.place - place).T)
    reach = np.minimum(_STRAY_M + _STRAY_M_S * walkers.missed_s, _FARTHEST_STRAY_M)
    alike = np.hypot(*(walkers.pace - pace).T) < _OTHER_PACE_M_S
    near = (walkers.missed_s > _LOST_S) & (away < reach) & alike & walkers.walked
    return int(np.where(near, away, np.inf).argmin()) if near.any() else None


def _heirs(walkers: Walkers, kept: NDArray[np.bool_], closest_m: float) -> Indices:
    """(m,) for each person the one it is, which is another where two stand at one place."""
    heir = np.arange(len(walkers))
    away = walkers.place[:, None] - walkers.place[None]
    off = np.einsum("mij,mnj->mni", sight_axes(walkers.place), away)
    off[..., 0] /= _LONGER
    near = np.triu(np.hypot(off[..., 0], off[..., 1]) < closest_m, 1)
    for one, other in zip(*np.nonzero(near & kept & kept[:, None]), strict=True):
        if heir[one] != one or heir[other] != other:
            continue
        weak = walkers.count[one] < _WEAKER * walkers.count[other]
        lost, stays = (one, other) if weak else (other, one)
        heir[lost] = stays
    return heir
