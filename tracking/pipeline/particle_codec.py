"""Columns of particles in 16 bits a value, as they are put aside while a tracker works."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from tracking.pipeline.spool import Spool

_HALF_RANGE = 1 << 15
"""Of 16 bits with a sign."""
_WHOLE_NUMBERS = 1 << 24
"""Up to here float32 knows every whole number."""


@dataclass(frozen=True, slots=True)
class Block:
    """A stretch of a column in a spool.

    Attributes:
        place: where it begins. size: bytes. rows: of the column.
        kind: "steps", "halves", "runs" or "plain".
        origin: of steps: what is added to them.
    """

    place: int
    size: int
    rows: int
    kind: str
    origin: float = 0.0


class Coding(Protocol):
    """How a column is put aside."""

    def put(self, spool: Spool, values: NDArray[Any]) -> Block:
        """A stretch of rows into the spool."""

    def get(self, spool: Spool, block: Block, rows: slice, dtype: np.dtype[Any]) -> NDArray[Any]:
        """Some of a stretch's rows, start and stop given."""


@dataclass(frozen=True, slots=True)
class Plain:
    """Values as they are."""

    def put(self, spool: Spool, values: NDArray[Any]) -> Block:
        """See `Coding`."""
        return _plain(spool, values)

    def get(self, spool: Spool, block: Block, rows: slice, dtype: np.dtype[Any]) -> NDArray[Any]:
        """See `Coding`."""
        return _read(spool, block, rows, dtype)


@dataclass(frozen=True, slots=True)
class Runs:
    """Whole numbers of which many that follow each other are equal."""

    def put(self, spool: Spool, values: NDArray[Any]) -> Block:
        """Each number once, with where it ends."""
        ends = np.append(np.flatnonzero(values[1:] != values[:-1]) + 1, len(values))
        data = np.concatenate((values[ends - 1].astype(np.int32), ends.astype(np.int32)))
        return Block(spool.append(data.tobytes()), data.nbytes, len(values), "runs")

    def get(self, spool: Spool, block: Block, rows: slice, dtype: np.dtype[Any]) -> NDArray[Any]:
        """See `Coding`."""
        data = np.frombuffer(spool.read(block.place, block.size), np.int32)
        values, ends = np.split(data, 2)
        first, last = np.searchsorted(ends, (rows.start, rows.stop - 1), side="right")
        bounds = np.clip(ends[first : last + 1], rows.start, rows.stop)
        counts = np.diff(bounds, prepend=rows.start)
        return np.repeat(values[first : last + 1].astype(dtype), counts)


@dataclass(frozen=True, slots=True)
class Steps:
    """Numbers in steps of a power of two, as 16-bit distances from a middle.

    A stretch that reaches farther is put aside plainly, rounded alike.

    Attributes:
        size: of a step.
    """

    size: float

    def put(self, spool: Spool, values: NDArray[Any]) -> Block:
        """See `Coding`."""
        # One array throughout: many frames' particles at once are too large to be had anew.
        steps = values * np.float32(1 / self.size)
        np.rint(steps, out=steps)
        steps += np.float32(0)  # no 0 is negative
        low, high = float(steps.min()), float(steps.max())
        origin = np.floor((low + high) / 2)
        near = high - low < 2 * _HALF_RANGE - 1 and max(-low, high) < _WHOLE_NUMBERS
        if not near:  # also where something is NaN
            return _plain(spool, steps * np.float32(self.size))
        steps -= np.float32(origin)
        data = steps.astype(np.int16).tobytes()
        return Block(spool.append(data), len(data), len(values), "steps", origin)

    def get(self, spool: Spool, block: Block, rows: slice, dtype: np.dtype[Any]) -> NDArray[Any]:
        """See `Coding`."""
        if block.kind == "plain":
            return _read(spool, block, rows, dtype)
        steps = _read(spool, block, rows, np.dtype(np.int16)).astype(dtype)
        steps += dtype.type(block.origin)
        steps *= dtype.type(self.size)
        return steps


@dataclass(frozen=True, slots=True)
class Shares:
    """Weights from 0 to 1 in half precision: 11 significant bits, steps of 6e-8 below 6e-5."""

    def put(self, spool: Spool, values: NDArray[Any]) -> Block:
        """See `Coding`."""
        data = values.astype(np.float16).tobytes()
        return Block(spool.append(data), len(data), len(values), "halves")

    def get(self, spool: Spool, block: Block, rows: slice, dtype: np.dtype[Any]) -> NDArray[Any]:
        """See `Coding`."""
        return _read(spool, block, rows, np.dtype(np.float16)).astype(dtype)


_FLOOR = Steps(1 / 1024)
"""m: an error of 0.49 mm at most."""
_PICTURE = Steps(1 / 8)
"""px: of which rectangles' centres are made."""

CODINGS: Mapping[str, Mapping[str, Coding]] = MappingProxyType(
    {
        "particles": {"track": Runs(), "x": _FLOOR, "y": _FLOOR, "weight": Shares()},
        "part_particles": {
            "track": Runs(),
            "part": Runs(),
            "u": _PICTURE,
            "v": _PICTURE,
            "weight": Shares(),
        },
        "tracklets": {"track": Runs()},
    }
)
"""How columns of a run's tables are put aside; those that are not named, as they are."""


def _plain(spool: Spool, values: NDArray[Any]) -> Block:
    data = values.tobytes()
    return Block(spool.append(data), len(data), len(values), "plain")


def _read(spool: Spool, block: Block, rows: slice, dtype: np.dtype[Any]) -> NDArray[Any]:
    width = dtype.itemsize
    size = (rows.stop - rows.start) * width
    return np.frombuffer(spool.read(block.place + rows.start * width, size), dtype)
