"""HDF5 files, of sessions and others, that crash, hang, fill the memory or point elsewhere."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import h5py
import numpy as np

from tests.sweeps.hostile_files.case import (
    EITHER,
    EXPORT,
    INFO,
    Case,
    Make,
    cases,
    elsewhere,
    no_files,
    text,
)

_PEDPY = ("import", "W/pedpy-h5.h5", "--recording", "K/stereo/rec", "-o", "W/out.h5")
_DETECT = (
    *("track", "K/stereo/rec", "--tracker", "three-part", "--frames", "0:2", "-o", "W/out.h5"),
    *("--detector", "W/d.h5"),
)
_PICKLE = b"\x80\x04cos\nsystem\n(S'touch x'\ntR."
_LEFT = "tracks/left"


def spoilt(spoil: Callable[[h5py.File, Path], object], file: str = "s.h5") -> Make:
    """The file with something done to it."""

    def make(work: Path) -> None:
        with h5py.File(work / file, "r+") as opened:
            spoil(opened, elsewhere(work))

    return make


def _set(name: str, value: Any, group: str = "/") -> Make:
    return spoilt(lambda file, _: file[group].attrs.__setitem__(name, value))


def _of_recording(name: str, value: Any) -> Make:
    return _set(name, value, "recording")


def _column(make: Callable[[h5py.File, int, Path], object]) -> Make:
    """Something else than the column `left` of the tracks; it is told the rows that were there."""

    def spoil(file: h5py.File, other: Path) -> None:
        rows = len(file[_LEFT])
        del file[_LEFT]
        make(file, rows, other)

    return spoilt(spoil)


def _table(**how: Any) -> Make:
    return _column(lambda file, _rows, _other: file.create_dataset(_LEFT, **how))


def _link(link: Callable[[Path], Any]) -> Make:
    return _column(lambda file, _, other: file.__setitem__(_LEFT, link(other)))


def _virtual(file: h5py.File, rows: int, _: Path) -> None:
    layout = h5py.VirtualLayout((rows,), "f8")
    layout[:] = h5py.VirtualSource("/etc/passwd", "x", (rows,))
    file.create_virtual_dataset(_LEFT, layout)


def _stored_elsewhere(file: h5py.File, rows: int, _: Path) -> None:
    file.create_dataset(_LEFT, (rows,), "f8", external=[("/etc/passwd", 0, 8 * rows)])


def _bomb(file: h5py.File, *_: Any) -> None:
    made = file.create_dataset(_LEFT, (1 << 28,), "f8", chunks=(1 << 20,), compression="gzip")
    block = np.zeros(1 << 20)
    for start in range(0, 1 << 26, 1 << 20):
        made[start : start + (1 << 20)] = block


def _deep(file: h5py.File, _: Path) -> None:
    group = file["samples"]
    for _ in range(2000):
        group = group.create_group("g")


def _wide(file: h5py.File, _: Path) -> None:
    for number in range(30_000):
        file["samples"].create_group(str(number))


def _attributes(file: h5py.File, _: Path) -> None:
    for number in range(3000):
        file["samples"].attrs[str(number)] = number


def _label(name: str) -> Make:
    def spoil(file: h5py.File, _: Path) -> None:
        for column, value in (("track", 1), ("name", name), ("attributes", "{}"), ("notes", name)):
            dtype = file[f"labels/{column}"].dtype
            del file[f"labels/{column}"]
            file.create_dataset(f"labels/{column}", data=[value], dtype=dtype)

    return spoilt(spoil)


def _author(name: str) -> Make:
    def spoil(file: h5py.File, _: Path) -> None:
        file["edits/author"][...] = [name] * len(file["edits/author"])

    return spoilt(spoil)


def _bytes(change: Callable[[bytes], bytes]) -> Make:
    """The session with its bytes changed."""
    return lambda work: (work / "s.h5").write_bytes(change((work / "s.h5").read_bytes()))


def _zeroed(data: bytes) -> bytes:
    return data[:2048] + bytes(len(data) * 2 // 3 - 2048) + data[len(data) * 2 // 3 :]


_FILES = {
    "session: a pickle": text("s.h5", _PICKLE),
    "session: cut in half": _bytes(lambda data: data[: len(data) // 2]),
    "session: zeroed within": _bytes(_zeroed),
}
_FILES_EITHER = {
    "session: 300 MB of nothing behind it": lambda work: os.truncate(work / "s.h5", 300 << 20),
    "session: behind a block of another program": _bytes(lambda data: bytes(512) + data),
    "an attribute of 60,000 letters": _set("software", "x" * 60_000),
    "escapes in the name of the program": _set("software", "\x1b]0;x\x07\n\x1b[31m"),
    "settings nested endlessly": _set("settings", "[" * 60_000, "runs/0"),
}
_TABLES = {
    "a link into another file": _link(lambda other: h5py.ExternalLink(other / "other.h5", "/x")),
    "a link to a device": _link(lambda _: h5py.ExternalLink("/dev/zero", "/x")),
    "a soft link": _link(lambda _: h5py.SoftLink("/tracks/top")),
    "a table that lies in other tables": _column(_virtual),
    "a table stored in another file": _column(_stored_elsewhere),
    "a filter nobody knows": _table(data=np.zeros(9), compression="lzf"),
    "10^12 rows that are not there": _table(shape=(10**12,), dtype="f8", chunks=(4096,)),
    "80 GB that are not there, in one piece": _table(shape=(10**10,), dtype="f8"),
    "two gigabytes of zeros in two megabytes": _column(_bomb),
    "lists in a column": _table(shape=(5,), dtype=h5py.vlen_dtype(np.int32)),
    "references in a column": _table(shape=(5,), dtype=h5py.ref_dtype),
    "text in a column": _table(data=["=1+1"] * 9),
    "a group within itself": spoilt(
        lambda file, _: file.__setitem__("tracks/again", file["tracks"])
    ),
    "2,000 groups deep": spoilt(_deep),
    "30,000 groups": spoilt(_wide),
    "3,000 attributes": spoilt(_attributes),
    "endless frames a second": _of_recording("fps", np.inf),
    "10^15 frames": _of_recording("frame_count", 10**15),
}
_TABLES_EITHER = {
    "a recording of a long name": _of_recording("path", "x" * 9000),
    "no frames a second": _of_recording("fps", 0.0),
    "a name that is a formula": _label('=HYPERLINK("http://x")'),
}
_TOLD = {
    "escapes in the recording's name": _of_recording("name", "\x1b[2J\nx"),
    "a name from right to left": _label("\u202etxt.exe"),
}
_PLACES = {
    "a recording that is a device": _of_recording("path", "/dev/zero"),
    "a recording far above": _of_recording("path", "../" * 50 + "etc"),
}
_CVAT = ("export", "W/s.h5", "-o", "W/out.xml", "--format", "cvat")
_CURSOR, _ESCAPE = "\x1b[2J\x1b]8;;http://x\x07", "\x1b[31mada\r\nroot"
_MARKUP = _of_recording("name", "<img src=/etc/passwd>")
_ELSEWHERE = spoilt(
    lambda file, _: file.__setitem__("trajectory2", h5py.ExternalLink("/etc/passwd", "/")),
    "pedpy-h5.h5",
)
_NO_NUMBER = spoilt(lambda file, _: file.attrs.__setitem__("format_version", "x"), "d.h5")
CASES: tuple[Case, ...] = (
    *no_files("session", "session", "s.h5", INFO),
    *cases("session", INFO, _FILES),
    *cases("session", INFO, _FILES_EITHER, EITHER),
    *cases("session", EXPORT, _TABLES),
    *cases("session", EXPORT, _TABLES_EITHER, EITHER),
    *cases("session", EXPORT, _PLACES, 0),
    *cases("session", ("info", "W/s.h5"), _TOLD, EITHER),
    Case("a newer format", "session", _set("format_version", "9.0"), EXPORT, 1, "newer"),
    *cases("session", ("info", "W/s.h5"), {"markup in the recording's name": _MARKUP}, 0),
    *cases("session", _CVAT, {"a name that moves the cursor": _label(_CURSOR)}, EITHER),
    *cases("session", ("log", "W/s.h5"), {"an author with an escape": _author(_ESCAPE)}, EITHER),
    *no_files("floor tracks", "tracks-pedpy-h5", "pedpy-h5.h5", _PEDPY),
    Case("floor tracks that lie elsewhere", "tracks-pedpy-h5", _ELSEWHERE, _PEDPY, EITHER),
    *no_files("a detector", "detector", "d.h5", _DETECT),
    Case("a detector that is a pickle", "detector", text("d.h5", _PICKLE), _DETECT),
    Case("a detector without a number", "detector", _NO_NUMBER, _DETECT),
)
