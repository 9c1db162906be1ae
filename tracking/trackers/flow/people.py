"""People who hold on to their tracklets: what the flow tracker does beyond its paper."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.flow.births import BirthHypothesis, locate_birth
from tracking.trackers.flow.floor import Floor, sight_axes
from tracking.trackers.flow.flow_frame import POSITIONS, FlowFrame, speeds
from tracking.trackers.flow.kernels import KernelTable
from tracking.trackers.flow.mode_updates import ModeUpdater
from tracking.trackers.flow.settings import FlowSettings
from tracking.trackers.flow.silhouettes import draw_cover, fit_silhouettes
from tracking.trackers.flow.track_retention import should_keep
from tracking.trackers.flow.tracklet_owners import (
    TrackletOwners,
    adapt_offsets,
    estimate_places,
    move_offsets,
    release_misfits,
)
from tracking.trackers.flow.unclaimed_tracklets import claim_tracklets
from tracking.trackers.flow.walkers import (
    Walkers,
    begin_walkers,
    mark_proven,
    no_walkers,
    predict,
    put_at,
    update_measured,
)
from tracking.trackers.shared.gating import WideningGate
from tracking.trackers.shared.tracker_base import TrackIds

Floats = NDArray[np.float64]
Indices = NDArray[np.intp]

_NEW_M_S = 0.3
"""Slower clusters are nobody new."""
_FILL, _SEEN, _OWN = 0.5, 0.2, 0.3
"""Least score, seen and own (see `Fit`) of a cluster that is somebody new."""
_EMPTY = 0.35
"""Score below which nothing is where somebody should be."""
_FEWEST = 2
"""Tracklets by which somebody counts as seen."""
_APART_M = 0.4
"""So near to somebody there is nobody new."""
_LOST_S = 0.15
"""Who is missed for longer is out of sight."""
_STRAY_M = WideningGate(at_once=0.4, a_second=0.4, widest=1.2)
_OTHER_PACE_M_S = 1.2
"""They may turn up so far from where they are thought to be, and so much faster or slower."""
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

    def __init__(
        self, settings: FlowSettings, table: KernelTable, floor: Floor, ids: TrackIds
    ) -> None:
        """Nobody is followed yet; new people get the next ids."""
        self._settings = settings
        self._floor = floor
        self._owners = TrackletOwners.none()
        self._modes = ModeUpdater(settings.clusters, table)
        self._ids = ids
        self.walkers = no_walkers()

    @property
    def owner(self) -> NDArray[np.int32]:
        """(n,) the track of each tracklet of the last frame; 0: nobody's."""
        return self._owners.owner

    def step(self, seen: FlowFrame) -> None:
        """Take one frame further: predict, update, terminate, associate, initiate.

        There is no gate: tracklets stay whose they were, which is what updates their people, and
        those of nobody are associated with who is left. What moves otherwise is set free.
        """
        walkers = predict(self.walkers, seen.elapsed_s)
        owners = self._owners.for_ids(seen.tracklets.id)
        walkers, owners = self._update(walkers, owners, seen)
        walkers, owners = self._terminate(walkers, owners)
        owners = self._associate(walkers, owners, seen)
        self.walkers, self._owners = self._initiate(walkers, owners, seen)

    def take_over(self, walkers: Walkers, seen: FlowFrame) -> None:
        """Go on with these people, who get the tracklets that move with them."""
        owners = TrackletOwners.none().for_ids(seen.tracklets.id)
        self.walkers, self._owners = walkers, self._associate(walkers, owners, seen)

    def _associate(
        self, walkers: Walkers, owners: TrackletOwners, seen: FlowFrame
    ) -> TrackletOwners:
        """Tracklets of nobody given to people they move with."""
        rows, who = claim_tracklets(walkers, owners, seen, self._floor)
        return owners.assign(
            rows, walkers.track[who], walkers.place[who], seen.slope[rows], self._floor
        )

    def _update(
        self, walkers: Walkers, owners: TrackletOwners, seen: FlowFrame
    ) -> tuple[Walkers, TrackletOwners]:
        """Everybody measured, and marked once they have walked."""
        walkers, owners = self._measure(walkers, owners, seen)
        return mark_proven(walkers, self._settings.confirm_distance_m), owners

    def _measure(
        self, walkers: Walkers, owners: TrackletOwners, seen: FlowFrame
    ) -> tuple[Walkers, TrackletOwners]:
        """Everybody where their tracklets and feet say; tracklets that move otherwise set free."""
        if not len(walkers):
            return walkers, owners
        estimate = estimate_places(walkers, owners, seen.slope, self._floor)
        walkers = update_measured(walkers, estimate.place, estimate.error_m)
        found = estimate.count >= _FEWEST
        owners = release_misfits(owners, estimate.misfit, seen.elapsed_s)
        if self._settings.fit_silhouettes:
            walkers, owners, score = self._fit_silhouettes(walkers, owners, seen)
            found &= np.isfinite(score)  # foreground alone may be somebody else's
        missed_s = np.where(found, 0.0, walkers.missed_s)
        walkers = replace(walkers, count=estimate.count, missed_s=missed_s)
        return walkers, adapt_offsets(walkers, owners, seen.slope, self._floor, seen.elapsed_s)

    def _fit_silhouettes(
        self, walkers: Walkers, owners: TrackletOwners, seen: FlowFrame
    ) -> tuple[Walkers, TrackletOwners, Floats]:
        """Everybody drawn to the foreground, their tracklets with them; (m,) how it suits them."""
        cover = draw_cover(walkers.place, self._floor)
        to = fit_silhouettes(walkers.place, seen.mask, cover, self._floor)
        before = walkers.place
        walkers = update_measured(walkers, to.place, to.error_m)
        owners = move_offsets(walkers, owners, seen.slope, walkers.place - before, self._floor)
        empty_s = np.where(to.score < _EMPTY, walkers.empty_s + seen.elapsed_s, 0.0)
        return replace(walkers, empty_s=empty_s), owners, to.score

    def _initiate(
        self, walkers: Walkers, owners: TrackletOwners, seen: FlowFrame
    ) -> tuple[Walkers, TrackletOwners]:
        """With new people: clusters of tracklets of nobody that move and look like somebody."""
        settings = self._settings
        free = np.flatnonzero((owners.owner == 0) & seen.known)
        moving = speeds(seen.tracklets.select(free), POSITIONS, seen.fps, self._floor) > _NEW_M_S
        free = free[moving]
        clusters = self._modes.cluster(seen.vectors(free))
        cover = draw_cover(walkers.place, self._floor)
        for number in range(len(clusters)):
            rows = free[clusters.label == number]
            if np.median(seen.age_s[rows]) < settings.confirm_s:
                continue
            new = locate_birth(
                *(seen.slope[rows], seen.before[rows], seen.over_s),
                *(seen.mask, cover, self._floor),
            )
            if not _is_convincing(new) or _is_crowded(walkers, new.place):
                continue
            walkers, row = self._begin(walkers, new.place, new.pace)
            axis = np.broadcast_to(new.place, (len(rows), 2))
            owner = np.full(len(rows), walkers.track[row], np.int32)
            owners = owners.assign(rows, owner, axis, seen.slope[rows], self._floor)
        return walkers, owners

    def _begin(self, walkers: Walkers, place: Floats, pace: Floats) -> tuple[Walkers, int]:
        """With somebody at a place, and the row: who was lost near there, else somebody new."""
        lost = _find_lost_near(walkers, place, pace)
        if lost is not None:
            return put_at(walkers, lost, place, pace), lost
        one = begin_walkers(self._ids.take(1), place[None], pace[None])
        return walkers.append(one), len(walkers)

    def _terminate(
        self, walkers: Walkers, owners: TrackletOwners
    ) -> tuple[Walkers, TrackletOwners]:
        """Without deleted tracks; of two at one place the surer one has the tracklets."""
        kept = should_keep(walkers, self._settings, self._floor)
        kept &= walkers.empty_s < self._settings.delete_in_view_s
        heir = _heirs(walkers, kept, self._settings.merge_distance_m)
        row = owners.rows_of(walkers)
        owner = np.where(row >= 0, np.append(walkers.track, 0)[np.append(heir, -1)[row]], 0)
        kept &= heir == np.arange(len(walkers))
        owners = replace(owners, owner=owner.astype(np.int32))
        deleted = ~np.isin(owners.owner, walkers.track[kept])
        return walkers.select(kept), owners.release(deleted)


def _is_convincing(new: BirthHypothesis) -> bool:
    """Whether enough of the body is seen, in the foreground, where nobody else explains it."""
    return new.score >= _FILL and new.seen >= _SEEN and new.own >= _OWN


def _is_crowded(walkers: Walkers, place: Floats) -> bool:
    """Whether somebody stands there already."""
    return bool((np.hypot(*(walkers.place - place).T) < _APART_M).any())


def _find_lost_near(walkers: Walkers, place: Floats, pace: Floats) -> int | None:
    """The row of whoever is out of sight and may have come to the place; None: nobody."""
    away = np.hypot(*(walkers.place - place).T)
    alike = np.hypot(*(walkers.pace - pace).T) < _OTHER_PACE_M_S
    near = (
        (walkers.missed_s > _LOST_S)
        & (away < _STRAY_M.radius(walkers.missed_s))
        & alike
        & walkers.walked
    )
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
