"""Tracks to be written into files of other tools, and what must come back from them."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal
from numpy.typing import NDArray

from tracking.formats.hdf5_tracks_inspection import inspect
from tracking.formats.read_result import Filmed, Imported, with_all_columns
from tracking.formats.track_format import TrackFormat
from tracking.formats.track_writer import Exported, no_progress
from tracking.tracks import Columns, TrackTable
from tracking.untrusted import verdict_by

BOX = ("left", "top", "width", "height")
FLOOR = ("x", "y")

_pixel = st.floats(-1e4, 1e4, allow_nan=False)
_size = st.floats(0, 1e4, allow_nan=False)
_metre = st.floats(-500, 500, allow_nan=False)
_place = st.tuples(st.integers(0, 40), st.sampled_from([1, 2, 7, 300, 2**31 - 1]))
_boxes = st.tuples(_pixel, _pixel, _size, _size)
_row = st.tuples(
    _place,
    st.one_of(_boxes, st.just((np.nan,) * 4)),
    st.one_of(st.tuples(_metre, _metre), st.just((np.nan,) * 2)),
    st.sampled_from([0, 1, 2]),
    st.sampled_from([0.0, 1.0]),
)


@st.composite
def tracks(draw: st.DrawFn) -> TrackTable:
    """Up to forty rows of up to five tracks with gaps; boxes and floor places may be unknown."""
    rows = sorted(draw(st.lists(_row, max_size=40, unique_by=lambda row: row[0])))
    return table(*(list(part) for part in zip(*rows, strict=True))) if rows else TrackTable()


def table(
    places: list[tuple[int, int]],
    boxes: list[Any] | None = None,
    floor: list[Any] | None = None,
    source: list[int] | None = None,
    visibility: list[float] | None = None,
) -> TrackTable:
    """A table of rows at (frame, track), in order."""
    count = len(places)
    known: dict[str, NDArray[Any]] = {
        "frame": np.array([place[0] for place in places]),
        "track": np.array([place[1] for place in places]),
    }
    if boxes is not None:
        known |= dict(zip(BOX, np.array(boxes, float).reshape(count, 4).T, strict=True))
    if floor is not None:
        known |= dict(zip(FLOOR, np.array(floor, float).reshape(count, 2).T, strict=True))
    if source is not None:
        known["source"] = np.array(source)
    if visibility is not None:
        known["visibility"] = np.array(visibility)
    return TrackTable(with_all_columns(known))


def through(format_: TrackFormat, path: Path, exported: Exported) -> Imported:
    """The tracks written into a file and read from it, which is told by its content."""
    assert format_.write is not None
    assert format_.read is not None
    written = format_.write(path, exported, no_progress)
    assert path in written
    assert format_.recognises(path, path.read_bytes()[: 1 << 16])
    return format_.read(path, Filmed())


def known_rows(columns: Columns, name: str) -> dict[str, NDArray[Any]]:
    """The rows in which a column is known."""
    known = np.isfinite(columns[name])
    return {name: column[known] for name, column in columns.items()}


def assert_same(found: Columns, expected: Columns, names: tuple[str, ...]) -> None:
    """The same rows, numbers within a billionth of a metre or a pixel."""
    for name in ("frame", "track"):
        assert_array_equal(found[name], expected[name])
    for name in names:
        assert_allclose(found[name], expected[name], rtol=0, atol=1e-9, err_msg=name)


def looked_over_here(_program: str, _name: str, paths: Sequence[Path]) -> list[dict[str, Any]]:
    """What the program that looks HDF5 files over says, without the time it takes to start."""
    return [verdict_by(inspect, path, "layout") for path in paths]
