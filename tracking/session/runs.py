"""Runs that stay in the session file until somebody looks at them."""

from __future__ import annotations

import json
from collections import OrderedDict
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass, fields, replace
from pathlib import Path
from typing import Any, overload

import h5py
import numpy as np
from numpy.typing import NDArray

from tracking.errors import EditError, SessionError
from tracking.session.hdf5 import open_readonly, read_columns, read_rows, text_attribute
from tracking.session.image_file import ImageFile
from tracking.session.layout import CHUNK_ROWS, RUN_TABLES
from tracking.session.run_notes import read_notes
from tracking.stamps import now
from tracking.trackers import present_settings
from tracking.tracks import (
    LARGEST_NUMBER,
    Columns,
    DetectionsInput,
    Particles,
    Run,
    check_tracks,
    empty,
)

_BLOCKS_KEPT = 16


_SMALL_BYTES = 1 << 16
_INPUT = "detections_input"


@dataclass(frozen=True, slots=True)
class StoredRun:
    """A run in a session file that was checked.

    Attributes:
        path: the file; it may be replaced by a later save, which holds the same runs.
        number: of the run.
    """

    path: Path
    number: int

    def load(self) -> Run:
        """The run: its tables in memory, particles as they are asked for.

        What a file of an older format does not have is there with all its columns and no rows.
        Raises SessionError where the file is damaged or out of reach.
        """
        with open_readonly(self.path) as file:
            group = file[f"runs/{self.number}"]
            tables: dict[str, Any] = {
                name: self._particles(group, name) if table.by_frame else _read_table(group, name)
                for name, table in RUN_TABLES.items()
            }
            first, stop = (int(frame) for frame in group.attrs["frames"])
            _check_run(tables["tracks"], (first, stop))
            return Run(
                tracker=text_attribute(group, "tracker"),
                settings=read_settings(group),
                seed=int(group.attrs["seed"]),
                frames=(first, stop),
                **tables,
                software=text_attribute(group, "software"),
                detector=text_attribute(group, "detector"),
                known_tracks=_known_tracks(group),
                made=text_attribute(group, "made") if "made" in group.attrs else "",
                notes=read_notes(group),
                detections_input=read_detections_input(file).get(self.number, ()),
            )

    def tracker(self) -> str:
        """The name of its tracker, without loading it. Raises SessionError as `load`."""
        with open_readonly(self.path) as file:
            return text_attribute(file[f"runs/{self.number}"], "tracker")

    def detections_input(self) -> tuple[DetectionsInput, ...]:
        """The detections of another program that it was given. Raises SessionError as `load`."""
        with open_readonly(self.path) as file:
            return read_detections_input(file).get(self.number, ())

    def copy_into(self, image: ImageFile, target: h5py.Group) -> None:
        """Copy the run as it is, packed bytes and all, into a group of another file.

        Raises SessionError where this file is damaged, OSError where the other's disk refuses.
        """
        copy_group(self.path, f"runs/{self.number}", image, target)

    def _particles(self, run: h5py.Group, table: str) -> Particles:
        if table not in run:
            return Particles.none(RUN_TABLES[table].columns)
        group = run[table]
        start = group["start"][()]
        rows = len(group[next(iter(RUN_TABLES[table].columns))])
        if not len(start) or start[0] != 0 or start[-1] != rows or bool((np.diff(start) < 0).any()):
            raise SessionError(
                "{path}: the {table} of run {number} are not one frame's after another's; the "
                "file is damaged",
                path=self.path,
                table=table,
                number=self.number,
            )
        name = f"runs/{self.number}/{table}"
        return Particles(
            start,
            {
                column: StoredColumn(self.path, f"{name}/{column}", rows, dtype)
                if column in group
                else np.broadcast_to(_unknown(dtype), rows)
                for column, dtype in RUN_TABLES[table].columns.items()
            },
        )


def read_settings(group: h5py.Group) -> dict[str, Any]:
    """The settings of a run in its group, by the names that its tracker's settings have now.

    Raises ValueError for what is none.
    """
    settings = json.loads(text_attribute(group, "settings"))
    if not isinstance(settings, dict):
        raise ValueError(f"attribute settings of {group.name} does not name settings")
    return present_settings(text_attribute(group, "tracker"), settings)


def read_detections_input(file: h5py.File) -> dict[int, tuple[DetectionsInput, ...]]:
    """By the number of a run, the detections of another program that it was given."""
    found: dict[int, tuple[DetectionsInput, ...]] = {}
    for row in read_rows(file[_INPUT]) if _INPUT in file else ():
        run = row.pop("run")
        found[run] = (*found.get(run, ()), DetectionsInput(**row))
    return found


def detections_input_rows(runs: Sequence[Run | StoredRun]) -> dict[str, list[Any]]:
    """The same as columns of the table that `read_detections_input` reads; "run" may be empty.

    Raises SessionError where a run's file cannot be read.
    """
    rows: dict[str, list[Any]] = {"run": []}
    rows |= {field.name: [] for field in fields(DetectionsInput)}
    for number, run in enumerate(runs):
        given = run.detections_input() if isinstance(run, StoredRun) else run.detections_input
        for each in given:
            rows["run"].append(number)
            for name, value in asdict(each).items():
                rows[name].append(value)
    return rows


def _read_table(run: h5py.Group, name: str) -> Columns:
    """A run's table; what came with a later format is filled where it is missing."""
    types = RUN_TABLES[name].columns
    if name not in run:
        return empty(types)
    columns = read_columns(run[name])
    rows = len(columns["frame"])
    return {
        column: columns[column] if column in columns else np.full(rows, _unknown(dtype))
        for column, dtype in types.items()
    }


def _unknown(dtype: np.dtype[Any]) -> Any:
    """What a column that came with a later format holds where it is missing."""
    return dtype.type(np.nan if dtype.kind == "f" else 0)


def _known_tracks(group: h5py.Group) -> int:
    """Raises ValueError for what is no id; sessions made before runs could go on have none."""
    known = int(group.attrs.get("known_tracks", 0))
    if not 0 <= known <= LARGEST_NUMBER:
        raise ValueError(f"a run that knows tracks up to {known}")
    return known


def _check_run(tracks: Columns, frames: tuple[int, int]) -> None:
    """Raise ValueError where a file's run cannot be what a tracker found."""
    if not 0 <= frames[0] <= frames[1] <= LARGEST_NUMBER:
        raise ValueError(f"a run over frames {frames[0]} to {frames[1]}")
    try:
        check_tracks(tracks, "a run's tracks")
    except EditError as why:
        raise ValueError(str(why)) from why


class StoredColumn:
    """A column in a file, read block by block and kept for a while.

    The file is open only while a block is read: an open file cannot be replaced everywhere.
    """

    def __init__(self, path: Path, dataset: str, length: int, dtype: np.dtype[Any]) -> None:
        """A dataset of that length and type."""
        self._path, self._dataset = path, dataset
        self._length, self._dtype = length, dtype
        self._blocks: OrderedDict[int, NDArray[Any]] = OrderedDict()

    def __len__(self) -> int:
        """The number of rows."""
        return self._length

    def __getitem__(self, rows: slice) -> NDArray[Any]:
        """A stretch of rows, read-only."""
        start, stop, _ = slice(rows.start, rows.stop).indices(self._length)
        if stop <= start:
            return np.zeros(0, self._dtype)
        numbers = range(start // CHUNK_ROWS, (stop - 1) // CHUNK_ROWS + 1)
        parts = [self._block(number) for number in numbers]
        whole = parts[0] if len(parts) == 1 else np.concatenate(parts)
        first = numbers[0] * CHUNK_ROWS
        return whole[start - first : stop - first]

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        """The whole column."""
        with open_readonly(self._path) as file:
            return np.asarray(file[self._dataset][()], dtype)

    def _block(self, number: int) -> NDArray[Any]:
        if number in self._blocks:
            self._blocks.move_to_end(number)
            return self._blocks[number]
        with open_readonly(self._path) as file:
            block: NDArray[Any] = file[self._dataset][
                number * CHUNK_ROWS : (number + 1) * CHUNK_ROWS
            ]
        self._blocks[number] = block
        if len(self._blocks) > _BLOCKS_KEPT:
            self._blocks.popitem(last=False)
        return block


class Runs(Sequence[Run]):
    """The runs of a session, each loaded when first looked at."""

    def __init__(self, runs: Sequence[Run | StoredRun] = ()) -> None:
        """Runs in memory or in a file, by number."""
        self._held = list(runs)
        self._loaded: dict[int, Run] = {}
        self._serials = list(range(len(self._held)))
        self._next_serial = len(self._held)

    @property
    def serials(self) -> tuple[int, ...]:
        """A number for each run that no other has had since the session was opened.

        A run's own number is given again once the last run is dropped.
        """
        return tuple(self._serials)

    def __len__(self) -> int:
        """How many there are."""
        return len(self._held)

    @overload
    def __getitem__(self, number: int) -> Run: ...

    @overload
    def __getitem__(self, number: slice) -> Sequence[Run]: ...

    def __getitem__(self, number: int | slice) -> Run | Sequence[Run]:
        """A run by its number."""
        if isinstance(number, slice):
            return [self[at] for at in range(len(self))[number]]
        place = range(len(self))[number]
        held = self._held[place]
        if isinstance(held, Run):
            return held
        if place not in self._loaded:
            self._loaded[place] = held.load()
        return self._loaded[place]

    def __iter__(self) -> Iterator[Run]:
        """All runs in order."""
        return (self[number] for number in range(len(self)))

    def add(self, run: Run) -> int:
        """Add a run, which was made just now where it does not say so itself; gives its number."""
        self._held.append(run if run.made else replace(run, made=now()))
        self._serials.append(self._next_serial)
        self._next_serial += 1
        return len(self._held) - 1

    def drop(self, number: int, adopted: int | None, *, saving: bool) -> None:
        """Forget a run.

        Raises EditError where it is not the last one, whose number nobody else would get, where the
        corrected tracks began as it, or where a file is being written that holds it.
        """
        if number != len(self._held) - 1:
            raise EditError(
                "run {number} is not the last one: later runs would be renumbered", number=number
            )
        if number == adopted:
            raise EditError(
                "run {number}: the corrected tracks began as it; it stays", number=number
            )
        if saving:
            raise EditError(
                "run {number} is being saved; delete it when that is done", number=number
            )
        del self._held[number], self._serials[number]
        self._loaded.pop(number, None)

    def detections_input_of(self, number: int) -> tuple[DetectionsInput, ...]:
        """The detections of another program that a run was given; it need not be loaded."""
        held = self._loaded.get(number, self._held[number])
        return held.detections_input if isinstance(held, Run) else held.detections_input()

    def tracker_of(self, number: int) -> str:
        """The name of a run's tracker; quick, the run need not be loaded."""
        held = self._loaded.get(number, self._held[number])
        return held.tracker if isinstance(held, Run) else held.tracker()

    def held(self) -> tuple[Run | StoredRun, ...]:
        """The runs as they are held, without loading any."""
        return tuple(self._held)

    def in_memory(self, number: int | None) -> Run | None:
        """A run where nothing need be read for it; None else, and for none."""
        if number is None:
            return None
        held = self._held[number]
        return held if isinstance(held, Run) else self._loaded.get(number)

    def note_stored_in(self, path: Path, count: int) -> None:
        """Note that the first so many now stand in a file; what is loaded stays loaded."""
        for number in range(count):
            held = self._held[number]
            if isinstance(held, Run):
                self._loaded[number] = held
            elif held.path != path:
                self._loaded.pop(number, None)
            self._held[number] = StoredRun(path, number)


def copy_group(path: Path, name: str, image: ImageFile, target: h5py.Group) -> None:
    """Copy all of a group; long columns go piece by piece, the rest the library copies.

    Raises SessionError where the file that is read is damaged, OSError where the disk of the new
    one refuses: what is read and what is written fail apart from each other.
    """
    long = []
    with open_readonly(path) as file:
        source = file[name]
        _copy_attributes(source, target)
        for key, node in source.items():
            if isinstance(node, h5py.Group):
                target.create_group(key)
            elif _is_long(node):
                long.append(key)
            else:
                file.copy(node, target, key)
        columns = {key: _alike(source[key], target, key) for key in long}
        groups = [key for key, node in source.items() if isinstance(node, h5py.Group)]
    for key, column in columns.items():
        for start, piece in _pieces(path, f"{name}/{key}"):
            image.put(column, start, piece)
    for key in groups:
        copy_group(path, f"{name}/{key}", image, target[key])


def _is_long(dataset: h5py.Dataset) -> bool:
    """Whether all pieces of a column are there to be copied, and it is worth while."""
    if dataset.chunks is None or dataset.ndim != 1:
        return False
    pieces = -(-len(dataset) // dataset.chunks[0])
    stored: int = dataset.id.get_storage_size()
    return stored > _SMALL_BYTES and dataset.id.get_num_chunks() == pieces


def _alike(source: h5py.Dataset, target: h5py.Group, name: str) -> h5py.Dataset:
    """An empty column of the same type, length and packing."""
    space, how = source.id.get_space(), source.id.get_create_plist()
    made = h5py.h5d.create(target.id, name.encode(), source.id.get_type(), space, how)
    column = h5py.Dataset(made)
    _copy_attributes(source, column)
    return column


def _copy_attributes(source: h5py.HLObject, target: h5py.HLObject) -> None:
    for name, value in source.attrs.items():
        target.attrs.create(name, value, dtype=source.attrs.get_id(name).dtype)


def _pieces(path: Path, name: str) -> Iterator[tuple[int, bytes]]:
    with open_readonly(path) as file:
        dataset = file[name]
        for start in range(0, len(dataset), dataset.chunks[0]):
            _, piece = dataset.id.read_direct_chunk((start,))
            yield start, piece
