"""JuPedSim's SQLite files: `trajectory_data` in metres, frames from 0.

Version 2 is written: `trajectory_data` (`frame, id, pos_x, pos_y, ori_x, ori_y`), `frame_data` (the
area of each frame), `geometry` (areas as WKT) and `metadata` (`version, fps, xmin ...`). The
orientation is the direction somebody walks in, (0, 0) where it is not known or they stand; the area
is a rectangle around all places. Versions 1 to 3 are read; orientations are not kept, as velocities
are made anew from places here. Source: JuPedSim's SqliteTrajectoryWriter, database versions 1 to 3.
"""

from __future__ import annotations

import errno
import hashlib
import os
import sqlite3
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import numpy as np

from tracking.atomic_output import part_of
from tracking.errors import FormatError
from tracking.formats.floor_rows import Places, fps_of, on_floor, with_place
from tracking.formats.read_result import FASTEST_FPS, Filmed, Imported, Reading
from tracking.formats.sqlite_file import SIGNATURE, numbers_of, opened
from tracking.formats.track_format import Content, TrackFormat
from tracking.formats.track_writer import Exported
from tracking.progress import Progress, no_progress
from tracking.tracks import Columns
from tracking.translation import msg

_VERSION = 2
_READ_VERSIONS = (1, 2, 3)
_TABLES = ("trajectory_data", "metadata")
_LAYOUT = (
    "CREATE TABLE trajectory_data (frame INTEGER NOT NULL, id INTEGER NOT NULL, "
    "pos_x REAL NOT NULL, pos_y REAL NOT NULL, ori_x REAL NOT NULL, ori_y REAL NOT NULL)",
    "CREATE TABLE metadata(key TEXT NOT NULL UNIQUE PRIMARY KEY, value TEXT NOT NULL)",
    "CREATE TABLE geometry(hash INTEGER NOT NULL, wkt TEXT NOT NULL)",
    "CREATE UNIQUE INDEX geometry_hash on geometry(hash)",
    "CREATE TABLE frame_data(frame INTEGER NOT NULL, geometry_hash INTEGER NOT NULL)",
    "CREATE INDEX frame_id_idx ON trajectory_data(frame, id)",
)


def looks_like_jupedsim(_path: Path, head: bytes) -> bool:
    """Whether a file is SQLite's and names JuPedSim's table where it lists its tables."""
    return head.startswith(SIGNATURE) and b"trajectory_data" in head


def import_jupedsim(path: Path, _filmed: Filmed, report: Progress = no_progress) -> Imported:
    """The tracks of a file. Raises FormatError where it is none of JuPedSim's, or is not safe."""
    reading = Reading(path, report)
    with opened(path, _TABLES) as database:
        known = dict(database.execute("SELECT key, value FROM metadata").fetchmany(1000))
        _check_version(path, known.get("version"))
        names = ("frame", "id", "pos_x", "pos_y")
        table, places = numbers_of(database, reading, "trajectory_data", names)
    frame, track, x, y = table.T
    rows = with_place({"frame": frame, "track": reading.ids_from_zero(track), "x": x, "y": y})
    return reading.imported(
        rows,
        lambda row: msg("row {places} of trajectory_data", places=places[row]),
        fps=_fps(known.get("fps")),
    )


def export_jupedsim(path: Path, exported: Exported, report: Progress) -> tuple[Path, ...]:
    """Write version 2. Raises FormatError without places or frames a second."""
    fps = fps_of(path, exported)
    places = Places(path, exported)
    with part_of(path) as part:
        try:
            with closing(sqlite3.connect(part, isolation_level=None)) as database:
                _write(database, exported, places, fps, report)
        except sqlite3.Error as error:
            raise OSError(errno.EIO, str(error)) from error
        with part.open("rb+") as written:
            os.fsync(written.fileno())
    return (path,)


def _write(
    database: sqlite3.Connection, exported: Exported, places: Places, fps: float, report: Progress
) -> None:
    # The file is taken whole or not at all: it needs no way back of its own.
    for setting in ("synchronous = OFF", "journal_mode = OFF", "page_size = 4096"):
        database.execute(f"PRAGMA {setting}").fetchall()
    database.execute("BEGIN")
    for statement in _LAYOUT:
        database.execute(statement)
    for piece in exported.pieces(report):
        rows = _rows(on_floor(piece))
        database.executemany("INSERT INTO trajectory_data VALUES(?, ?, ?, ?, ?, ?)", rows)
    area = _number_of(places.area)
    database.execute("INSERT INTO geometry VALUES(?, ?)", (area, places.area))
    frames = range(max(exported.frames, places.last_frame + 1))
    database.executemany("INSERT INTO frame_data VALUES(?, ?)", ((frame, area) for frame in frames))
    bounds = zip(("xmin", "ymin", "xmax", "ymax"), map(str, places.bounds), strict=True)
    known = (("version", _VERSION), ("fps", fps), *bounds)
    database.executemany("INSERT INTO metadata VALUES(?, ?)", known)
    database.execute("COMMIT")


def _rows(rows: Columns) -> Iterator[tuple[float, ...]]:
    speed = np.hypot(rows["vx"], rows["vy"])
    with np.errstate(divide="ignore", invalid="ignore"):
        towards = [np.where(speed > 0, rows[name] / speed, 0.0).tolist() for name in ("vx", "vy")]
    held = (rows[name].tolist() for name in ("frame", "track", "x", "y"))
    return zip(*held, *towards, strict=True)


def _number_of(area: str) -> int:
    """Which area it is: the same one has the same number in every file."""
    digest = hashlib.blake2b(area.encode(), digest_size=8).digest()
    return int.from_bytes(digest, "big", signed=True)


def _check_version(path: Path, said: object) -> None:
    text = str(said).strip()
    version = int(text) if text.isascii() and text.isdigit() and len(text) < 10 else None
    if version is None:
        raise FormatError("{path} names no version of JuPedSim's files; export it again", path=path)
    if version not in _READ_VERSIONS:
        raise FormatError(
            "{path} is of version {version} of JuPedSim's files; {newest} is the newest that "
            "is known here",
            path=path,
            version=version,
            newest=max(_READ_VERSIONS),
        )


def _fps(said: object) -> float | None:
    try:
        fps = float(str(said))
    except ValueError:
        return None
    return fps if 0 < fps < FASTEST_FPS else None


JUPEDSIM_SQLITE = TrackFormat(
    "jupedsim-sqlite",
    "JuPedSim, SQLite version 2",
    (".sqlite", ".db"),
    looks_like_jupedsim,
    import_jupedsim,
    export_jupedsim,
    holds=frozenset((Content.PLACES,)),
    needs=Content.PLACES,
    about="Positions on the floor in metres, for analysis of how people walk; no boxes.",
)
