"""Look files of samples over before their data is touched: `python samples_inspection.py FILE...`.

See `tracking.untrusted.program` for why this is a program of its own, and what it prints.
"""

from __future__ import annotations

from collections.abc import Mapping
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
    bare_packages("formats", "failure")

from tracking.formats.samples_layout import (
    HDF5_FORMAT,
    MOST_BYTES,
    MOST_TEXT,
    NUMBERS,
    SHARED,
    TEXTS,
    VERSION,
    WIDTHS,
)

_KIND = Kind("samples export", HDF5_FORMAT, VERSION, MOST_BYTES, dimensions=2)
_BLOCK = 10_000


def inspect(path: Path) -> tuple[int, int]:
    """The file's format version. Raises Refused where it holds no samples safe to read."""
    with checked_file(path, _KIND) as (_, version, datasets):
        _check_columns(datasets)
        _check_text(datasets)
    return version


def _check_columns(datasets: Mapping[str, h5py.Dataset]) -> None:
    """All there, of one length and of the right kind."""
    features = datasets.get("features")
    if features is None or features.ndim != 2 or features.shape[1] not in WIDTHS:
        raise Refused(
            "has no table of {few} or {count} features a sample; {choose}",
            few=WIDTHS[0],
            count=WIDTHS[1],
            choose=_KIND.choose,
        )
    expected = {"features": "f", **dict.fromkeys(NUMBERS, "iu"), **dict.fromkeys(TEXTS, "O")}
    expected |= {name: "iuf" for name in SHARED if name in datasets}
    for name, kinds in expected.items():
        column = datasets.get(name)
        if column is None:
            raise Refused("has no column {name}; {choose}", name=name, choose=_KIND.choose)
        if column.dtype.kind not in kinds or (name != "features" and column.ndim != 1):
            raise Refused(
                "has {dtype} in {ndim} dimensions at {name}",
                dtype=column.dtype,
                ndim=column.ndim,
                name=name,
            )
        if len(column) != len(features):
            raise Refused(
                "has {count} rows of {name} and {features} of features",
                count=len(column),
                name=name,
                features=len(features),
            )


def _check_text(datasets: Mapping[str, h5py.Dataset]) -> None:
    """Rows can share one long text, so that a small file holds any amount of it."""
    total = 0
    for name in TEXTS:
        for start in range(0, len(datasets[name]), _BLOCK):
            go_on(_BLOCK)
            total += sum(map(len, datasets[name].asstr()[start : start + _BLOCK]))
            if total > MOST_TEXT:
                raise Refused("holds more text than any {name}", name=_KIND.name)


if __name__ == "__main__":
    say_verdicts(inspect)
