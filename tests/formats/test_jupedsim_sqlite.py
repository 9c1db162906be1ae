"""JuPedSim's SQLite files in and out."""

from __future__ import annotations

import sqlite3
from contextlib import closing
from pathlib import Path
from typing import Any

import numpy as np
import pedpy
import pytest
from hypothesis import HealthCheck, given, settings
from made_tracks import FLOOR, assert_same, known_rows, table, through, tracks

from tracking.errors import CancelledError, FormatError
from tracking.formats.jupedsim import JUPEDSIM_SQLITE, import_jupedsim
from tracking.formats.read_result import Filmed
from tracking.formats.track_writer import Exported
from tracking.tracks import TrackTable

WALK = table([(0, 3), (2, 3), (2, 5)], floor=[(1.5, 4.25), (1.75, 4), (-2, 7)])


def exported(made: TrackTable = WALK, **known: Any) -> Exported:
    return Exported.of_table(made, **{"fps": 12.5, "frames": 9, **known})


def written(folder: Path, *statements: str) -> Path:
    """A good file with one row, then changed."""
    path = folder / "t.sqlite"
    with closing(sqlite3.connect(path, isolation_level=None)) as database:
        for statement in (
            "PRAGMA synchronous = OFF",
            "CREATE TABLE trajectory_data(frame, id, pos_x, pos_y)",
            "CREATE TABLE metadata(key TEXT, value TEXT)",
            "INSERT INTO metadata VALUES('version', '3'), ('fps', '25.0')",
            "INSERT INTO trajectory_data VALUES(0, 1, 2.0, 3.0)",
            *statements,
        ):
            database.execute(statement)
    return path


@settings(
    suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None, max_examples=15
)
@given(tracks())
def test_who_has_a_place_comes_back(tmp_path: Path, made: TrackTable) -> None:
    placed = known_rows(made.columns(), "x")
    if not len(placed["frame"]):
        with pytest.raises(FormatError, match="nobody has a place"):
            through(JUPEDSIM_SQLITE, tmp_path / "t.sqlite", exported(made))
        return
    back = through(JUPEDSIM_SQLITE, tmp_path / "t.sqlite", exported(made))
    assert_same(back.columns, placed, FLOOR)
    assert np.isnan(back.columns["left"]).all()
    assert (back.fps, back.bad_count) == (12.5, 0)


def test_pedpy_loads_the_places_and_an_area_that_holds_them(tmp_path: Path) -> None:
    path = tmp_path / "t.sqlite"
    through(JUPEDSIM_SQLITE, path, exported())
    loaded = pedpy.load_trajectory_from_jupedsim_sqlite(trajectory_file=path)
    assert loaded.frame_rate == 12.5
    rows = loaded.data[["id", "frame", "x", "y"]].to_numpy().tolist()
    assert rows == [[3, 0, 1.5, 4.25], [3, 2, 1.75, 4], [5, 2, -2, 7]]
    area = pedpy.load_walkable_area_from_jupedsim_sqlite(trajectory_file=path)
    assert area.bounds == (-3, 3, 2.75, 8)


def test_every_frame_has_its_area_and_people_face_where_they_walk(tmp_path: Path) -> None:
    columns = dict(WALK.columns())
    columns["vx"] = np.array([3.0, 0.0, np.nan])
    columns["vy"] = np.array([-4.0, 0.0, np.nan])
    path = tmp_path / "t.sqlite"
    through(JUPEDSIM_SQLITE, path, exported(TrackTable(columns)))
    with closing(sqlite3.connect(path)) as database:
        facing = database.execute("SELECT ori_x, ori_y FROM trajectory_data").fetchall()
        joined = "SELECT count(*) FROM frame_data JOIN geometry ON hash = geometry_hash"
        assert database.execute(joined).fetchone() == (9,)
        known = dict(database.execute("SELECT key, value FROM metadata"))
    assert facing == [(0.6, -0.8), (0, 0), (0, 0)]
    assert known == {
        "version": "2",
        "fps": "12.5",
        "xmin": "-3.0",
        "ymin": "3.0",
        "xmax": "2.75",
        "ymax": "8.0",
    }


def test_cancelling_leaves_no_file(tmp_path: Path) -> None:
    def cancel(_done: int, _total: int) -> None:
        raise CancelledError("stopped")

    assert JUPEDSIM_SQLITE.write is not None
    with pytest.raises(CancelledError):
        JUPEDSIM_SQLITE.write(tmp_path / "t.sqlite", exported(), cancel)
    assert not list(tmp_path.iterdir())


def test_files_without_orientation_are_read_with_ids_from_zero(tmp_path: Path) -> None:
    found = import_jupedsim(
        written(tmp_path, "INSERT INTO trajectory_data VALUES(0, 0, 5, 6)"), Filmed()
    )
    assert found.columns["track"].tolist() == [1, 2]
    assert found.columns["x"].tolist() == [2, 5]
    assert found.fps == 25


@pytest.mark.parametrize(
    ("row", "reason"),
    [
        ("-1, 1, 0, 0", "the frame number"),
        ("99999999999, 1, 0, 0", "the frame number"),
        ("1.5, 1, 0, 0", "whole numbers"),
        ("1, NULL, 0, 0", "finite"),
        ("1, 1, NULL, 0", "finite"),
        ("1, 1, 9e999, 0", "finite"),
        ("1, 1, 'far', 0", "not a number"),
        ("1, 1, x'00ff', 0", "not a number"),
        ("1, -7, 0, 0", "the id"),
        ("0, 1, 0, 0", "stands twice"),
    ],
)
def test_a_bad_row_is_told_by_its_place(tmp_path: Path, row: str, reason: str) -> None:
    path = written(tmp_path, f"INSERT INTO trajectory_data VALUES({row})")
    found = import_jupedsim(path, Filmed())
    assert [bad.place for bad in found.bad_rows] == ["row 1 of trajectory_data"]
    assert reason in found.bad_rows[0].reason
    assert found.columns["frame"].tolist() == [0]


ENDLESS = (
    "CREATE VIEW trajectory_data AS WITH RECURSIVE n(frame) AS (SELECT 0 UNION ALL SELECT frame + 1"
    " FROM n) SELECT frame, 1 AS id, 0 AS pos_x, 0 AS pos_y FROM n"
)


@pytest.mark.parametrize(
    ("statements", "reason"),
    [
        (["DROP TABLE trajectory_data"], "no table trajectory_data"),
        (["DROP TABLE trajectory_data", ENDLESS], "no table trajectory_data"),
        (["DROP TABLE metadata"], "no table metadata"),
        (["UPDATE metadata SET value = '4' WHERE key = 'version'"], "version 4"),
        (["DELETE FROM metadata"], "names no version"),
        (["ALTER TABLE trajectory_data RENAME pos_y TO other"], "no such column"),
        (["INSERT INTO trajectory_data VALUES(1, 1, zeroblob(9000000), 0)"], "too big|damaged"),
        (
            [
                "DROP TABLE trajectory_data",
                "CREATE TABLE trajectory_data(frame, id, pos_x, pos_y AS (abs(frame)))",
            ],
            "computes columns",
        ),
        (
            [
                "DROP TABLE trajectory_data",
                "CREATE VIRTUAL TABLE trajectory_data USING fts5(frame, id, pos_x, pos_y)",
            ],
            "no table trajectory_data",
        ),
    ],
)
def test_hostile_files_are_refused_in_one_line(
    tmp_path: Path, statements: list[str], reason: str
) -> None:
    path = written(tmp_path, *statements)
    with pytest.raises(FormatError, match=reason) as told:
        import_jupedsim(path, Filmed())
    assert str(told.value).startswith(str(path))
    assert "\n" not in str(told.value)


def test_damaged_files_are_refused(tmp_path: Path) -> None:
    rows = ", ".join(["(1, 1, 1, 1)"] * 900)
    path = written(tmp_path, f"INSERT INTO trajectory_data VALUES{rows}")
    data = bytearray(path.read_bytes())
    data[4096:8192] = bytes(range(256)) * 16
    path.write_bytes(data)
    with pytest.raises(FormatError, match="damaged"):
        import_jupedsim(path, Filmed())
    path.write_bytes(data[:5000])
    with pytest.raises(FormatError, match="damaged"):
        import_jupedsim(path, Filmed())
    path.write_bytes(bytes(data[:4096]).replace(b"CREATE TABLE traj", b"CREATE\xedTABLE traj"))
    with pytest.raises(FormatError, match="damaged"):
        import_jupedsim(path, Filmed())
    path.write_text("no database")
    with pytest.raises(FormatError, match="not an SQLite file"):
        import_jupedsim(path, Filmed())


def test_pages_in_a_ring_are_refused(tmp_path: Path) -> None:
    rows = ", ".join(["(1, 1, 1, 1)"] * 9000)
    path = written(tmp_path, f"INSERT INTO trajectory_data VALUES{rows}")
    with closing(sqlite3.connect(path)) as database:
        root = database.execute(
            "SELECT rootpage FROM sqlite_master WHERE name = 'trajectory_data'"
        ).fetchone()[0]
    data = bytearray(path.read_bytes())
    start = (root - 1) * 4096
    assert data[start] == 5  # an inner page: every cell names another one
    cells = int.from_bytes(data[start + 3 : start + 5], "big")
    for at in range(cells):
        cell = start + int.from_bytes(data[start + 12 + 2 * at : start + 14 + 2 * at], "big")
        data[cell : cell + 4] = root.to_bytes(4, "big")
    path.write_bytes(data)
    with pytest.raises(FormatError, match="damaged"):
        import_jupedsim(path, Filmed())
