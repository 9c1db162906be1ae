"""How fast tracks are written into files of other tools and read from them, and in what memory."""

from __future__ import annotations

import resource
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tests.benchmarks.command import tell
from tracking.formats import FORMATS, Exported, Filmed, no_progress
from tracking.tracks import CORRECTED_COLUMNS

ROWS, LONG_ROWS = 1_000_000, 10_000_000
PEOPLE, SEED = 20, 3
_TEXTS = ("mot", "mot16", "kitti", "csv")
_POOL = 1 << 20


@dataclass(frozen=True, slots=True)
class Repeated:
    """A column as long as one likes over a pool of values: it takes no memory of its own."""

    name: str
    rows: int
    pool: NDArray[Any]

    def __len__(self) -> int:
        """The number of rows."""
        return self.rows

    def __getitem__(self, rows: slice) -> NDArray[Any]:
        """A stretch of rows."""
        number = np.arange(rows.start, rows.stop)
        if self.name == "frame":
            return (number // PEOPLE).astype(np.int32)
        if self.name == "track":
            return (number % PEOPLE + 1).astype(np.int32)
        found: NDArray[Any] = self.pool[number % _POOL]
        return found


def measure() -> dict[str, float]:
    """Rows a second of a million rows whose numbers need all their digits, and MB of memory.

    `NAME_written_rows_s`, `NAME_read_rows_s`: rows a second. `long_peak_mb`: how much more memory
    the process took at most while ten million rows were written as MOT text, `long_written_rows_s`
    a second. The disk takes part in all of it.
    """
    with tempfile.TemporaryDirectory(prefix="trackwright-benchmark-") as folder:
        path, exported = Path(folder) / "t", crowd(ROWS)
        before = _peak_mb()
        figures = {"long_written_rows_s": _written("mot", path, crowd(LONG_ROWS))}
        figures["long_peak_mb"] = _peak_mb() - before
        for name in _TEXTS:
            tell(f"  {name}")
            figures |= _rates(name, path, exported)
            path.unlink()
    return figures


def crowd(rows: int) -> Exported:
    """Tracks with random numbers in all columns."""
    random = np.random.default_rng(SEED)
    columns = {}
    for name, dtype in CORRECTED_COLUMNS.items():
        pool = np.zeros(_POOL, dtype)
        if dtype.kind == "f":
            pool = random.uniform(0, 1 if dtype == np.float32 else 1900, _POOL).astype(dtype)
        columns[name] = Repeated(name, rows, pool)
    return Exported(columns, frames=rows // PEOPLE, size_px=(1920, 1080))


def _rates(name: str, path: Path, exported: Exported) -> dict[str, float]:
    read = FORMATS[name].read
    written = _written(name, path, exported)
    began = time.perf_counter()
    found = None if read is None else read(path, Filmed())
    if found is None or len(found.columns["frame"]) != len(exported):
        raise ValueError(f"{name}: what was written is not read back")
    rate = len(exported) / (time.perf_counter() - began)
    return {f"{name}_written_rows_s": written, f"{name}_read_rows_s": rate}


def _written(name: str, path: Path, exported: Exported) -> float:
    write = FORMATS[name].write
    began = time.perf_counter()
    if write is None or write(path, exported, no_progress) != (path,):
        raise ValueError(f"{name}: is not written")
    return len(exported) / (time.perf_counter() - began)


def _peak_mb() -> float:
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
