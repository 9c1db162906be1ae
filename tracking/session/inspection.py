"""Look session files over before their data is touched: `python inspection.py FILE...`.

A file from elsewhere can be made to crash the HDF5 library, to name other files, or to fill the
memory. So this runs as a program of its own, with limits, and reads no column of numbers. It
prints one line of JSON a file: {"version": [major, minor]} or {"refused": why}.
"""

from __future__ import annotations

import contextlib
import json
import re
import sys
from collections.abc import Mapping
from pathlib import Path
from types import ModuleType
from typing import Any

import h5py
import numpy as np

if __name__ == "__main__":
    # This program needs a few names of two packages: loading all of them would take seconds.
    for name in ("session", "editing"):
        bare = ModuleType(f"tracking.{name}")
        bare.__path__ = [str(Path(__file__).parents[1] / name)]
        sys.modules[bare.__name__] = bare

from tracking.session.layout import (
    FORMAT,
    LATER_COLUMNS,
    LATER_RUN_COLUMNS,
    LATER_RUN_TABLES,
    LATER_TABLES,
    PARTICLE_TABLES,
    RUN_TABLES,
    TABLES,
    TEXT,
    TRAJECTORY_TYPE,
    VERSION,
)

MEMORY_BYTES = 4 << 30
SECONDS = 10
_DEEPEST = 8
_MOST_OBJECTS = 20_000
_LARGEST_CHUNK = 64 << 20
_LARGEST_ATTRIBUTE = 16 << 20
_MOST_ATTRIBUTES = 64
_MOST_BYTES = 16 << 30
"""Of all tables together, unpacked; particles are never read whole and do not count."""
_PARTICLE_COLUMN = re.compile(
    "|".join(rf"runs/\d+/{table}/({'|'.join(RUN_TABLES[table])})" for table in PARTICLE_TABLES)
)
_BEST_RATIO = 1100
"""DEFLATE packs at most 1032 bytes into one."""
_FILTERS = frozenset({h5py.h5z.FILTER_DEFLATE, h5py.h5z.FILTER_SHUFFLE})
_SIGNATURE = b"\x89HDF\r\n\x1a\n"
_CHOOSE = "choose a session that trackwright saved"


class Refused(Exception):  # noqa: N818 - a verdict, caught in this file only
    """The file is not taken; the message says why."""


def inspect(path: Path) -> tuple[int, int]:
    """The file's format version. Raises Refused where it is not a session safe to read."""
    with path.open("rb") as raw:
        start = raw.read(len(_SIGNATURE))
    if start != _SIGNATURE:
        raise Refused(f"is {'not an HDF5 file' if start else 'empty'}; {_CHOOSE}")
    with h5py.File(path, "r", locking=False) as file:
        version = _version(file)
        datasets = _Walk(path.stat().st_size).datasets_of(file)
        _check_tables(file, datasets)
    return version


def _version(file: h5py.File) -> tuple[int, int]:
    _check_attributes(file)
    if file.attrs.get("format") != FORMAT:
        raise Refused(f"is HDF5, but of another program: it is no trackwright session; {_CHOOSE}")
    said = str(file.attrs.get("format_version"))
    try:
        major, minor = (int(part) for part in said.split("."))
    except ValueError:
        raise Refused(f"names {said!r} as its format version, not like 1.0; {_CHOOSE}") from None
    if major > VERSION[0]:
        raise Refused(f"has format {said}, made by a newer trackwright; update to open it")
    if major < 1:
        raise Refused(f"has format {said}, which never was")
    return major, minor


class _Walk:
    """Goes through all objects of a file once, refusing what a session never has."""

    def __init__(self, file_bytes: int) -> None:
        self._file_bytes = file_bytes
        self._stored = self._unpacked = 0
        self._objects = 0
        self._datasets: dict[str, h5py.Dataset] = {}

    def datasets_of(self, file: h5py.File) -> dict[str, h5py.Dataset]:
        self._group(file, "", 0)
        return self._datasets

    def _group(self, group: h5py.Group, path: str, depth: int) -> None:
        if depth > _DEEPEST:
            raise Refused("has groups nested deeper than any session")
        if len(group) > _MOST_OBJECTS:
            raise Refused("holds more objects than any session")
        _check_attributes(group)
        for name in group:
            self._objects += 1
            if self._objects > _MOST_OBJECTS:
                raise Refused("holds more objects than any session")
            where = f"{path}/{name}".lstrip("/")
            if not isinstance(group.get(name, getlink=True), h5py.HardLink):
                raise Refused(f"has a link to somewhere else at {where}")
            node = group[name]
            if isinstance(node, h5py.Group):
                self._group(node, where, depth + 1)
            elif isinstance(node, h5py.Dataset):
                self._dataset(node, where)
            else:
                raise Refused(f"has something at {where} that is no table")

    def _dataset(self, dataset: h5py.Dataset, where: str) -> None:
        _check_attributes(dataset)
        _check_type(dataset, where)
        layout = dataset.id.get_create_plist()
        if dataset.is_virtual or layout.get_external_count():
            raise Refused(f"keeps {where} in other files")
        for at in range(layout.get_nfilters()):
            if layout.get_filter(at)[0] not in _FILTERS:
                raise Refused(f"packs {where} with a filter of its own")
        if dataset.chunks and np.prod(dataset.chunks) * dataset.dtype.itemsize > _LARGEST_CHUNK:
            raise Refused(f"packs {where} in pieces larger than any session's")
        stored = dataset.id.get_storage_size()
        self._stored += stored
        if self._stored > self._file_bytes:
            raise Refused("says it stores more than the file holds")
        unpacked = dataset.size * dataset.dtype.itemsize
        if unpacked > stored * _BEST_RATIO:
            raise Refused(f"says {where} has {dataset.size} rows, which {stored} bytes cannot hold")
        self._unpacked += 0 if _PARTICLE_COLUMN.fullmatch(where) else unpacked
        if self._unpacked > _MOST_BYTES:
            raise Refused("holds more rows than fit into memory")
        self._datasets[where] = dataset


def _check_attributes(node: h5py.Group | h5py.Dataset) -> None:
    if len(node.attrs) > _MOST_ATTRIBUTES:
        raise Refused("has more attributes than any session")
    for name in node.attrs:
        attribute = node.attrs.get_id(name)
        if attribute.get_storage_size() > _LARGEST_ATTRIBUTE or attribute.dtype.kind not in "iufbO":
            raise Refused(f"has an attribute {name!r} like no session's")
        if attribute.dtype.kind == "O" and h5py.check_string_dtype(attribute.dtype) is None:
            raise Refused(f"has an attribute {name!r} like no session's")


def _check_type(dataset: h5py.Dataset, where: str) -> None:
    dtype = dataset.dtype
    if dtype.kind == "O":
        if h5py.check_string_dtype(dtype) is None:
            raise Refused(f"keeps references or lists in {where}")
    elif dtype.kind not in "iufb" and dtype != TRAJECTORY_TYPE:
        raise Refused(f"keeps {dtype} in {where}; numbers or text are expected")
    if dataset.ndim > 1:
        raise Refused(f"has a table of {dataset.ndim} dimensions at {where}")


def _check_tables(file: h5py.File, datasets: Mapping[str, h5py.Dataset]) -> None:
    for name, types in TABLES.items():
        if name in LATER_TABLES and name not in file:
            continue
        _check_table(datasets, name, _expected(datasets, name, types, LATER_COLUMNS.get(name, ())))
    for name in ("recording/manifest", "recording/calibration"):
        if name not in datasets or datasets[name].ndim or datasets[name].dtype.kind != "O":
            raise Refused(f"has no text at {name}")
        datasets[name].asstr(errors="replace")[()]
    runs = file.get("runs")
    if not isinstance(runs, h5py.Group) or set(runs) != {str(at) for at in range(len(runs))}:
        raise Refused("does not number its runs from 0 on")
    for number in runs:
        for name, types in RUN_TABLES.items():
            if name in LATER_RUN_TABLES and name not in runs[number]:
                continue
            table, later = f"runs/{number}/{name}", LATER_RUN_COLUMNS.get(name, ())
            _check_table(datasets, table, _expected(datasets, table, types, later))
            if name in PARTICLE_TABLES and f"{table}/start" not in datasets:
                raise Refused(f"does not say which {name} of run {number} belong to which frame")


def _expected(
    datasets: Mapping[str, h5py.Dataset],
    table: str,
    types: Mapping[str, np.dtype[Any]],
    later: tuple[frozenset[str], ...],
) -> Mapping[str, np.dtype[Any]]:
    """The columns a table must have: of those that came together later all or none."""
    missing = {
        column
        for together in later
        if not any(f"{table}/{name}" in datasets for name in together)
        for column in together
    }
    return {column: dtype for column, dtype in types.items() if column not in missing}


def _check_table(
    datasets: Mapping[str, h5py.Dataset], table: str, types: Mapping[str, np.dtype[Any]]
) -> None:
    lengths = set()
    for name, dtype in types.items():
        dataset = datasets.get(f"{table}/{name}")
        if dataset is None:
            raise Refused(f"has no column {name} in {table}")
        if dataset.ndim != 1 or dataset.dtype != dtype:
            raise Refused(f"has {dataset.dtype} in column {name} of {table}, not {dtype}")
        lengths.add(len(dataset))
        if dtype == TEXT:
            dataset.asstr(errors="replace")[()]  # text lies in a heap: reading it is the check
    if len(lengths) > 1:
        raise Refused(f"has columns of different lengths in {table}")


def _limit() -> None:
    """Where the system knows limits: a file that makes reading run away ends this program only."""
    try:
        import resource
    except ImportError:  # Windows
        return
    for kind, most in ((resource.RLIMIT_AS, MEMORY_BYTES), (resource.RLIMIT_CPU, SECONDS)):
        _, hard = resource.getrlimit(kind)
        limit = most if hard == resource.RLIM_INFINITY else min(most, hard)
        with contextlib.suppress(OSError, ValueError):  # macOS knows RLIMIT_AS but may refuse it
            resource.setrlimit(kind, (limit, hard))


def main() -> None:
    """Print the verdict on each file named on the command line, as soon as it is found."""
    _limit()
    for name in sys.argv[1:]:
        print(json.dumps(verdict_on(Path(name))), flush=True)


def verdict_on(path: Path) -> dict[str, Any]:
    """{"version": [major, minor]}, or {"refused": why} in words that follow the file's name."""
    try:
        return {"version": inspect(path)}
    except Refused as why:
        return {"refused": f" {why}"}
    except Exception as why:  # whatever the library says of a damaged file
        reason = " ".join(str(why).split())
        return {"refused": f" is damaged or cut short ({reason})"}


if __name__ == "__main__":
    main()
