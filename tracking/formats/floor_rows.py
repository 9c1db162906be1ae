"""Places on the floor alone: what the formats of pedestrian dynamics are about."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.errors import FormatError
from tracking.formats.track_writer import ROWS_AT_ONCE, Exported
from tracking.tracks import Columns

MARGIN_M = 1.0
"""How far the area that is written reaches beyond the places people were at."""


def on_floor(rows: Columns) -> Columns:
    """The rows whose place on the floor is known; others are gaps in these formats."""
    known = np.isfinite(rows["x"]) & np.isfinite(rows["y"])
    return {name: column[known] for name, column in rows.items()}


class Places:
    """How many rows have a place, and where all of them lie."""

    def __init__(self, path: Path, exported: Exported) -> None:
        """Look through the tracks; raises FormatError where nobody has a place."""
        self.count, self.last_frame = 0, -1
        self._low, self._high = np.full(2, np.inf), np.full(2, -np.inf)
        columns = {name: exported.rows[name] for name in ("frame", "x", "y")}
        for start in range(0, len(exported), ROWS_AT_ONCE):
            stop = min(start + ROWS_AT_ONCE, len(exported))
            rows = on_floor({name: column[start:stop] for name, column in columns.items()})
            if len(rows["frame"]):
                self._take(rows)
        if not self.count:
            raise FormatError(
                "{path}: nobody has a place on the floor; calibrate the camera, then track again",
                path=path,
            )

    def _take(self, rows: Columns) -> None:
        places = np.column_stack([rows["x"], rows["y"]])
        self.count += len(places)
        self.last_frame = max(self.last_frame, int(rows["frame"][-1]))
        self._low = np.minimum(self._low, places.min(axis=0))
        self._high = np.maximum(self._high, places.max(axis=0))

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """Least x and y, most x and y in metres, with `MARGIN_M` around."""
        low, high = (self._low - MARGIN_M).tolist(), (self._high + MARGIN_M).tolist()
        return low[0], low[1], high[0], high[1]

    @property
    def area(self) -> str:
        """A rectangle around all places as WKT: what other tools call the walkable area."""
        x0, y0, x1, y1 = self.bounds
        corners = ((x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0))
        return f"POLYGON (({', '.join(f'{x!r} {y!r}' for x, y in corners)}))"


def fps_of(path: Path, exported: Exported) -> float:
    """Frames a second; raises FormatError where they are not known."""
    if exported.fps is None:
        raise FormatError(
            "{path}: the format needs the frames per second, which are not known", path=path
        )
    return float(exported.fps)


def with_place(rows: dict[str, NDArray[Any]]) -> dict[str, NDArray[Any]]:
    """Rows as read; one whose place is no number is invalid, and is marked so for the check.

    NaN is what this program has for unknown, so it must not pass for a place.
    """
    lost = ~(np.isfinite(rows["x"]) & np.isfinite(rows["y"]))
    return rows | {name: np.where(lost, np.inf, rows[name]) for name in ("x", "y")}
