"""People as the clusters of each frame: the paper's own way."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

from tracking.trackers.flow.floor import Floor
from tracking.trackers.flow.flow_frame import POSITIONS, FlowFrame, speeds
from tracking.trackers.flow.kernels import KernelTable
from tracking.trackers.flow.mean_shift import Clusters
from tracking.trackers.flow.mode_updates import ModeUpdater
from tracking.trackers.flow.settings import FlowSettings
from tracking.trackers.flow.track_retention import should_keep
from tracking.trackers.flow.walkers import (
    Walkers,
    begin_walkers,
    mark_proven,
    no_walkers,
    predict,
    update_measured,
)
from tracking.trackers.shared.tracker_base import TrackIds

Floats = NDArray[np.float64]
Indices = NDArray[np.intp]

_ERROR_M, _ERROR_SHARE = 0.1, 0.05
"""Of the place of a cluster, and along the line of sight times the distance."""


class ClusteredPeople:
    """[Yoneji2013]: mean shift of all tracklets that move; a cluster is a person.

    The paper counts clusters and leaves open who is who. Here a cluster is the person whose
    tracklets of the frame before it shares most of, and stands where the middle of its body, at
    the height its kernel was made for, is seen; a Kalman filter smooths that.
    """

    def __init__(
        self, settings: FlowSettings, table: KernelTable, floor: Floor, ids: TrackIds
    ) -> None:
        """Nobody is followed yet; new people get the next ids."""
        self._settings = settings
        self._table = table
        self._floor = floor
        self._modes = ModeUpdater(settings.clusters, table)
        self._new_ids = ids
        self._ids = np.zeros(0, np.int64)
        self.owner = np.zeros(0, np.int32)
        self.walkers = no_walkers()

    def step(self, seen: FlowFrame) -> None:
        """Take one frame further: predict, terminate, associate, update, initiate.

        There is no gate: a cluster is whose tracklets it shares, wherever it is.
        """
        place, label = self._cluster(seen)
        walkers = predict(self.walkers, seen.elapsed_s)
        walkers = walkers.select(should_keep(walkers, self._settings, self._floor))
        who = _associate(label, self._owner_before(seen), walkers, len(place))
        walkers = self._update(walkers, who, place, label)
        track = np.where(who >= 0, np.append(walkers.track, 0)[who], 0).astype(np.int32)
        walkers, track = self._initiate(walkers, track, place, label, seen)
        self.owner = np.append(track, np.int32(0))[label]
        self._ids, self.walkers = seen.tracklets.id, walkers

    def _cluster(self, seen: FlowFrame) -> tuple[Floats, Indices]:
        """(clusters, 2) m where they stand, and (n,) the cluster of each tracklet; -1: none."""
        rows = self._moving_rows(seen)
        clusters = self._modes.cluster(seen.vectors(rows))
        label = np.full(len(seen.tracklets), -1)
        label[rows] = clusters.label
        return self._places(clusters), label

    def take_over(self, walkers: Walkers, seen: FlowFrame) -> None:
        """Go on with these people; clusters nearest to them are theirs."""
        self.walkers = walkers
        self._ids = seen.tracklets.id
        place, label = self._cluster(seen)
        self.owner = np.zeros(len(seen.tracklets), np.int32)
        if len(place) and len(walkers):
            away = place[:, None] - walkers.place
            nearest = np.hypot(away[..., 0], away[..., 1]).argmin(axis=1)
            self.owner = np.append(walkers.track[nearest], np.int32(0))[label]

    def _moving_rows(self, seen: FlowFrame) -> Indices:
        """The rows of tracklets that do not stand still."""
        speed = speeds(seen.tracklets, POSITIONS, seen.fps, self._floor)
        return np.flatnonzero(seen.known & (speed > self._settings.points.min_speed_m_s))

    def _owner_before(self, seen: FlowFrame) -> NDArray[np.int32]:
        """(n,) whose each tracklet was in the frame before; 0: nobody's."""
        place = np.searchsorted(self._ids, seen.tracklets.id)
        known = place < len(self._ids)
        known[known] = self._ids[place[known]] == seen.tracklets.id[known]
        owner = np.zeros(len(seen.tracklets), np.int32)
        owner[known] = self.owner[place[known]]
        return owner

    def _places(self, clusters: Clusters) -> Floats:
        """(m, 2) m where the bodies stand whose upper part, or all, the clusters are."""
        middle = clusters.mode[:, 0].copy()
        whole = self._table.at(middle)[:, 1]
        settings = self._settings.clusters
        middle[:, 1] += np.maximum(whole - clusters.size[:, 1], 0.0) / 2 / settings.bodies
        height_m = settings.centre_m
        return self._floor.places(self._floor.slopes(middle), np.full(len(middle), height_m))

    def _update(self, walkers: Walkers, who: Indices, place: Floats, label: Indices) -> Walkers:
        """Everybody where their clusters are, and marked once they have walked."""
        there = np.full((len(walkers), 2), np.nan)
        own = who >= 0
        there[who[own]] = place[own]
        distance = np.hypot(walkers.place[:, 0], walkers.place[:, 1])
        error = np.column_stack(
            (_ERROR_M + _ERROR_SHARE * distance, np.full(len(walkers), _ERROR_M))
        )
        walkers = update_measured(walkers, there, error)
        count = np.zeros(len(walkers), np.int64)
        count[who[own]] = np.bincount(label[label >= 0], minlength=len(who))[own]
        missed_s = np.where(count > 0, 0.0, walkers.missed_s)
        walkers = replace(walkers, count=count, missed_s=missed_s)
        return mark_proven(walkers, self._settings.confirm_distance_m)

    def _initiate(
        self,
        walkers: Walkers,
        track: NDArray[np.int32],
        place: Floats,
        label: Indices,
        seen: FlowFrame,
    ) -> tuple[Walkers, NDArray[np.int32]]:
        """Clusters that are nobody's, and have moved for a while, as new people."""
        track = track.copy()
        for number in np.flatnonzero((track == 0) & np.isfinite(place).all(axis=1)):
            rows = np.flatnonzero(label == number)
            if np.median(seen.age_s[rows]) < self._settings.confirm_s:
                continue
            new = self._new_ids.take(1)
            track[number] = new[0]
            one = begin_walkers(new, place[number : number + 1], np.zeros((1, 2)))
            walkers = walkers.append(replace(one, count=np.array([len(rows)])))
        return walkers, track


def _associate(
    label: Indices, before: NDArray[np.int32], walkers: Walkers, clusters: int
) -> Indices:
    """(clusters,) the row of the person each shares most tracklets with; -1: none."""
    row = np.searchsorted(walkers.track, before)
    row = np.minimum(row, max(len(walkers) - 1, 0))
    who = np.full(clusters, -1)
    if not len(walkers) or not clusters:
        return who
    both = (label >= 0) & (walkers.track[row] == before)
    shared = np.zeros((clusters, len(walkers)))
    np.add.at(shared, (label[both], row[both]), 1.0)
    ours, theirs = linear_sum_assignment(-shared)
    good = shared[ours, theirs] > 0
    who[ours[good]] = theirs[good]
    return who
