"""Manifests, calibrations, pictures and videos made to harm."""

from __future__ import annotations

import itertools
import struct
import zlib
from pathlib import Path

from tests.sweeps.hostile_files.case import (
    EITHER,
    SHOW,
    Case,
    Make,
    cases,
    later,
    no_files,
    sparse,
    text,
)

_TOML, _YAML, _XML = "rec/recording.toml", "rec/calibration.yaml", "rec/calibration.xml"
_LEFT, _FIRST = "rec/left.mp4", "rec/000000.png"
_TRACK = ("track", "W/rec", "-o", "W/out.h5", "--frames", "0:2", "--fps", "8")
_LOOK = ("info", "W/rec", "--fps", "8")
_OBJECT = "M1: !!python/object/apply:os.system ['touch x']\n"


def _entities() -> str:
    """Each of ten entities is ten of the one before."""
    made = "".join(f'<!ENTITY {b} "{f"&{a};" * 10}">' for a, b in itertools.pairwise("abcdefghij"))
    return f'<?xml version="1.0"?><!DOCTYPE x [<!ENTITY a "ha">{made}]>'


LAUGHS = _entities()
SYSTEM_FILE = '<?xml version="1.0"?><!DOCTYPE x [<!ENTITY a SYSTEM "file:///etc/passwd">]>'


def _anchors() -> str:
    letters = itertools.pairwise("abcdefghijklmnop")
    return "".join(f"{b}: &{b} [*{a},*{a},*{a},*{a}]\n" for a, b in letters)


def said(old: str, new: str) -> Make:
    """The manifest with other words."""

    def make(work: Path) -> None:
        before = (work / _TOML).read_text()
        assert old in before, f"{old} is not in the manifest"
        (work / _TOML).write_bytes(before.replace(old, new).encode("utf-8", "surrogateescape"))

    return make


def _source(name: str) -> Make:
    return said('"left.mp4"', f'"{name}"')


def _tables(lines: str) -> Make:
    """Lines behind all others."""
    return lambda work: (work / _TOML).write_text((work / _TOML).read_text() + lines)


def png(width: int, height: int, *more: bytes) -> bytes:
    """A PNG file of a size that its data does not have."""
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    pieces = ((b"IHDR", header), *((b"zTXt", part) for part in more))
    made = b"\x89PNG\r\n\x1a\n"
    for name, data in (*pieces, (b"IDAT", zlib.compress(bytes(1 << 16))), (b"IEND", b"")):
        made += struct.pack(">I", len(data)) + name + data
        made += struct.pack(">I", zlib.crc32(name + data))
    return made


def _jpeg(width: int, height: int) -> bytes:
    frame = struct.pack(">BHHBBBBBBBBBB", 8, height, width, 3, 1, 17, 0, 2, 17, 0, 3, 17, 0)
    return b"\xff\xd8\xff\xc0" + struct.pack(">H", 2 + len(frame)) + frame + b"\xff\xd9"


def _all_pictures(data: bytes) -> Make:
    return lambda work: [file.write_bytes(data) for file in (work / "rec").iterdir()]


def _renamed(name: str) -> Make:
    return lambda work: (work / "rec" / "000001.png").rename(work / "rec" / name)


_MANIFESTS = {
    "manifest: 300 MB": sparse(_TOML, 300 << 20),
    "manifest: lists in lists": text(_TOML, f"format = 1\nx = {'[' * 90_000}"),
    "manifest: bytes that are no text": text(_TOML, b"\xff\xfe\x00name"),
    "manifest: a source that is a system file": _source("/etc/passwd"),
    "manifest: a source far above": _source("../../../../../../etc/passwd"),
    "manifest: a source of 5,000 letters": _source("x" * 5000),
    "manifest: a source with escapes": _source("\\u001b[31mx\\nroot: \\u0007"),
    "manifest: a source from right to left": _source("\\u202e4pm.tfel"),
    "manifest: a source with a zero": _source("left\\u0000.mp4"),
    "manifest: a source over the network": _source("http://127.0.0.1:9/x.mp4"),
    "manifest: a source by protocol": _source("concat:left.mp4|/etc/passwd"),
    "manifest: a source that is a pipe of ours": _source("pipe:0"),
    "manifest: a source that looks like an option": _source("-i"),
    "manifest: a source in other case": _source("LEFT.MP4"),
    "manifest: a glob of everything": _source("**/**/**/**/*"),
    "manifest: a glob that never closes": _source("[" * 500),
    "manifest: a height that is no number": _tables("\n[ground]\nheight = nan\ntilt = 1\n"),
    "manifest: endless frames a second": said("fps = 8.0", "fps = 1e308"),
    "manifest: a number of 5,000 digits": said("format = 1", f"format = {'1' * 5000}"),
    "source: a playlist of system files": text(
        _LEFT, "#EXTM3U\n#EXTINF:1,\nfile:///etc/passwd\n#EXT-X-ENDLIST\n"
    ),
    "source: a list of other files": text(_LEFT, "ffconcat version 1.0\nfile '/etc/passwd'\n"),
    "source: a playlist over the network": text(
        _LEFT, "#EXTM3U\n#EXTINF:1,\nhttp://127.0.0.1:9/a.ts\n"
    ),
}
_MANIFESTS_EITHER = {
    "manifest: tables in tables": _tables(f"\n[{'.'.join('a' * 20_000)}]\n"),
    "manifest: a name of a megabyte": _tables(f'\n[x]\ny = "{"z" * 1_000_000}"\n'),
    "manifest: a million corners": later(
        lambda: _tables(f"\n[region]\nlook = [{'[1,2],' * 1_000_000}]\n")
    ),
}
_CALIBRATIONS = {
    "calibration: 300 MB": sparse(_YAML, 300 << 20),
    "calibration: anchors upon anchors": text(_YAML, f"%YAML:1.0\na: &a [x,x]\n{_anchors()}"),
    "calibration: an object of Python's": text(_YAML, _OBJECT),
    "calibration: lists in lists": text(_YAML, "M1: " + "[" * 50_000),
    "calibration: a matrix of 10^9 rows": text(
        _YAML,
        "%YAML:1.0\nM1: !!opencv-matrix\n   rows: 1000000000\n   cols: 3\n   dt: d\n   data: [1]\n",
    ),
}
_XML_CALIBRATIONS = {
    "calibration: entities upon entities": text(_XML, f"{LAUGHS}<x><M1>&j;</M1></x>"),
    "calibration: an entity of a system file": text(_XML, f"{SYSTEM_FILE}<x><M1>&a;</M1></x>"),
    "calibration: elements in elements": text(_XML, "<opencv_storage>" + "<a>" * 200_000),
}
_KITTI_CALIBRATIONS = {
    "calibration: a million cameras": later(
        lambda: text("rec/calib.txt", "".join(f"P{n}: {'1 ' * 12}\n" for n in range(300_000)))
    ),
    "calibration: numbers without end": text("rec/calib.txt", f"P0: {'9' * 100_000}\n"),
}
_ROS_CALIBRATION = {
    "calibration: a camera of 10^9 pixels": text(
        "rec/right.yaml", "image_width: 1000000000\nimage_height: 1000000000\n"
    )
}
# One picture that cannot be read costs its frame, which is told, and not the recording.
_PICTURES_LOOKED_AT = {
    "picture: 2^31 x 2^31": text(_FIRST, png(2**31 - 1, 2**31 - 1)),
    "picture: a name with an escape": _renamed("\x1b[31m000001.png"),
    "picture: a name with a line's end": _renamed("000001\n.png"),
    "picture: a name that is no text": _renamed("000001\udcff.png"),
    "picture: a name of 200 digits": _renamed(f"{'9' * 200}.png"),
}
_PICTURES_TRACKED = {
    "picture: one of 30,000 x 30,000": text(_FIRST, png(30_000, 30_000)),
    "picture: a text that unpacks to a gigabyte": later(
        lambda: text(_FIRST, png(64, 48, b"a\0\0" + zlib.compress(bytes(1 << 30), 1)))
    ),
    "picture: a drawing that names files": text(
        _FIRST, '<svg xmlns="http://www.w3.org/2000/svg"><image href="file:///etc/passwd"/></svg>'
    ),
}
_ALL_PICTURES = {
    "picture: no pixel": _all_pictures(png(0, 0)),
    "picture: a JPEG of 65,535 x 65,535": _all_pictures(_jpeg(65_535, 65_535)),
}
_ALL_LARGE = {"picture: 30,000 x 30,000": _all_pictures(png(30_000, 30_000))}
CASES: tuple[Case, ...] = (
    *cases("stereo", SHOW, _MANIFESTS),
    *cases("stereo", SHOW, _MANIFESTS_EITHER, EITHER),
    *no_files("manifest", "stereo", _TOML, SHOW, EITHER),
    *no_files("source", "stereo", _LEFT, SHOW),
    *no_files("calibration", "stereo", _YAML, SHOW),
    *cases("stereo", SHOW, _CALIBRATIONS),
    *cases("xml", SHOW, _XML_CALIBRATIONS),
    *cases("kitti", SHOW, _KITTI_CALIBRATIONS),
    *cases("ros", SHOW, _ROS_CALIBRATION),
    *no_files("picture", "pictures", _FIRST, _LOOK, EITHER),
    *cases("pictures", _LOOK, _PICTURES_LOOKED_AT, EITHER),
    *cases("pictures", _TRACK, _PICTURES_TRACKED, EITHER),
    *cases("pictures", _LOOK, _ALL_PICTURES),
    *cases("pictures", _TRACK, _ALL_LARGE),
)
