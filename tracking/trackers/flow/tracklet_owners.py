"""Which tracklets belong to whom, and where they put their owners."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from tracking.trackers.flow.floor import Floor, sight_axes
from tracking.trackers.flow.walkers import Walkers

Floats = NDArray[np.float64]
Indices = NDArray[np.intp]

BOB_M = 0.03
"""How far bodies move up and down as they walk."""
_SWAY_M = 0.08
_TILT_M = 0.02
_ADAPT_S = 0.8
"""Time in which a tracklet's place in the body follows where the person is found to be."""
_ODD = 3.0
"""In standard deviations."""
_PATIENCE_S = 0.25
_BEYOND_M, _TOO_HIGH_M = 0.36, 1.95


@dataclass(frozen=True, slots=True, eq=False)
class TrackletOwners:
    """Which tracklets belong to whom: a row a tracklet, by id.

    Attributes:
        id: (n,) of the tracklets.
        owner: (n,) int32 tracks; 0: nobody's.
        offset: (n, 2) m on the floor from the person's axis. z_m: (n,) height over the floor.
        odd_s: (n,) how long it has not moved as its person does.
    """

    id: NDArray[np.int64]
    owner: NDArray[np.int32]
    offset: Floats
    z_m: Floats
    odd_s: Floats

    @classmethod
    def none(cls) -> TrackletOwners:
        """Of no tracklets."""
        zero = np.zeros(0)
        return cls(np.zeros(0, np.int64), np.zeros(0, np.int32), np.zeros((0, 2)), zero, zero)

    def for_ids(self, ids: NDArray[np.int64]) -> TrackletOwners:
        """Those of tracklets with these ids (ascending); new ones are nobody's."""
        place = np.searchsorted(self.id, ids)
        known = place < len(self.id)
        known[known] = self.id[place[known]] == ids[known]
        held = TrackletOwners(
            ids,
            np.zeros(len(ids), np.int32),
            np.zeros((len(ids), 2)),
            np.zeros(len(ids)),
            np.zeros(len(ids)),
        )
        rows = place[known]
        for name in ("owner", "offset", "z_m", "odd_s"):
            getattr(held, name)[known] = getattr(self, name)[rows]
        return held

    def rows_of(self, walkers: Walkers) -> Indices:
        """(n,) the row of each tracklet's person among the walkers; -1: nobody's."""
        row = np.searchsorted(walkers.track, self.owner)
        row[row == len(walkers)] = 0
        if not len(walkers):
            return np.full(len(self.id), -1)
        return np.where(walkers.track[row] == self.owner, row, -1)

    def release(self, gone: NDArray[np.bool_]) -> TrackletOwners:
        """With some tracklets nobody's."""
        return replace(
            self, owner=np.where(gone, 0, self.owner), odd_s=np.where(gone, 0.0, self.odd_s)
        )

    def assign(
        self, rows: Indices, owner: NDArray[np.int32], axis: Floats, slope: Floats, floor: Floor
    ) -> TrackletOwners:
        """With the tracklets of some rows given to people whose axes (k, 2) stand there.

        Args:
            rows: k of them. slope: (k, 2) theirs.
        """
        held = replace(
            self,
            owner=self.owner.copy(),
            offset=self.offset.copy(),
            z_m=self.z_m.copy(),
            odd_s=self.odd_s.copy(),
        )
        z_m = floor.heights(slope, axis)
        held.owner[rows], held.z_m[rows], held.odd_s[rows] = owner, z_m, 0.0
        held.offset[rows] = floor.places(slope, z_m) - axis
        return held


@dataclass(frozen=True, slots=True, eq=False)
class PlaceEstimate:
    """Where tracklets put their owners.

    Attributes:
        place: (m, 2) m; NaN where nobody tells.
        error_m: (m, 2) along and across the line of sight.
        misfit: (n,) how far each tracklet is off its person, in standard deviations; NaN: free.
        count: (m,) tracklets that fit.
    """

    place: Floats
    error_m: Floats
    misfit: Floats
    count: NDArray[np.int64]


def estimate_places(
    walkers: Walkers, owners: TrackletOwners, slope: Floats, floor: Floor
) -> PlaceEstimate:
    """Where the tracklets put their people: the weighted median along and across the sight.

    Of low cameras, heads tell little of how far away somebody is, and feet tell most.
    """
    row = owners.rows_of(walkers)
    known = (row >= 0) & np.isfinite(slope).all(axis=1)
    mine = np.flatnonzero(known)
    own = row[mine]
    axes = sight_axes(walkers.place)
    axis = floor.places(slope[mine], owners.z_m[mine]) - owners.offset[mine]
    miss = (axes[own] @ (axis - walkers.place[own])[..., None])[..., 0]
    error = _errors(slope[mine])
    middle = np.stack(
        [_medians(miss[:, k], 1.0 / error[:, k], own, len(walkers)) for k in (0, 1)], axis=1
    )
    misfit = np.full(len(owners.id), np.nan)
    misfit[mine] = np.hypot(*((miss - middle[own]) / error).T)
    fits = misfit[mine] < _ODD
    count = np.bincount(own[fits], minlength=len(walkers))
    place = walkers.place + (np.swapaxes(axes, 1, 2) @ middle[..., None])[..., 0]
    weight = np.bincount(own[fits], 1.0 / error[fits, 0], len(walkers))
    mean = np.maximum(count, 1) / np.maximum(weight, 1e-9)
    few = 1.0 + 2.0 / np.maximum(count, 1)
    spread = np.column_stack((mean * few, _SWAY_M * few))
    none = (count == 0)[:, None]
    return PlaceEstimate(
        np.where(none, np.nan, place), np.where(none, np.nan, spread), misfit, count
    )


def release_misfits(owners: TrackletOwners, misfit: Floats, elapsed_s: float) -> TrackletOwners:
    """Tracklets that have not moved with their person for a while are nobody's."""
    odd = misfit > _ODD
    odd_s = np.where(odd, owners.odd_s + elapsed_s, 0.0)
    gone = (odd_s > _PATIENCE_S) | (misfit > 3 * _ODD)
    return replace(owners, odd_s=odd_s).release(gone)


def adapt_offsets(
    walkers: Walkers, owners: TrackletOwners, slope: Floats, floor: Floor, elapsed_s: float
) -> TrackletOwners:
    """The tracklets' places in their bodies drawn to where the people are found to stand.

    Those that would lie beside the body are set free.
    """
    row = owners.rows_of(walkers)
    mine = np.flatnonzero((row >= 0) & np.isfinite(slope).all(axis=1))
    axis = walkers.place[row[mine]]
    share = 1.0 - np.exp(-elapsed_s / _ADAPT_S)
    z_m, offset = owners.z_m.copy(), owners.offset.copy()
    now = floor.heights(slope[mine], axis)
    z_m[mine] += share * (now - z_m[mine])
    off = floor.places(slope[mine], z_m[mine]) - axis
    offset[mine] += share * (off - offset[mine])
    beyond = np.zeros(len(row), bool)
    beyond[mine] = (np.hypot(*off.T) > _BEYOND_M) | (now > _TOO_HIGH_M)
    return replace(owners, z_m=z_m, offset=offset).release(beyond)


def move_offsets(
    walkers: Walkers, owners: TrackletOwners, slope: Floats, by: Floats, floor: Floor
) -> TrackletOwners:
    """The tracklets' places in their bodies after people were put elsewhere, `by` (m, 2) m.

    Tracklets tell how people move, and where across the line of sight they are, but not how far
    away: that is believed at once.
    """
    row = owners.rows_of(walkers)
    mine = np.flatnonzero((row >= 0) & np.isfinite(slope).all(axis=1))
    z_m, offset = owners.z_m.copy(), owners.offset.copy()
    along = sight_axes(walkers.place)[:, 0]
    own = (along * (along * by).sum(axis=1)[:, None])[row[mine]]
    spot = floor.places(slope[mine], z_m[mine])
    axis = spot - offset[mine] + own
    z_m[mine] = floor.heights(slope[mine], spot + own)
    offset[mine] = floor.places(slope[mine], z_m[mine]) - axis
    return replace(owners, z_m=z_m, offset=offset)


def _errors(slope: Floats) -> Floats:
    """(n, 2) m standard deviations of the axis that tracklets tell, along and across the sight."""
    steep = np.hypot(slope[:, 0], slope[:, 1])
    return np.column_stack((_TILT_M + BOB_M * (1.0 + steep), np.full(len(slope), _SWAY_M)))


def _medians(value: Floats, weight: Floats, group: Indices, groups: int) -> Floats:
    """(groups,) weighted medians; 0 of a group without values."""
    order = np.lexsort((value, group))
    value, weight, group = value[order], weight[order], group[order]
    total = np.bincount(group, weight, groups)
    before = np.cumsum(total) - total
    share = np.cumsum(weight) - before[group] - weight / 2
    upper = share >= total[group] / 2
    middle = np.zeros(groups)
    at = np.flatnonzero(upper)[::-1]
    middle[group[at]] = value[at]  # the lowest of the upper half is written last
    last = np.append(group[1:] != group[:-1], True) if len(group) else np.zeros(0, bool)
    alone = last & ~upper
    middle[group[alone]] = value[alone]
    return middle
