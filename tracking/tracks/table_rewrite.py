"""One change of the table, worked out on the index of tracks before anything is touched."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray

from tracking.errors import EditError
from tracking.tracks.columns import CORRECTED_COLUMNS, Columns
from tracking.tracks.validation import (
    LARGEST_NUMBER,
    between,
    check_tracks,
    is_sorted_strictly,
)
from tracking.translation import msg

Slots = NDArray[np.int64]
Frames = NDArray[np.int32]


class Rewriting:
    """Which slots leave and join which track, with the checks that make it reversible.

    Attributes:
        kept: the new slots and their frames, by frame, of every track that changes.
    """

    def __init__(self, look_up: Callable[[int], tuple[Slots, Frames]]) -> None:
        """look_up gives a track's slots and frames as they are before the change."""
        self._look_up = look_up
        self._before: dict[int, tuple[Slots, Frames]] = {}
        self._stays: dict[int, NDArray[np.bool_]] = {}
        self._arriving: dict[int, list[tuple[Slots, Frames]]] = {}
        self._gone: list[Slots] = []
        self._receiving: list[tuple[int, int, int, int]] = []
        self.kept: dict[int, tuple[Slots, Frames]] = {}

    def take_out(self, rows: Columns, read: Callable[[Slots], Columns]) -> None:
        """Mark rows for removal; they must stand in the table exactly as given."""
        for track, chosen in _rows_by_track(rows["track"]):
            slots, frames = self._of(track)
            wanted = rows["frame"][chosen]
            places = np.searchsorted(frames, wanted)
            there = places < len(frames)
            if not (bool(there.all()) and np.array_equal(frames[places], wanted)):
                raise EditError(
                    "track {track} has no row in one of the frames to change", track=track
                )
            self._leave(track, places)
            found = read(slots[places])
            for name in CORRECTED_COLUMNS:
                if found[name].tobytes() != rows[name][chosen].tobytes():
                    raise EditError(
                        "track {track}: {name} is not what the edit was planned on",
                        track=track,
                        name=name,
                    )
            self._gone.append(slots[places])

    def move(self, moves: NDArray[np.int64]) -> None:
        """Hand the rows of each stretch over."""
        for source, target, start, end in moves.tolist():
            slots, frames = self._of(source)
            inside = between(frames, start, end)
            if source == target or target < 1 or inside.start == inside.stop:
                raise EditError(
                    "track {source} has nothing to give in frames {start} to {end}",
                    source=source,
                    start=start,
                    end=end,
                )
            if target > LARGEST_NUMBER:
                raise EditError(
                    "track {target}: ids go up to {largest}; choose another",
                    target=target,
                    largest=LARGEST_NUMBER,
                )
            self._leave(source, np.arange(inside.start, inside.stop))
            self._arrive(target, slots[inside], frames[inside])
            self._receiving.append((target, start, end, inside.stop - inside.start))

    def put_in(self, rows: Columns, first_slot: int) -> None:
        """Add rows, which get slots from first_slot on."""
        check_tracks(rows, msg("rows to add"))
        for track, chosen in _rows_by_track(rows["track"]):
            self._arrive(track, first_slot + chosen, rows["frame"][chosen])

    def check(self) -> None:
        """Work out `kept`; raise EditError where the change does not fit or could not be undone."""
        self.kept = {track: self._joined(track) for track in self._before}
        for target, start, end, count in self._receiving:
            inside = between(self.kept[target][1], start, end)
            if inside.stop - inside.start != count:
                raise EditError(
                    "track {target} has rows of its own in frames {start} to {end}",
                    target=target,
                    start=start,
                    end=end,
                )

    def arriving(self) -> Iterator[tuple[int, Slots]]:
        """Track and slots that now belong to it."""
        for track, parts in self._arriving.items():
            for slots, _ in parts:
                yield track, slots

    def gone(self) -> list[Slots]:
        """Slots that now belong to no track."""
        return self._gone

    def _of(self, track: int) -> tuple[Slots, Frames]:
        if track not in self._before:
            self._before[track] = self._look_up(track)
        return self._before[track]

    def _leave(self, track: int, places: NDArray[np.int64]) -> None:
        stays = self._stays.setdefault(track, np.ones(len(self._of(track)[0]), np.bool_))
        if not bool(stays[places].all()) or not is_sorted_strictly(places):
            raise EditError("track {track}: the edit names the same row twice", track=track)
        stays[places] = False

    def _arrive(self, track: int, slots: Slots, frames: Frames) -> None:
        self._of(track)
        self._arriving.setdefault(track, []).append((slots, frames))

    def _joined(self, track: int) -> tuple[Slots, Frames]:
        slots, frames = self._before[track]
        if track in self._stays:
            slots, frames = slots[self._stays[track]], frames[self._stays[track]]
        arriving = self._arriving.get(track)
        if arriving:
            slots = np.concatenate([slots, *(part[0] for part in arriving)])
            frames = np.concatenate([frames, *(part[1] for part in arriving)])
        if not is_sorted_strictly(frames):
            order = np.argsort(frames, kind="stable")
            slots, frames = slots[order], frames[order]
        if not is_sorted_strictly(frames):
            twice = int(frames[np.argmax(frames[1:] == frames[:-1])])
            raise EditError(
                "track {track} would stand twice in frame {frame}", track=track, frame=twice
            )
        return slots, frames


def _rows_by_track(tracks: NDArray[np.int32]) -> Iterator[tuple[int, NDArray[np.int64]]]:
    """Each track with the numbers of its rows, ascending."""
    if not len(tracks):
        return
    order = np.argsort(tracks, kind="stable")
    ordered = tracks[order]
    starts = np.flatnonzero(np.diff(ordered, prepend=0))
    for rows in np.split(order, starts[1:]):
        if len(rows):
            yield int(tracks[rows[0]]), rows
