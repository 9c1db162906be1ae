"""The corrected table: who is where in which frame.

Made for ten million rows. A row lives in a slot whose frame and values never change; only the
track a slot belongs to does (0: to none, the row is deleted). A change of identity is therefore
a write of a few integers, a deletion likewise, and the values can be shared with the run they
came from and with snapshots. Rows that are added stand behind the others, in the tail.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tracking.errors import EditError
from tracking.tracks.columns import CORRECTED_COLUMNS, Columns, Source, empty
from tracking.tracks.growable_columns import ColumnInOrder, Growing
from tracking.tracks.row_keys import row_keys
from tracking.tracks.run import ParticleColumn
from tracking.tracks.table_rewrite import Rewriting
from tracking.tracks.validation import LARGEST_NUMBER, between, check_tracks, checked_columns
from tracking.translation import msg

Slots = NDArray[np.int64]
Frames = NDArray[np.int32]
_VALUES = tuple(name for name in CORRECTED_COLUMNS if name != "track")
_SMALLEST_LONG_TAIL = 200_000
_NO_SLOTS: Slots = np.zeros(0, np.int64)
_NO_FRAMES: Frames = np.zeros(0, np.int32)


class TrackTable:
    """Rows of `CORRECTED_COLUMNS`, at most one a frame and track.

    Reading is free to all; only `tracking.editing.apply_change` calls `rewrite`.
    """

    def __init__(
        self, columns: Mapping[str, ArrayLike] | None = None, *, highest_track: int = 0
    ) -> None:
        """Take over columns sorted by frame, then track; the arrays are kept, never written to.

        A run's columns do: `source` may be missing and is then the tracker. highest_track is the
        highest id ever used, where that is higher than any in the columns.
        Raises EditError for columns that are no table (see `checked_columns`, `check_tracks`).
        """
        if not 0 <= highest_track <= LARGEST_NUMBER:
            raise EditError(
                "highest track {highest_track}: ids are 1 to {largest}",
                highest_track=highest_track,
                largest=LARGEST_NUMBER,
            )
        given: dict[str, ArrayLike] = dict(empty(CORRECTED_COLUMNS) if columns is None else columns)
        if "source" not in given and "frame" in given:
            given["source"] = np.full(len(np.asarray(given["frame"])), Source.TRACKER, np.uint8)
        checked = checked_columns(given, CORRECTED_COLUMNS)
        check_tracks(checked)
        self._revision = 0
        self._highest_track = max(highest_track, int(checked["track"].max(initial=0)))
        self._hold(checked)

    def _hold(self, columns: dict[str, NDArray[Any]]) -> None:
        """Start from sorted rows without a tail."""
        self._base = {name: _read_only(columns[name]) for name in _VALUES}
        self._tail = {name: self._base[name][:0] for name in _VALUES}
        self._tail_order: Slots = np.zeros(0, np.int64)
        self._track = columns["track"].copy()
        self._growing: dict[str, Growing] = {}
        self._sorted: dict[str, NDArray[Any]] | None = {
            name: _read_only(columns[name]) for name in CORRECTED_COLUMNS
        }
        self._slots: dict[int, tuple[Slots, Frames]] | None = None

    # Reading

    def __len__(self) -> int:
        """The number of rows."""
        return sum(len(slots) for slots, _ in self._index.values())

    @property
    def revision(self) -> int:
        """Goes up with every change; what was computed from the table is good while it stays."""
        return self._revision

    @property
    def highest_track(self) -> int:
        """The highest id ever used, also by tracks that are gone; ids are never used again."""
        return self._highest_track

    @property
    def track_ids(self) -> tuple[int, ...]:
        """The ids of all tracks with at least one row, ascending."""
        return tuple(sorted(self._index))

    @property
    def frame_stop(self) -> int:
        """One past the last frame with a row; 0 for an empty table."""
        ends = [self.frame_range(track)[1] for track in self._index]
        return max(ends, default=0)

    def __contains__(self, track: object) -> bool:
        """Whether the track has a row."""
        return track in self._index

    def of_frame(self, frame: int) -> dict[str, NDArray[Any]]:
        """The rows of one frame, sorted by track; empty where nobody is."""
        inside = between(self._base["frame"], frame, frame + 1)
        slots = np.arange(inside.start, inside.stop)
        if len(self._tail_order):
            frames = self._tail["frame"][self._tail_order]
            late = self._tail_order[between(frames, frame, frame + 1)]
            slots = np.concatenate([slots, len(self._base["frame"]) + late])
        tracks = self._track[slots]
        order = np.argsort(tracks, kind="stable")
        return self._rows(slots[order[np.count_nonzero(tracks == 0) :]])

    def of_track(
        self, track: int, start: int = 0, end: int | None = None
    ) -> dict[str, NDArray[Any]]:
        """The rows of one track in the half-open range of frames, sorted by frame."""
        slots, frames = self._of(track)
        stop = LARGEST_NUMBER if end is None else end
        return self._rows(slots[between(frames, start, stop)])

    def of_tracks(self, tracks: Iterable[int], start: int, end: int) -> dict[str, NDArray[Any]]:
        """The rows of `of_track` of some tracks, one track after the other, read at once."""
        found = map(self._of, tracks)
        parts = [slots[between(frames, start, end)] for slots, frames in found]
        return self._rows(np.concatenate(parts) if parts else _NO_SLOTS)

    def by_track(
        self, names: Iterable[str], tracks: Iterable[int] | None = None
    ) -> dict[str, NDArray[Any]]:
        """Some columns of all tracks, or of some, sorted by track then frame.

        Quicker than sorting `columns()`, and nothing but what is asked for is read.
        """
        asked = self._index if tracks is None else self._index.keys() & set(tracks)
        parts = [self._index[track][0] for track in sorted(asked)]
        slots = np.concatenate(parts) if parts else _NO_SLOTS
        return {name: self._column(name, slots) for name in names}

    def frames_of_track(self, track: int) -> NDArray[np.int32]:
        """The frames in which the track stands, ascending; empty for an unknown track."""
        return self._of(track)[1]

    def frame_range(self, track: int) -> tuple[int, int]:
        """First frame and one past the last of a track; (0, 0) for an unknown one."""
        frames = self._of(track)[1]
        return (int(frames[0]), int(frames[-1]) + 1) if len(frames) else (0, 0)

    def activity(self, frame_count: int) -> NDArray[np.uint16]:
        """(frame_count,) the number of people in each frame."""
        frames = np.concatenate([self._base["frame"], self._tail["frame"]])[self._track > 0]
        counts = np.bincount(frames[frames < frame_count], minlength=frame_count)
        return np.minimum(counts, np.iinfo(np.uint16).max).astype(np.uint16)

    def columns(self) -> dict[str, NDArray[Any]]:
        """All rows, sorted by frame then track: read-only arrays."""
        if self._sorted is None:
            self._sorted = self._sort()
        return dict(self._sorted)

    def in_order(self) -> Mapping[str, ParticleColumn]:
        """The columns of `columns()`, to be read by slices: no sorted copy is kept of them."""
        if self._sorted is not None:
            return dict(self._sorted)
        order = self._order()
        return {
            name: ColumnInOrder(partial(self._column, name), order) for name in CORRECTED_COLUMNS
        }

    def snapshot(self) -> TrackTable:
        """A table of its own with the rows of now; quick, the values are shared."""
        copy = TrackTable.__new__(TrackTable)
        copy._revision, copy._highest_track = self._revision, self._highest_track
        copy._base, copy._tail, copy._tail_order = self._base, self._tail, self._tail_order
        copy._track, copy._growing = self._track.copy(), {}
        copy._sorted = self._sorted
        copy._slots = None if self._slots is None else dict(self._slots)
        return copy

    # Changing

    def rewrite(self, out: Columns, moves: NDArray[np.int64], rows: Columns) -> None:
        """Take rows out, hand stretches from track to track, put rows in; all or nothing.

        Only `tracking.editing.apply_change` calls this.

        Args:
            out: `CORRECTED_COLUMNS` of rows that stand in the table with exactly these values.
            moves: (k, 4) from track, to track, start, end: the rows of a track in that half-open
                range go over to the other, all at once.
            rows: `CORRECTED_COLUMNS` to put in.

        Raises:
            EditError: a row to take out is not there, a place is taken, or the moves could not be
                undone exactly because the receiving track has rows of its own in the range.
        """
        added = checked_columns(rows, CORRECTED_COLUMNS, msg("rows to add"))
        plan = Rewriting(self._of)
        plan.take_out(out, self._rows)
        plan.move(moves)
        plan.put_in(added, first_slot=len(self._track))
        plan.check()
        self._append(added)
        for track, slots in plan.arriving():
            self._track[slots] = track
        for slots in plan.gone():
            self._track[slots] = 0
        self._index.update(plan.kept)
        for track in [track for track, (slots, _) in plan.kept.items() if not len(slots)]:
            del self._index[track]
        self._highest_track = max([self._highest_track, *plan.kept])
        self._revision += 1
        self._sorted = None
        self._shorten_tail()

    def _append(self, rows: dict[str, NDArray[Any]]) -> None:
        added = len(rows["frame"])
        if not added:
            return
        before = len(self._tail["frame"])
        frames = self._tail["frame"][self._tail_order]
        order = np.argsort(rows["frame"], kind="stable")
        places = np.searchsorted(frames, rows["frame"][order], side="right")
        self._tail_order = np.insert(self._tail_order, places, before + order)
        if not self._growing:
            held = {**self._tail, "track": self._track}
            self._growing = {name: Growing(array) for name, array in held.items()}
        self._tail = {
            name: _read_only(self._growing[name].with_more(rows[name])) for name in _VALUES
        }
        self._track = self._growing["track"].with_more(np.zeros(added, np.int32))

    def _shorten_tail(self) -> None:
        """Sort everything anew once the tail has grown long; seldom enough to cost nothing."""
        if len(self._tail["frame"]) > max(_SMALLEST_LONG_TAIL, len(self._base["frame"]) // 4):
            self._hold(self._sort())

    def _sort(self) -> dict[str, NDArray[Any]]:
        rows = self._rows(self._order())
        return {name: _read_only(column) for name, column in rows.items()}

    def _order(self) -> Slots:
        """The slots of all rows, by frame then track."""
        frames = np.concatenate([self._base["frame"], self._tail["frame"]])
        order = np.argsort(row_keys(frames, self._track), kind="stable")
        return order[self._track[order] > 0]

    # Slots

    @property
    def _index(self) -> dict[int, tuple[Slots, Frames]]:
        """Per track its slots and their frames, by frame; made at first use."""
        if self._slots is None:
            frames = np.concatenate([self._base["frame"], self._tail["frame"]])
            order = np.argsort(frames, kind="stable") if len(self._tail_order) else None
            self._slots = _by_track(self._track, frames, order)
        return self._slots

    def _of(self, track: int) -> tuple[Slots, Frames]:
        return self._index.get(track, (_NO_SLOTS, _NO_FRAMES))

    def _rows(self, slots: Slots) -> dict[str, NDArray[Any]]:
        return {name: self._column(name, slots) for name in CORRECTED_COLUMNS}

    def _column(self, name: str, slots: Slots) -> NDArray[Any]:
        if name == "track":
            return self._track[slots]
        base, tail = self._base[name], self._tail[name]
        if not len(tail):
            return base[slots]
        in_tail = slots >= len(base)
        values = np.empty(len(slots), base.dtype)
        values[~in_tail] = base[slots[~in_tail]]
        values[in_tail] = tail[slots[in_tail] - len(base)]
        return values


def _by_track(
    tracks: NDArray[np.int32], frames: Frames, by_frame: Slots | None
) -> dict[int, tuple[Slots, Frames]]:
    """Group slots and frames by track; by_frame: the slots' order, None where they are in order."""
    # NumPy sorts 16-bit numbers by radix: two passes are far quicker than one sort of 32 bits.
    order = np.arange(len(tracks)) if by_frame is None else by_frame
    order = order[np.argsort(tracks[order].astype(np.uint16), kind="stable")]
    if int(tracks.max(initial=0)) > np.iinfo(np.uint16).max:
        order = order[np.argsort((tracks[order] >> 16).astype(np.uint16), kind="stable")]
    ordered = tracks[order]
    cuts = np.flatnonzero(ordered[1:] != ordered[:-1]) + 1
    starts = np.concatenate([[0], cuts])[: len(ordered)]
    slots, places = np.split(order, cuts), np.split(frames[order], cuts)
    groups = zip(ordered[starts].tolist(), zip(slots, places, strict=True), strict=False)
    return {track: group for track, group in groups if track > 0}


def _read_only(array: NDArray[Any]) -> NDArray[Any]:
    view = array.view()
    view.flags.writeable = False
    return view


def next_track(table: TrackTable) -> int:
    """The id of a new track: one more than the highest ever used. EditError where none is left."""
    if table.highest_track >= LARGEST_NUMBER:
        raise EditError(
            "no id above {largest} is left for a new track; use a known one", largest=LARGEST_NUMBER
        )
    return table.highest_track + 1


def check_known(table: TrackTable, *tracks: int) -> None:
    """Raise EditError where a track has no row."""
    for track in tracks:
        if track not in table:
            known = table.track_ids
            span = (
                msg(
                    "there are {count}, from {first} to {last}",
                    count=len(known),
                    first=known[0],
                    last=known[-1],
                )
                if known
                else msg("no tracks")
            )
            raise EditError("track {track} is not in the table ({span})", track=track, span=span)
