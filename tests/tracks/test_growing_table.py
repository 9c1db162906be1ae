"""A table that grows row by row is the table made of all its rows."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from tracking.tracks import CORRECTED_COLUMNS, TRACK_COLUMNS, Source, TrackTable, empty

_PLACE = st.tuples(st.integers(0, 30), st.integers(1, 6))
_NO_MOVES = np.zeros((0, 4), np.int64)


def rows_at(places: list[tuple[int, int]]) -> dict[str, np.ndarray]:
    rows = {name: np.zeros(len(places), dtype) for name, dtype in TRACK_COLUMNS.items()}
    for at, (frame, track) in enumerate(sorted(places)):
        rows["frame"][at], rows["track"][at] = frame, track
        rows["left"][at] = 100 * frame + track
    return {**rows, "source": np.full(len(places), Source.PERSON, np.uint8)}


def add(table: TrackTable, places: list[tuple[int, int]]) -> None:
    table.rewrite(empty(CORRECTED_COLUMNS), _NO_MOVES, rows_at(places))


def same(table: TrackTable, places: set[tuple[int, int]]) -> None:
    wanted = TrackTable(rows_at(sorted(places)))
    for name, column in wanted.columns().items():
        assert table.columns()[name].tobytes() == column.tobytes()
    frames = {frame for frame, _ in places}
    for frame in frames:
        assert table.of_frame(frame)["left"].tolist() == wanted.of_frame(frame)["left"].tolist()


@given(st.sets(_PLACE, max_size=20), st.lists(st.sets(_PLACE, min_size=1), max_size=8))
def test_rows_added_in_any_order_stand_where_they_belong(first, further):
    table, known = TrackTable(rows_at(sorted(first))), set(first)
    for places in further:
        new = places - known
        add(table, sorted(new))
        known |= new
    same(table, known)


@given(st.sets(_PLACE, min_size=2, max_size=20))
def test_a_table_and_its_snapshot_grow_apart(places):
    known = sorted(places)
    table = TrackTable(rows_at(known[:1]))
    add(table, known[1:2])
    copy = table.snapshot()
    for at, place in enumerate(known[2:]):
        add(table if at % 2 else copy, [place])
    same(table, {*known[:2], *known[3::2]})
    same(copy, {*known[:2], *known[2::2]})


@given(st.sets(_PLACE, min_size=2, max_size=20))
def test_columns_read_by_slices_are_the_sorted_ones(places):
    known = sorted(places)
    table = TrackTable(rows_at(known[1::2]))
    add(table, known[::2])
    sliced = table.in_order()
    for name, column in table.columns().items():
        assert len(sliced[name]) == len(column)
        parts = [sliced[name][start : start + 3] for start in range(0, len(column), 3)]
        assert np.concatenate(parts).tobytes() == column.tobytes()


@given(st.sets(_PLACE, min_size=1, max_size=20), st.sets(st.integers(1, 6)))
def test_columns_by_track_stand_by_track_then_frame(places, asked):
    known = sorted(places)
    table = TrackTable(rows_at(known[1::2]))
    add(table, known[::2])
    rows = table.by_track(("track", "frame"), asked)
    wanted = sorted((track, frame) for frame, track in known if track in asked)
    assert list(zip(rows["track"].tolist(), rows["frame"].tolist(), strict=True)) == wanted
