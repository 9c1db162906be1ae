"""Files of tracks made to harm, and places to write to that are not what they seem."""

from __future__ import annotations

import io
import sqlite3
import zipfile
from contextlib import closing
from pathlib import Path

from tests.sweeps.hostile_files.case import EITHER, Case, Make, cases, later, no_files, text
from tests.sweeps.hostile_files.recordings import LAUGHS, SYSTEM_FILE


def _import(file: str) -> tuple[str, ...]:
    return ("import", f"W/{file}", "--recording", "K/stereo/rec", "-o", "W/out.h5")


def _out(place: str, name: str = "csv") -> tuple[str, ...]:
    return ("export", "W/s.h5", "-o", place, "--format", name)


def _zipped(name: str, data: bytes, *, link: bool = False) -> Make:
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED) as archive:
        entry = zipfile.ZipInfo(name)
        entry.compress_type = zipfile.ZIP_DEFLATED
        if link:
            entry.external_attr = 0o120777 << 16
        archive.writestr(entry, data)
    return text("a.zip", made.getvalue())


def _sql(*statements: str) -> Make:
    def make(work: Path) -> None:
        with closing(sqlite3.connect(work / _SQLITE, isolation_level=None)) as base:
            for statement in statements:
                base.execute(statement)

    return make


def _view(query: str) -> Make:
    view = f"CREATE VIEW trajectory_data(frame, id, pos_x, pos_y) AS {query}"
    return _sql("DROP TABLE trajectory_data", view)


_MOT, _CVAT, _COCO, _CSV = "mot.txt", "cvat.xml", "coco.json", "csv.csv"
_SQLITE = "jupedsim-sqlite.sqlite"
_ROW = "1,1,1,1,9,9,1,-1,-1,-1\n"
_ENDLESS = "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n)"
_MB_100 = 100_000_000
_MOT_FILES = {
    "tracks: a far frame": text(_MOT, f"1000000000000{_ROW[1:]}"),
    "tracks: an id past all": text(_MOT, f"1,99999999999999999999{_ROW[3:]}"),
    "tracks: a line of 100 MB": later(lambda: text(_MOT, f"{_ROW.strip()}{'1' * _MB_100}")),
    "tracks: zeros": text(_MOT, bytes(10_000_000)),
    "tracks: escapes": text(_MOT, "1,1,1,1,9,9,\x1b[31m,-1,-1,-1\n"),
    "tracks: a million bad rows": later(lambda: text(_MOT, _ROW * 1_000_000)),
    "tracks: a pickle of NumPy's": text(_MOT, b"\x93NUMPY\x01\x00v\x00{'descr': '|O'}\x80\x04."),
}
_CVAT_FILES = {
    "CVAT: entities upon entities": text(_CVAT, f"{LAUGHS}<annotations>&j;</annotations>"),
    "CVAT: an entity of a system file": text(
        _CVAT, f"{SYSTEM_FILE.replace(' x ', ' annotations ')}<annotations>&a;</annotations>"
    ),
    "CVAT: rules over the network": text(
        _CVAT,
        '<?xml version="1.0"?><!DOCTYPE annotations SYSTEM "http://127.0.0.1:9/x.dtd">'
        "<annotations/>",
    ),
    "CVAT: elements in elements": later(lambda: text(_CVAT, "<annotations>" + "<a>" * 500_000)),
    "CVAT: an attribute of 100 MB": later(
        lambda: text(_CVAT, f'<annotations a="{"x" * _MB_100}"/>')
    ),
}
_CVAT_ARCHIVES = {
    "CVAT: an archive that unpacks to a gigabyte": later(
        lambda: _zipped("annotations.xml", b"<annotations>" + bytes(1 << 30))
    ),
    "CVAT: an archive that climbs": _zipped("../../elsewhere/victim.txt", b"<annotations/>"),
    "CVAT: an archive with a link": _zipped("annotations.xml", b"/etc/passwd", link=True),
}
_COCO_FILES = {
    "COCO: lists in lists": later(lambda: text(_COCO, '{"images": ' + "[" * 1_000_000)),
    "COCO: a number of 100,000 digits": text(_COCO, '{"images": [{"id": ' + "9" * 100_000 + "}]}"),
    "COCO: a text of 100 MB": later(
        lambda: text(_COCO, f'{{"images": [], "annotations": [], "x": "{"y" * _MB_100}"}}')
    ),
    "COCO: numbers beyond all": text(
        _COCO,
        '{"images": [{"id": 1e999, "frame_id": NaN}], "annotations": [{"bbox": [Infinity]}]}',
    ),
}
_CSV_FILES = {
    "CSV: a quote that never closes": later(
        lambda: text(_CSV, 'frame,track,left,top,width,height\n"' + "x,\n" * 10_000_000)
    ),
    "CSV: a million columns": later(
        lambda: text(_CSV, "frame,track," + ",".join(map(str, range(1_000_000))) + "\n")
    ),
    "CSV: columns twice": text(_CSV, "frame,frame,track,track,left\n1,2,3,4,5\n"),
}
_BASES = {
    "SQLite: an endless view": _view(f"{_ENDLESS} SELECT i, 1, 0.0, 0.0 FROM n"),
    "SQLite: a view that asks for a gigabyte": _view(
        "SELECT 1, 1, length(zeroblob(999999999)), 0.0"
    ),
    "SQLite: a search index as a table": _sql(
        "DROP TABLE trajectory_data",
        "CREATE VIRTUAL TABLE trajectory_data USING fts5(frame, id, pos_x, pos_y)",
    ),
    "SQLite: another version's rubbish": _sql("UPDATE metadata SET value = '99'"),
}
_GENERATED = {
    "SQLite: a generated column": _sql(
        "ALTER TABLE trajectory_data ADD COLUMN g AS (hex(zeroblob(400000000)))"
    )
}
_OUTPUTS = {
    "output: in no folder": "W/none/out.csv",
    "output: a name of 300 letters": f"W/{'x' * 300}.csv",
}
CASES: tuple[Case, ...] = (
    *no_files("tracks", "tracks-mot", _MOT, _import(_MOT)),
    *cases("tracks-mot", _import(_MOT), _MOT_FILES),
    *cases("tracks-cvat", _import(_CVAT), _CVAT_FILES),
    *cases("tracks-cvat", _import("a.zip"), _CVAT_ARCHIVES),
    *cases("tracks-coco", _import(_COCO), _COCO_FILES),
    *cases("tracks-csv", _import(_CSV), _CSV_FILES),
    *no_files("SQLite", "tracks-jupedsim-sqlite", _SQLITE, _import(_SQLITE)),
    *cases("tracks-jupedsim-sqlite", _import(_SQLITE), _BASES),
    *cases("tracks-jupedsim-sqlite", _import(_SQLITE), _GENERATED, EITHER),
    *no_files("output", "session", "out.csv", _out("W/out.csv"), EITHER),
    *no_files("output as HDF5", "session", "out.h5", _out("W/out.h5", "pedpy-h5"), EITHER),
    *no_files("output as a session", "tracks-mot", "out.h5", _import(_MOT), EITHER),
    *(Case(name, "session", lambda _: None, _out(out)) for name, out in _OUTPUTS.items()),
)
