"""Files of tracks made to harm, and places to write to that are not what they seem."""

from __future__ import annotations

import io
import sqlite3
import zipfile
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

from tests.sweeps.hostile_files.case import Case, foldered, later, linked, piped, text
from tests.sweeps.hostile_files.recordings import LAUGHS

_REST = ("--recording", "K/stereo/rec", "-o", "W/out.h5")


def _import(file: str) -> tuple[str, ...]:
    return ("import", f"W/{file}", *_REST)


_MOT, _CVAT, _COCO, _CSV = "mot.txt", "cvat.xml", "coco.json", "csv.csv"
_SQL = "jupedsim-sqlite.sqlite"


def _zipped(name: str, data: bytes, *, link: bool = False) -> bytes:
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED) as archive:
        entry = zipfile.ZipInfo(name)
        entry.compress_type = zipfile.ZIP_DEFLATED
        if link:
            entry.external_attr = 0o120777 << 16
        archive.writestr(entry, data)
    return made.getvalue()


def _sql(*statements: str) -> Callable[[Path], None]:
    def make(work: Path) -> None:
        with closing(sqlite3.connect(work / _SQL, isolation_level=None)) as base:
            for statement in statements:
                base.execute(statement)

    return make


def _out(place: str, name: str = "csv") -> tuple[str, ...]:
    return ("export", "W/s.h5", "-o", place, "--format", name)


def nothing(_: Path) -> None:
    """The copy stays as it is."""


_ENDLESS = "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n)"
_DATA = "CREATE VIEW trajectory_data(frame, id, pos_x, pos_y) AS "

FILES = (
    Case(
        "tracks: a far frame",
        "tracks-mot",
        text(_MOT, "1000000000000,1,1,1,9,9,1,-1,-1,-1\n"),
        _import(_MOT),
    ),
    Case(
        "tracks: an id past all",
        "tracks-mot",
        text(_MOT, "1,99999999999999999999,1,1,9,9,1,-1,-1,-1\n"),
        _import(_MOT),
    ),
    Case(
        "tracks: a line of 100 MB",
        "tracks-mot",
        later(lambda: text(_MOT, b"1,1,1,1,9,9,1,-1,-1,-1" + b"1" * 100_000_000)),
        _import(_MOT),
    ),
    Case("tracks: zeros", "tracks-mot", text(_MOT, bytes(10_000_000)), _import(_MOT)),
    Case(
        "tracks: escapes",
        "tracks-mot",
        text(_MOT, "1,1,1,1,9,9,\x1b[31m,-1,-1,-1\n"),
        _import(_MOT),
    ),
    Case(
        "tracks: a million bad rows",
        "tracks-mot",
        later(lambda: text(_MOT, "1,1,1,1,9,9,1,-1,-1,-1\n" * 1_000_000)),
        _import(_MOT),
    ),
    Case("tracks: a pipe", "tracks-mot", piped(_MOT), _import(_MOT)),
    Case("tracks: a device", "tracks-mot", linked(_MOT, "/dev/zero"), _import(_MOT)),
    Case("tracks: a folder", "tracks-mot", foldered(_MOT), _import(_MOT)),
    Case(
        "tracks: a pickle of NumPy's",
        "tracks-mot",
        text(_MOT, b"\x93NUMPY\x01\x00v\x00{'descr': '|O'}" + b"\x80\x04."),
        _import(_MOT),
    ),
    Case(
        "CVAT: entities upon entities",
        "tracks-cvat",
        text(_CVAT, f"{LAUGHS}<annotations>&j;</annotations>"),
        _import(_CVAT),
    ),
    Case(
        "CVAT: an entity of a system file",
        "tracks-cvat",
        text(
            _CVAT,
            '<?xml version="1.0"?><!DOCTYPE annotations [<!ENTITY a SYSTEM "file:///etc/passwd">]><annotations>&a;</annotations>',
        ),
        _import(_CVAT),
    ),
    Case(
        "CVAT: rules over the network",
        "tracks-cvat",
        text(
            _CVAT,
            '<?xml version="1.0"?><!DOCTYPE annotations SYSTEM "http://127.0.0.1:9/x.dtd"><annotations/>',
        ),
        _import(_CVAT),
    ),
    Case(
        "CVAT: elements in elements",
        "tracks-cvat",
        later(lambda: text(_CVAT, "<annotations>" + "<a>" * 500_000)),
        _import(_CVAT),
    ),
    Case(
        "CVAT: an attribute of 100 MB",
        "tracks-cvat",
        later(lambda: text(_CVAT, b'<annotations a="' + b"x" * 100_000_000 + b'"/>')),
        _import(_CVAT),
    ),
    Case(
        "CVAT: an archive that unpacks to a gigabyte",
        "tracks-cvat",
        later(lambda: text("a.zip", _zipped("annotations.xml", b"<annotations>" + bytes(1 << 30)))),
        _import("a.zip"),
    ),
    Case(
        "CVAT: an archive that climbs",
        "tracks-cvat",
        text("a.zip", _zipped("../../elsewhere/victim.txt", b"<annotations/>")),
        _import("a.zip"),
    ),
    Case(
        "CVAT: an archive with a link",
        "tracks-cvat",
        text("a.zip", _zipped("annotations.xml", b"/etc/passwd", link=True)),
        _import("a.zip"),
    ),
    Case(
        "COCO: lists in lists",
        "tracks-coco",
        later(lambda: text(_COCO, '{"images": ' + "[" * 1_000_000)),
        _import(_COCO),
    ),
    Case(
        "COCO: a number of 100,000 digits",
        "tracks-coco",
        text(_COCO, '{"images": [{"id": ' + "9" * 100_000 + "}]}"),
        _import(_COCO),
    ),
    Case(
        "COCO: a text of 100 MB",
        "tracks-coco",
        later(
            lambda: text(
                _COCO, b'{"images": [], "annotations": [], "x": "' + b"y" * 100_000_000 + b'"}'
            )
        ),
        _import(_COCO),
    ),
    Case(
        "COCO: numbers beyond all",
        "tracks-coco",
        text(
            _COCO,
            '{"images": [{"id": 1e999, "frame_id": NaN}], "annotations": [{"bbox": [Infinity]}]}',
        ),
        _import(_COCO),
    ),
    Case(
        "CSV: a quote that never closes",
        "tracks-csv",
        later(lambda: text(_CSV, b'frame,track,left,top,width,height\n"' + b"x,\n" * 10_000_000)),
        _import(_CSV),
    ),
    Case(
        "CSV: a million columns",
        "tracks-csv",
        later(lambda: text(_CSV, "frame,track," + ",".join(map(str, range(1_000_000))) + "\n")),
        _import(_CSV),
    ),
    Case(
        "CSV: columns twice",
        "tracks-csv",
        text(_CSV, "frame,frame,track,track,left\n1,2,3,4,5\n"),
        _import(_CSV),
    ),
    Case(
        "SQLite: an endless view",
        "tracks-jupedsim-sqlite",
        _sql("DROP TABLE trajectory_data", f"{_DATA}{_ENDLESS} SELECT i, 1, 0.0, 0.0 FROM n"),
        _import(_SQL),
    ),
    Case(
        "SQLite: a view that asks for a gigabyte",
        "tracks-jupedsim-sqlite",
        _sql(
            "DROP TABLE trajectory_data", f"{_DATA} SELECT 1, 1, length(zeroblob(999999999)), 0.0"
        ),
        _import(_SQL),
    ),
    Case(
        "SQLite: a generated column",
        "tracks-jupedsim-sqlite",
        _sql("ALTER TABLE trajectory_data ADD COLUMN g AS (hex(zeroblob(400000000)))"),
        _import(_SQL),
        None,
    ),
    Case(
        "SQLite: a search index as a table",
        "tracks-jupedsim-sqlite",
        _sql(
            "DROP TABLE trajectory_data",
            "CREATE VIRTUAL TABLE trajectory_data USING fts5(frame, id, pos_x, pos_y)",
        ),
        _import(_SQL),
    ),
    Case(
        "SQLite: another version's rubbish",
        "tracks-jupedsim-sqlite",
        _sql("UPDATE metadata SET value = '99'"),
        _import(_SQL),
    ),
)
OUTPUTS = (
    Case(
        "output: a link to a file elsewhere",
        "session",
        linked("out.csv", "E/victim.txt"),
        _out("W/out.csv"),
        None,
    ),
    Case(
        "output: a link to a file to be made",
        "session",
        linked("out.csv", "E/made.txt"),
        _out("W/out.csv"),
        None,
    ),
    Case(
        "output: a second name",
        "session",
        lambda work: (work / "out.csv").hardlink_to(work.parent / "elsewhere" / "victim.txt"),
        _out("W/out.csv"),
        None,
    ),
    Case("output: a pipe", "session", piped("out.csv"), _out("W/out.csv"), None),
    Case("output: a folder", "session", foldered("out.csv"), _out("W/out.csv")),
    Case(
        "output: a device that is full",
        "session",
        linked("out.csv", "/dev/full"),
        _out("W/out.csv"),
        None,
    ),
    Case(
        "output: HDF5 over a device",
        "session",
        linked("out.h5", "/dev/zero"),
        _out("W/out.h5", "pedpy-h5"),
        None,
    ),
    Case(
        "output: HDF5 over a pipe", "session", piped("out.h5"), _out("W/out.h5", "pedpy-h5"), None
    ),
    Case(
        "output: a session over a link",
        "tracks-mot",
        linked("out.h5", "E/victim.txt"),
        _import(_MOT),
        None,
    ),
    Case("output: in no folder", "session", nothing, _out("W/none/out.csv")),
    Case("output: a name of 300 letters", "session", nothing, _out(f"W/{'x' * 300}.csv")),
)
CASES = (*FILES, *OUTPUTS)
