"""HDF5 files, of sessions and others, that crash, hang, fill the memory or point elsewhere."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import h5py
import numpy as np

from tests.sweeps.hostile_files.case import (
    EXPORT,
    INFO,
    Case,
    elsewhere,
    foldered,
    linked,
    piped,
    text,
)

_PEDPY = ("import", "W/pedpy-h5.h5", "--recording", "K/stereo/rec", "-o", "W/out.h5")
_DETECT = (
    *("track", "K/stereo/rec", "--tracker", "three-part", "--frames", "0:2", "-o", "W/out.h5"),
    *("--detector", "W/d.h5"),
)


def spoilt(
    spoil: Callable[[h5py.File, Path], object], file: str = "s.h5"
) -> Callable[[Path], None]:
    """The file with something done to it."""

    def make(work: Path) -> None:
        with h5py.File(work / file, "r+") as opened:
            spoil(opened, elsewhere(work))

    return make


def _set(name: str, value: Any, group: str = "/") -> Callable[[Path], None]:
    return spoilt(lambda file, _: file[group].attrs.__setitem__(name, value))


def _table(name: str, **how: Any) -> Callable[[Path], None]:
    def spoil(file: h5py.File, _: Path) -> None:
        if name in file:
            del file[name]
        file.create_dataset(name, **how)

    return spoilt(spoil)


def _link(link: Callable[[Path], Any]) -> Callable[[Path], None]:
    def spoil(file: h5py.File, other: Path) -> None:
        del file["tracks/left"]
        file["tracks/left"] = link(other)

    return spoilt(spoil)


def _virtual(file: h5py.File, _: Path) -> None:
    rows = len(file["tracks/left"])
    del file["tracks/left"]
    layout = h5py.VirtualLayout((rows,), "f8")
    layout[:] = h5py.VirtualSource("/etc/passwd", "x", (rows,))
    file.create_virtual_dataset("tracks/left", layout)


def _stored_elsewhere(file: h5py.File, _: Path) -> None:
    rows = len(file["tracks/left"])
    del file["tracks/left"]
    file.create_dataset("tracks/left", (rows,), "f8", external=[("/etc/passwd", 0, 8 * rows)])


def _circle(file: h5py.File, _: Path) -> None:
    file["tracks/again"] = file["tracks"]


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


def _bomb(file: h5py.File, _: Path) -> None:
    del file["tracks/left"]
    made = file.create_dataset(
        "tracks/left", (1 << 28,), "f8", chunks=(1 << 20,), compression="gzip"
    )
    block = np.zeros(1 << 20)
    for start in range(0, 1 << 26, 1 << 20):
        made[start : start + (1 << 20)] = block


def _label(name: str) -> Callable[[Path], None]:
    def spoil(file: h5py.File, _: Path) -> None:
        for column, value in (("track", 1), ("name", name), ("attributes", "{}"), ("notes", name)):
            old = file[f"labels/{column}"]
            dtype = old.dtype
            del file[f"labels/{column}"]
            file.create_dataset(f"labels/{column}", data=[value], dtype=dtype)

    return spoilt(spoil)


def _author(text_: str) -> Callable[[Path], None]:
    def spoil(file: h5py.File, _: Path) -> None:
        column = file["edits/author"]
        column[...] = [text_] * len(column)

    return spoilt(spoil)


def _sparse_session(work: Path) -> None:
    os.truncate(work / "s.h5", 300 << 20)


def _user_block(work: Path) -> None:
    data = (work / "s.h5").read_bytes()
    (work / "s.h5").write_bytes(bytes(512) + data)


def _zeroed(work: Path) -> None:
    data = bytearray((work / "s.h5").read_bytes())
    data[2048 : len(data) * 2 // 3] = bytes(len(data) * 2 // 3 - 2048)
    (work / "s.h5").write_bytes(data)


def _cut(work: Path) -> None:
    os.truncate(work / "s.h5", (work / "s.h5").stat().st_size // 2)


CASES = (
    Case("session: a device", "session", linked("s.h5", "/dev/zero"), INFO),
    Case("session: a pipe", "session", piped("s.h5"), INFO),
    Case("session: a folder", "session", foldered("s.h5"), INFO),
    Case(
        "session: a pickle", "session", text("s.h5", b"\x80\x04cos\nsystem\n(S'touch x'\ntR."), INFO
    ),
    Case("session: cut in half", "session", _cut, INFO),
    Case("session: zeroed within", "session", _zeroed, INFO),
    Case("session: 300 MB of nothing behind it", "session", _sparse_session, INFO, None),
    Case("session: behind a block of another program", "session", _user_block, INFO, None),
    Case(
        "a link into another file",
        "session",
        _link(lambda other: h5py.ExternalLink(other / "other.h5", "/x")),
        EXPORT,
    ),
    Case(
        "a link to a device",
        "session",
        _link(lambda _: h5py.ExternalLink("/dev/zero", "/x")),
        EXPORT,
    ),
    Case("a soft link", "session", _link(lambda _: h5py.SoftLink("/tracks/top")), EXPORT),
    Case("a table that lies in other tables", "session", spoilt(_virtual), EXPORT),
    Case("a table stored in another file", "session", spoilt(_stored_elsewhere), EXPORT),
    Case(
        "a filter nobody knows",
        "session",
        _table("tracks/left", data=np.zeros(9), compression="lzf"),
        EXPORT,
    ),
    Case(
        "a table of 10^12 rows that are not there",
        "session",
        _table("tracks/left", shape=(10**12,), dtype="f8", chunks=(4096,)),
        EXPORT,
    ),
    Case(
        "80 GB that are not there, in one piece",
        "session",
        _table("tracks/left", shape=(10**10,), dtype="f8"),
        EXPORT,
    ),
    Case("two gigabytes of zeros in two megabytes", "session", spoilt(_bomb), EXPORT),
    Case(
        "lists in a column",
        "session",
        _table("tracks/left", shape=(5,), dtype=h5py.vlen_dtype(np.int32)),
        EXPORT,
    ),
    Case(
        "references in a column",
        "session",
        _table("tracks/left", shape=(5,), dtype=h5py.ref_dtype),
        EXPORT,
    ),
    Case("text in a column", "session", _table("tracks/left", data=["=1+1"] * 9), EXPORT),
    Case("a group within itself", "session", spoilt(_circle), EXPORT),
    Case("2,000 groups deep", "session", spoilt(_deep), EXPORT),
    Case("30,000 groups", "session", spoilt(_wide), EXPORT),
    Case("3,000 attributes", "session", spoilt(_attributes), EXPORT),
    Case("an attribute of 60,000 letters", "session", _set("software", "x" * 60_000), INFO, None),
    Case(
        "escapes in the name of the program",
        "session",
        _set("software", "\x1b]0;x\x07\n\x1b[31m"),
        INFO,
        None,
    ),
    Case(
        "escapes in the recording's name",
        "session",
        _set("name", "\x1b[2J\nx", "recording"),
        ("info", "W/s.h5"),
        None,
    ),
    Case(
        "markup in the recording's name",
        "session",
        _set("name", "<img src=/etc/passwd>", "recording"),
        ("info", "W/s.h5"),
        0,
    ),
    Case(
        "a recording that is a device", "session", _set("path", "/dev/zero", "recording"), EXPORT, 0
    ),
    Case(
        "a recording far above", "session", _set("path", "../" * 50 + "etc", "recording"), EXPORT, 0
    ),
    Case(
        "a recording of a long name", "session", _set("path", "x" * 9000, "recording"), EXPORT, None
    ),
    Case("no frames a second", "session", _set("fps", 0.0, "recording"), EXPORT, None),
    Case("endless frames a second", "session", _set("fps", np.inf, "recording"), EXPORT),
    Case("10^15 frames", "session", _set("frame_count", 10**15, "recording"), EXPORT),
    Case("a newer format", "session", _set("format_version", "9.0"), EXPORT, 1, "newer"),
    Case(
        "settings nested endlessly", "session", _set("settings", "[" * 60_000, "runs/0"), INFO, None
    ),
    Case(
        "a name that moves the cursor",
        "session",
        _label("\x1b[2J\x1b]8;;http://x\x07"),
        ("export", "W/s.h5", "-o", "W/out.xml", "--format", "cvat"),
        None,
    ),
    Case("a name that is a formula", "session", _label('=HYPERLINK("http://x")'), EXPORT, None),
    Case("a name from right to left", "session", _label("\u202etxt.exe"), ("info", "W/s.h5"), None),
    Case(
        "an author with an escape",
        "session",
        _author("\x1b[31mada\r\nroot"),
        ("log", "W/s.h5"),
        None,
    ),
    Case(
        "floor tracks that lie in other tables",
        "tracks-pedpy-h5",
        spoilt(
            lambda file, _: file.__setitem__("trajectory2", h5py.ExternalLink("/etc/passwd", "/")),
            "pedpy-h5.h5",
        ),
        _PEDPY,
        None,
    ),
    Case("floor tracks: a device", "tracks-pedpy-h5", linked("pedpy-h5.h5", "/dev/zero"), _PEDPY),
    Case(
        "a detector that is a pickle",
        "detector",
        text("d.h5", b"\x80\x04cos\nsystem\n(S'touch x'\ntR."),
        _DETECT,
    ),
    Case(
        "a detector without a number",
        "detector",
        spoilt(lambda file, _: file.attrs.__setitem__("format_version", "x"), "d.h5"),
        _DETECT,
    ),
    Case("a detector: a pipe", "detector", piped("d.h5"), _DETECT),
)
