"""Look session files over before their data is touched: `python inspection.py FILE...`.

A file from elsewhere can be made to crash the HDF5 library, to name other files, or to fill the
memory. So this runs as a program of its own, with limits, and reads no column of numbers. It
prints one line of JSON a file: {"version": [major, minor]} or {"refused": why}.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import Path

import h5py

from tracking.untrusted import (
    Kind,
    Refused,
    bare_packages,
    checked_file,
    go_on,
    say_verdicts,
)

if __name__ == "__main__":
    bare_packages("session", "editing", "failure")

from tracking.session.layout import (
    FORMAT,
    RUN_TABLES,
    SAMPLES,
    TABLES,
    TEXT,
    TRAJECTORY_TYPE,
    VERSION,
    Table,
)

_MOST_BYTES = 16 << 30
"""Of all tables together, unpacked; particles are never read whole and do not count."""
_LONGEST_TEXT = 1 << 20
"""Characters of a manifest, or of calibration files together: those read have a quarter of it."""
_KIND = Kind(
    name="session",
    format=FORMAT,
    version=VERSION,
    most_bytes=_MOST_BYTES,
    compound=TRAJECTORY_TYPE,
    free=re.compile(
        "|".join(
            rf"runs/\d+/{name}/({'|'.join(table.columns)})"
            for name, table in RUN_TABLES.items()
            if table.by_frame
        )
    ).fullmatch,
)


def inspect(path: Path) -> tuple[int, int]:
    """The file's format version. Raises Refused where it is not a session safe to read."""
    with checked_file(path, _KIND) as (file, version, datasets):
        for where, table in _tables(file, datasets):
            _check_table(datasets, where, table)
            if table.by_frame and f"{where}/start" not in datasets:
                _, run, name = where.split("/")
                raise Refused(
                    "does not say which {name} of run {run} belong to which frame",
                    name=name,
                    run=run,
                )
    return version


def _tables(file: h5py.File, datasets: Mapping[str, h5py.Dataset]) -> Iterator[tuple[str, Table]]:
    """Where each table stands that the file must have, or has; what is no table is checked."""
    yield from _those_of(file, "", TABLES)
    if any(path.startswith("samples/") for path in datasets):
        yield "samples", SAMPLES
    for name in ("recording/manifest", "recording/calibration"):
        if name not in datasets or datasets[name].ndim or datasets[name].dtype.kind != "O":
            raise Refused("has no text at {name}", name=name)
        go_on()
        if len(datasets[name].asstr(errors="replace")[()]) > _LONGEST_TEXT:
            raise Refused("has more text at {name} than any recording", name=name)
    go_on()
    runs = file.get("runs")
    if not isinstance(runs, h5py.Group) or set(runs) != {str(at) for at in range(len(runs))}:
        raise Refused("does not number its runs from 0 on")
    for number in runs:
        yield from _those_of(runs[number], f"runs/{number}/", RUN_TABLES)


def _those_of(
    group: h5py.Group, path: str, tables: Mapping[str, Table]
) -> Iterator[tuple[str, Table]]:
    for name, table in tables.items():
        if name in group or not table.is_later:
            yield f"{path}{name}", table


def _check_table(datasets: Mapping[str, h5py.Dataset], where: str, table: Table) -> None:
    held = {name: datasets.get(f"{where}/{name}") for name in table.columns}
    lengths = set()
    for name, dtype in table.columns_in({name for name in held if held[name] is not None}).items():
        dataset = held[name]
        if dataset is None:
            raise Refused("has no column {name} in {where}", name=name, where=where)
        if dataset.ndim != 1 or dataset.dtype != dtype:
            raise Refused(
                "has {dtype} in column {name} of {where}, not {dtype2}",
                dtype=dataset.dtype,
                name=name,
                where=where,
                dtype2=dtype,
            )
        lengths.add(len(dataset))
        if dtype == TEXT:
            go_on(len(dataset))
            dataset.asstr(errors="replace")[()]  # text lies in a heap: reading it is the check
    if len(lengths) > 1:
        raise Refused("has columns of different lengths in {where}", where=where)


if __name__ == "__main__":
    say_verdicts(inspect)
