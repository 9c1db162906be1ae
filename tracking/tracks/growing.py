"""Columns of ten million rows that are lengthened and put in order without being copied."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray


class Growing:
    """An array that is lengthened at its end again and again, seldom copied.

    One owner: arrays it gave earlier stay as they are, since only what is behind them is written.
    """

    def __init__(self, values: NDArray[Any]) -> None:
        """Begin with an array, which is not written to."""
        self._buffer = values
        self._used = len(values)

    def with_more(self, more: NDArray[Any]) -> NDArray[Any]:
        """All values so far and these behind them: a view that is written through."""
        needed = self._used + len(more)
        if needed > len(self._buffer):
            larger = np.empty(needed + needed // 8 + 1024, self._buffer.dtype)
            larger[: self._used] = self._buffer[: self._used]
            self._buffer = larger
        self._buffer[self._used : needed] = more
        self._used = needed
        return self._buffer[:needed]


@dataclass(frozen=True, slots=True)
class ColumnInOrder:
    """A column whose rows are put in order as they are asked for, by slices.

    Attributes:
        read: gives the values of slots. order: the slots of all rows.
    """

    read: Callable[[NDArray[np.int64]], NDArray[Any]]
    order: NDArray[np.int64]

    def __len__(self) -> int:
        """The number of rows."""
        return len(self.order)

    def __getitem__(self, rows: slice) -> NDArray[Any]:
        """A stretch of rows."""
        return self.read(self.order[rows])
