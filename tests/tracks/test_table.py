"""The corrected table: sorted, checked at the door, indexed per frame and per track."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from tracking.errors import EditError
from tracking.tracks import (
    CORRECTED_COLUMNS,
    TRACK_COLUMNS,
    Source,
    TrackTable,
    check_known,
    empty,
)


def columns_of(*places: tuple[int, int]) -> dict[str, np.ndarray]:
    """Rows at (frame, track); the other columns tell rows apart."""
    rows = {name: np.zeros(len(places), dtype) for name, dtype in TRACK_COLUMNS.items()}
    for at, (frame, track) in enumerate(places):
        rows["frame"][at], rows["track"][at] = frame, track
        rows["left"][at], rows["x"][at] = 100 * frame + track, np.nan if at % 2 else at
    return rows


def rows_at(*places: tuple[int, int]) -> dict[str, np.ndarray]:
    rows = columns_of(*places)
    return {**rows, "source": np.full(len(places), Source.PERSON, np.uint8)}


@pytest.fixture
def table() -> TrackTable:
    return TrackTable(columns_of((0, 1), (0, 4), (1, 1), (3, 1), (3, 2), (3, 4)))


def moves(*rows: tuple[int, int, int, int]) -> np.ndarray:
    return np.array(rows, np.int64).reshape(-1, 4)


def places(columns: dict[str, np.ndarray]) -> list[tuple[int, int]]:
    return list(zip(columns["frame"].tolist(), columns["track"].tolist(), strict=True))


def test_a_run_s_rows_come_from_the_tracker(table: TrackTable) -> None:
    assert table.columns()["source"].tolist() == [Source.TRACKER] * 6


def test_rows_are_found_by_frame_and_by_track(table: TrackTable) -> None:
    assert places(table.of_frame(3)) == [(3, 1), (3, 2), (3, 4)]
    assert places(table.of_frame(2)) == []
    assert places(table.of_track(4)) == [(0, 4), (3, 4)]
    assert places(table.of_track(1, 1, 3)) == [(1, 1)]
    assert table.frames_of_track(9).tolist() == []


def test_several_tracks_are_read_one_after_the_other(table: TrackTable) -> None:
    table.rewrite(rows_at(), moves(), rows_at((2, 4)))
    assert places(table.of_tracks([4, 9, 1], 1, 4)) == [(2, 4), (3, 4), (1, 1), (3, 1)]
    assert places(table.of_tracks([], 0, 9)) == []
    assert places(table.of_tracks([1], -5, 2**40)) == places(table.of_track(1))


def test_the_table_tells_its_size_and_ranges(table: TrackTable) -> None:
    assert len(table) == 6
    assert table.track_ids == (1, 2, 4)
    assert table.frame_range(1) == (0, 4)
    assert table.frame_range(9) == (0, 0)
    assert len(table.frames_of_track(4)) == 2
    assert table.frame_stop == 4
    assert table.activity(5).tolist() == [2, 1, 0, 3, 0]
    assert 4 in table
    assert 3 not in table


def test_an_empty_table_is_a_table() -> None:
    table = TrackTable()
    assert (len(table), table.track_ids, table.frame_stop) == (0, (), 0)
    assert places(table.of_frame(0)) == []
    assert table.activity(2).tolist() == [0, 0]


def test_a_handed_over_stretch_is_found_under_its_new_track(table: TrackTable) -> None:
    table.rewrite(empty(CORRECTED_COLUMNS), moves((1, 4, 1, 4), (4, 1, 1, 4)), rows_at())
    assert places(table.of_track(4)) == [(0, 4), (1, 4), (3, 4)]
    assert table.of_frame(3)["left"].tolist() == [304, 302, 301]
    assert table.columns()["left"].tolist() == [1, 4, 101, 304, 302, 301]


def test_added_rows_stand_in_order_everywhere(table: TrackTable) -> None:
    table.rewrite(empty(CORRECTED_COLUMNS), moves(), rows_at((1, 7), (2, 4), (9, 1)))
    assert places(table.of_frame(1)) == [(1, 1), (1, 7)]
    assert places(table.of_track(4)) == [(0, 4), (2, 4), (3, 4)]
    assert places(table.columns()) == sorted(places(table.columns()))
    assert table.highest_track == 7
    assert table.frame_stop == 10


def test_taken_out_rows_are_gone_and_ids_stay_used(table: TrackTable) -> None:
    table.rewrite(table.of_track(4), moves(), rows_at())
    assert table.track_ids == (1, 2)
    assert places(table.of_frame(0)) == [(0, 1)]
    assert table.highest_track == 4


def test_a_long_tail_is_sorted_in(monkeypatch: pytest.MonkeyPatch, table: TrackTable) -> None:
    monkeypatch.setattr("tracking.tracks.table._SMALLEST_LONG_TAIL", 2)
    table.rewrite(table.of_track(2), moves(), rows_at((1, 5), (2, 5), (4, 5)))
    assert places(table.columns()) == [
        *((0, 1), (0, 4), (1, 1), (1, 5), (2, 5), (3, 1), (3, 4), (4, 5))
    ]
    assert places(table.of_track(5)) == [(1, 5), (2, 5), (4, 5)]
    table.rewrite(table.of_track(5), moves((1, 2, 0, 9)), rows_at())
    assert places(table.of_track(2)) == [(0, 2), (1, 2), (3, 2)]


def test_a_snapshot_stays_as_it_was(table: TrackTable) -> None:
    before = table.columns()
    snapshot = table.snapshot()
    table.rewrite(table.of_track(4), moves((1, 9, 0, 9)), rows_at((2, 2)))
    for name, column in snapshot.columns().items():
        assert column.tobytes() == before[name].tobytes()
    assert snapshot.track_ids == (1, 2, 4)


def test_columns_cannot_be_written_to(table: TrackTable) -> None:
    with pytest.raises(ValueError, match="read-only"):
        table.columns()["left"][0] = 1


@pytest.mark.parametrize(
    ("out", "handed", "put", "why"),
    [
        ((), ((1, 4, 0, 4),), (), "rows of its own|stand twice"),
        ((), ((9, 4, 0, 4),), (), "nothing to give"),
        ((), ((1, 1, 0, 4),), (), "nothing to give"),
        ((), ((1, 5, 0, 4), (1, 6, 1, 2)), (), "same row twice"),
        ((), (), ((3, 4),), "twice in frame 3"),
        ((), (), ((3, 7), (3, 7)), "stands twice"),
        (((2, 1),), (), (), "no row"),
        (((3, 1),), (), (), "not what the edit was planned on"),
    ],
)
def test_what_does_not_fit_is_refused_and_changes_nothing(
    table: TrackTable, out: tuple, handed: tuple, put: tuple, why: str
) -> None:
    before = table.columns()
    with pytest.raises(EditError, match=why):
        table.rewrite(rows_at(*out), moves(*handed), rows_at(*put))
    assert table.columns() is not before
    assert all(np.array_equal(table.columns()[name], before[name], True) for name in before)
    assert table.revision == 0


@pytest.mark.parametrize(
    ("spoil", "why"),
    [
        (lambda rows: rows.pop("left"), "column left is missing"),
        (lambda rows: rows.update(left=rows["left"][:2]), "different lengths"),
        (lambda rows: rows.update(frame=rows["frame"] + np.array([0, 0, np.nan])), "NaN"),
        (lambda rows: rows.update(frame=rows["frame"] + 0.5), "fractions"),
        (lambda rows: rows.update(frame=rows["frame"] + 2.0**40), "beyond"),
        (lambda rows: rows.update(track=rows["track"] - 1), "ids are positive"),
        (lambda rows: rows.update(frame=rows["frame"] + 2.0**31 - 2), "frames go up to"),
        (lambda rows: rows.update(frame=rows["frame"] - 1), "frames count from 0"),
        (lambda rows: rows.update(frame=rows["frame"][::-1]), "out of order"),
        (lambda rows: rows.update(track=np.array([2, 1, 1])), "out of order"),
        (lambda rows: rows.update(track=rows["track"] * 0 + 1), "twice in frame 0"),
        (lambda rows: rows.update(left=np.array(["a", "b", "c"])), "numbers are needed"),
        (lambda rows: rows.update(left=np.zeros((3, 2))), "shape"),
    ],
)
def test_what_is_no_table_is_refused_at_the_door(
    spoil: Callable[[dict[str, np.ndarray]], object], why: str
) -> None:
    rows = columns_of((0, 1), (0, 2), (1, 1))
    spoil(rows)
    with pytest.raises(EditError, match=why):
        TrackTable(rows)


def test_whole_numbers_of_another_type_are_taken() -> None:
    rows = columns_of((0, 1), (70_000, 70_000))
    table = TrackTable({**rows, "frame": rows["frame"].astype(float)})
    assert table.columns()["frame"].dtype == np.int32
    assert table.track_ids == (1, 70_000)


def test_an_unknown_track_is_named(table: TrackTable) -> None:
    check_known(table, 1, 2, 4)
    with pytest.raises(EditError, match="track 3 is not in the table"):
        check_known(table, 1, 3)
    with pytest.raises(EditError, match="no tracks"):
        check_known(TrackTable(), 1)
