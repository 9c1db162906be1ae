"""Look session files over before their data is touched: `python inspection.py FILE...`.

A file from elsewhere can be made to crash the HDF5 library, to name other files, or to fill the
memory. So this runs as a program of its own, with limits, and reads no column of numbers. It
prints one line of JSON a file: {"version": [major, minor]} or {"refused": why}.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import h5py
import numpy as np

from tracking.untrusted import (
    Kind,
    Refused,
    Walk,
    bare_packages,
    check_signature,
    go_on,
    say_verdicts,
    verdict_by,
    version_of,
)

if __name__ == "__main__":
    bare_packages("session", "editing", "failure")

from tracking.session.layout import (
    FORMAT,
    LATER_COLUMNS,
    LATER_RUN_COLUMNS,
    LATER_RUN_TABLES,
    LATER_TABLES,
    PARTICLE_TABLES,
    RUN_TABLES,
    SAMPLE_TABLE,
    TABLES,
    TEXT,
    TRAJECTORY_TYPE,
    VERSION,
)

_MOST_BYTES = 16 << 30
"""Of all tables together, unpacked; particles are never read whole and do not count."""
_LONGEST_TEXT = 1 << 20
"""Characters of a manifest, or of calibration files together: those read have a quarter of it."""
_PARTICLE_COLUMN = re.compile(
    "|".join(rf"runs/\d+/{table}/({'|'.join(RUN_TABLES[table])})" for table in PARTICLE_TABLES)
)


def inspect(path: Path) -> tuple[int, int]:
    """The file's format version. Raises Refused where it is not a session safe to read."""
    kind = Kind(
        name="session",
        format=FORMAT,
        version=VERSION,
        most_bytes=_MOST_BYTES,
        compound=TRAJECTORY_TYPE,
        free=_PARTICLE_COLUMN.fullmatch,
    )
    check_signature(path, kind)
    with h5py.File(path, "r", locking=False) as file:
        version = version_of(file, kind)
        datasets = Walk(path.stat().st_size, kind).datasets_of(file)
        _check_tables(file, datasets)
    return version


def _check_tables(file: h5py.File, datasets: Mapping[str, h5py.Dataset]) -> None:
    for name, types in TABLES.items():
        if name in LATER_TABLES and name not in file:
            continue
        _check_table(datasets, name, _expected(datasets, name, types, LATER_COLUMNS.get(name, ())))
    if any(path.startswith("samples/") for path in datasets):
        _check_table(datasets, "samples", SAMPLE_TABLE)
    for name in ("recording/manifest", "recording/calibration"):
        if name not in datasets or datasets[name].ndim or datasets[name].dtype.kind != "O":
            raise Refused(f"has no text at {name}")
        go_on()
        if len(datasets[name].asstr(errors="replace")[()]) > _LONGEST_TEXT:
            raise Refused(f"has more text at {name} than any recording")
    go_on()
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
            go_on(len(dataset))
            dataset.asstr(errors="replace")[()]  # text lies in a heap: reading it is the check
    if len(lengths) > 1:
        raise Refused(f"has columns of different lengths in {table}")


def verdict_on(path: Path) -> dict[str, Any]:
    """{"version": [major, minor]}, or {"refused": why} in words that follow the file's name."""
    return verdict_by(inspect, path)


if __name__ == "__main__":
    say_verdicts(inspect)
