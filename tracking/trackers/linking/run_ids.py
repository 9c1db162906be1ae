"""Renames the tracks of a run: every table alike, gaps filled."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.geometry import View
from tracking.trackers.linking.gap_rows import fill_gaps
from tracking.trackers.linking.part_gaps import fill_part_gaps
from tracking.trackers.linking.seen_rows import Integers, keys
from tracking.tracks.columns import Columns
from tracking.tracks.run import ParticleColumn, Particles, Run

Rows = NDArray[np.intp]
Ids = NDArray[np.int32]


def rename_tracks(
    run: Run, row: Rows, name: Integers, view: View, fps: float, longest_gap_s: float
) -> Run:
    """The run with one id for each person.

    Rows without a detection go with those before them until the person is seen again; where the
    tracker has none in a short gap, predicted ones are added, with body parts if there were any.
    Those of nobody, and those after somebody was seen last, are left out with their parts, and
    their particles are of track 0.

    Args:
        row: (k,) of the run's tracks, those that were seen, by track and frame.
        name: (k,) their new ids; 0: nobody's.
        longest_gap_s: that is filled.
    """
    new = _of_rows(run.tracks, row, name, run.frames[1] - 1)
    names = _Ids.of(run.tracks, new)
    tracks, signals = fill_gaps(_with_ids(run.tracks, new), run.signals, view, fps, longest_gap_s)
    return replace(
        run,
        tracks=tracks,
        signals=signals,
        detections=names.rename(run.detections),
        associations=_sort(names.rename(run.associations)),
        particles=names.rename_particles(run.particles),
        parts=fill_part_gaps(_sort(names.rename(run.parts), "part"), tracks),
        part_particles=names.rename_particles(run.part_particles),
        tracklets=names.rename_particles(run.tracklets),
    )


def _of_rows(tracks: Columns, row: Rows, name: Integers, last_frame: int) -> Ids:
    """(rows,) the new id of every row of the tracks; 0: it is left out."""
    frame, track = tracks["frame"].astype(np.int64), tracks["track"].astype(np.int64)
    new = track.copy()
    new[row] = name
    unseen = np.isin(track, track[row])
    unseen[row] = False
    rows = np.flatnonzero(unseen)
    new[rows] = 0
    # They go with the row before them, and where that person is somewhere else, with the next.
    after = np.searchsorted(keys(track[row], frame[row]), keys(track[rows], frame[rows]))
    for neighbour in (after - 1, after):
        at = np.clip(neighbour, 0, len(row) - 1)
        good = (at == neighbour) & (track[row[at]] == track[rows]) & (new[rows] == 0)
        free = _is_free(new, frame, rows[good], name[at[good]])
        new[rows[good][free]] = name[at[good]][free]
    new[_guesses(frame, new, row, last_frame)] = 0
    return new.astype(np.int32)


def _guesses(frame: Integers, new: Integers, row: Rows, last_frame: int) -> Rows:
    """Rows before somebody was seen for the first time, and after the last: guesses.

    Whoever is followed to the last frame has not left: the footage ends.
    """
    last = np.zeros(int(new.max()) + 1, np.int64)
    first = np.full(len(last), np.iinfo(np.int64).max)
    np.maximum.at(last, new[row], frame[row])
    np.minimum.at(first, new[row], frame[row])
    last[new[frame == last_frame]] = last_frame
    seen = np.isin(new, new[row])
    return np.flatnonzero(seen & ((frame > last[new]) | (frame < first[new])))


def _is_free(new: Integers, frame: Integers, rows: Rows, name: Integers) -> NDArray[np.bool_]:
    """(k,) whether nobody of that name has a row in the frame yet."""
    taken = np.isin(keys(frame[rows], name), keys(frame[new > 0], new[new > 0]))
    first = np.zeros(len(rows), bool)
    first[np.unique(keys(frame[rows], name), return_index=True)[1]] = True
    return np.asarray(~taken & first)


def _with_ids(tracks: Columns, new: Ids) -> dict[str, NDArray[Any]]:
    return {**tracks, "track": new}


def _sort(columns: Columns, *then: str) -> Columns:
    """By frame, then track, then other columns; without those of nobody."""
    order = np.lexsort((*(columns[name] for name in then), columns["track"], columns["frame"]))
    order = order[columns["track"][order] > 0]
    return {name: column[order] for name, column in columns.items()}


@dataclass(frozen=True, slots=True)
class _Ids:
    """New ids by frame and old id.

    Attributes:
        key: (n,) ascending; see `keys`. new: (n,).
    """

    key: Integers
    new: Ids

    @classmethod
    def of(cls, tracks: Columns, new: Ids) -> _Ids:
        key = keys(tracks["frame"], tracks["track"])
        order = np.argsort(key)
        return cls(key[order], new[order])

    def look_up(self, frame: NDArray[np.integer], track: NDArray[np.integer]) -> Ids:
        """(n,) new ids; what has no row keeps its own."""
        wanted = keys(frame, track)
        at = np.minimum(np.searchsorted(self.key, wanted), len(self.key) - 1)
        return np.where(self.key[at] == wanted, self.new[at], track).astype(np.int32)

    def rename(self, columns: Columns) -> Columns:
        return {**columns, "track": self.look_up(columns["frame"], columns["track"])}

    def rename_particles(self, particles: Particles) -> Particles:
        """The particles, of each frame, under the new ids; those in a file stay there."""
        track = particles.columns["track"]
        column = RenamedTracks(track, particles.start, self)
        whole = np.asarray(column) if isinstance(track, np.ndarray) else column
        return Particles(particles.start, {**particles.columns, "track": whole})


@dataclass(frozen=True, slots=True)
class RenamedTracks:
    """A column of particles' tracks that is renamed as it is read.

    Attributes:
        track: the column with the old ids. start: see `Particles`.
    """

    track: ParticleColumn
    start: NDArray[np.int64]
    names: _Ids

    def __len__(self) -> int:
        return len(self.track)

    def __getitem__(self, rows: slice, /) -> NDArray[Any]:
        first, stop, _ = rows.indices(len(self))
        track = np.asarray(self.track[first:stop])
        if not len(track):
            return track
        # Each person's particles stand together: one look-up for all of them.
        low, high = np.searchsorted(self.start, (first, stop - 1), side="right")
        changes = np.flatnonzero(track[1:] != track[:-1]) + 1
        begin = np.unique(np.concatenate(((0,), self.start[low:high] - first, changes)))
        frame = np.searchsorted(self.start, begin + first, side="right") - 1
        new = self.names.look_up(frame, track[begin])
        return np.repeat(new, np.diff(begin, append=len(track)))

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        return np.asarray(self[:], dtype)
