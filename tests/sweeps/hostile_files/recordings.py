"""Manifests, calibrations, pictures and videos made to harm."""

from __future__ import annotations

import struct
import zlib
from collections.abc import Callable
from pathlib import Path

from tests.sweeps.hostile_files.case import SHOW, Case, foldered, later, linked, piped, sparse, text

_TOML, _YAML = "rec/recording.toml", "rec/calibration.yaml"
_FIRST = "rec/000000.png"
_TRACK = ("track", "W/rec", "-o", "W/out.h5", "--frames", "0:2", "--fps", "8")
_LOOK = ("info", "W/rec", "--fps", "8")
LAUGHS = (
    '<?xml version="1.0"?><!DOCTYPE x [<!ENTITY a "ha">'
    + "".join(
        f'<!ENTITY {b} "{f"&{a};" * 10}">' for a, b in zip("abcdefghi", "bcdefghij", strict=True)
    )
    + "]>"
)


def said(old: str, new: str) -> Callable[[Path], None]:
    """The manifest with other words."""

    def make(work: Path) -> None:
        manifest = work / _TOML
        before = manifest.read_text()
        assert old in before, f"{old} is not in the manifest"
        manifest.write_bytes(before.replace(old, new).encode("utf-8", "surrogateescape"))

    return make


def _source(name: str) -> Callable[[Path], None]:
    return said('"left.mp4"', f'"{name}"')


def _more(lines: str) -> Callable[[Path], None]:
    def make(work: Path) -> None:
        with (work / _TOML).open("a") as file:
            file.write(lines)

    return make


def _sources_beside(name: str) -> Callable[[Path], None]:
    """A link that is named as a source."""

    def make(work: Path) -> None:
        linked("rec/left.mp4", name)(work)

    return make


def png(width: int, height: int, *more: bytes) -> bytes:
    """A PNG file of a size that its data does not have."""
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    pieces = ((b"IHDR", header), *((b"zTXt", part) for part in more))
    pieces = (*pieces, (b"IDAT", zlib.compress(bytes(1 << 16))), (b"IEND", b""))
    made = b"\x89PNG\r\n\x1a\n"
    for name, data in pieces:
        made += struct.pack(">I", len(data)) + name + data
        made += struct.pack(">I", zlib.crc32(name + data))
    return made


def _jpeg(width: int, height: int) -> bytes:
    frame = struct.pack(">BHHBBBBBBBBBB", 8, height, width, 3, 1, 17, 0, 2, 17, 0, 3, 17, 0)
    return b"\xff\xd8\xff\xc0" + struct.pack(">H", 2 + len(frame)) + frame + b"\xff\xd9"


def _all_pictures(data: bytes) -> Callable[[Path], None]:
    def make(work: Path) -> None:
        for file in (work / "rec").iterdir():
            file.write_bytes(data)

    return make


def _renamed(name: str) -> Callable[[Path], object]:
    return lambda work: (work / "rec" / "000001.png").rename(work / "rec" / name)


MANIFESTS = (
    Case("manifest: 300 MB", "stereo", sparse(_TOML, 300 << 20), SHOW),
    Case("manifest: a device", "stereo", linked(_TOML, "/dev/zero"), SHOW),
    Case("manifest: a pipe", "stereo", piped(_TOML), SHOW),
    Case("manifest: a folder", "stereo", foldered(_TOML), SHOW, None),
    Case(
        "manifest: lists in lists", "stereo", text(_TOML, f"format = 1\nx = {'[' * 90_000}"), SHOW
    ),
    Case(
        "manifest: tables in tables", "stereo", _more(f"\n[{'.'.join('a' * 20_000)}]\n"), SHOW, None
    ),
    Case("manifest: bytes that are no text", "stereo", text(_TOML, b"\xff\xfe\x00name"), SHOW),
    Case("manifest: a source that is a system file", "stereo", _source("/etc/passwd"), SHOW),
    Case("manifest: a source far above", "stereo", _source("../../../../../../etc/passwd"), SHOW),
    Case("manifest: a source of 5,000 letters", "stereo", _source("x" * 5000), SHOW),
    Case(
        "manifest: a source with escapes", "stereo", _source("\\u001b[31mx\\nroot: \\u0007"), SHOW
    ),
    Case("manifest: a source from right to left", "stereo", _source("\\u202e4pm.tfel"), SHOW),
    Case("manifest: a source with a zero", "stereo", _source("left\\u0000.mp4"), SHOW),
    Case(
        "manifest: a source over the network", "stereo", _source("http://127.0.0.1:9/x.mp4"), SHOW
    ),
    Case("manifest: a source by protocol", "stereo", _source("concat:left.mp4|/etc/passwd"), SHOW),
    Case("manifest: a source that is a pipe of ours", "stereo", _source("pipe:0"), SHOW),
    Case("manifest: a source that looks like an option", "stereo", _source("-i"), SHOW),
    Case("manifest: a source in other case", "stereo", _source("LEFT.MP4"), SHOW),
    Case("manifest: a glob of everything", "stereo", _source("**/**/**/**/*"), SHOW),
    Case("manifest: a glob that never closes", "stereo", _source("[" * 500), SHOW),
    Case(
        "manifest: a name of a megabyte",
        "stereo",
        later(lambda: _more(f'\n[x]\ny = "{"z" * 1_000_000}"\n')),
        SHOW,
        None,
    ),
    Case(
        "manifest: a height that is no number",
        "stereo",
        _more("\n[ground]\nheight = nan\ntilt = 1\n"),
        SHOW,
    ),
    Case(
        "manifest: a million corners",
        "stereo",
        later(lambda: _more(f"\n[region]\nlook = [{'[1,2],' * 1_000_000}]\n")),
        SHOW,
        None,
    ),
    Case("manifest: endless frames a second", "stereo", said("fps = 8.0", "fps = 1e308"), SHOW),
    Case(
        "manifest: a number of 5,000 digits",
        "stereo",
        said("format = 1", f"format = {'1' * 5000}"),
        SHOW,
    ),
    Case("source: a link to a device", "stereo", _sources_beside("/dev/zero"), SHOW),
    Case("source: a pipe", "stereo", piped("rec/left.mp4"), SHOW),
    Case(
        "source: a playlist of system files",
        "stereo",
        text("rec/left.mp4", "#EXTM3U\n#EXTINF:1,\nfile:///etc/passwd\n#EXT-X-ENDLIST\n"),
        SHOW,
    ),
    Case(
        "source: a list of other files",
        "stereo",
        text("rec/left.mp4", "ffconcat version 1.0\nfile '/etc/passwd'\n"),
        SHOW,
    ),
    Case(
        "source: a playlist over the network",
        "stereo",
        text("rec/left.mp4", "#EXTM3U\n#EXTINF:1,\nhttp://127.0.0.1:9/a.ts\n"),
        SHOW,
    ),
    Case("source: 10 GiB of nothing", "stereo", sparse("rec/left.mp4", 10 << 30), SHOW),
)
CALIBRATIONS = (
    Case("calibration: a device", "stereo", linked(_YAML, "/dev/zero"), SHOW),
    Case("calibration: a pipe", "stereo", piped(_YAML), SHOW),
    Case("calibration: 300 MB", "stereo", sparse(_YAML, 300 << 20), SHOW),
    Case(
        "calibration: anchors upon anchors",
        "stereo",
        text(
            _YAML,
            "%YAML:1.0\na: &a [x,x]\n"
            + "".join(
                f"{b}: &{b} [*{a},*{a},*{a},*{a}]\n"
                for a, b in zip("abcdefghijklmnop", "bcdefghijklmnopq", strict=True)
            ),
        ),
        SHOW,
    ),
    Case(
        "calibration: an object of Python's",
        "stereo",
        text(_YAML, "M1: !!python/object/apply:os.system ['touch x']\n"),
        SHOW,
    ),
    Case("calibration: lists in lists", "stereo", text(_YAML, "M1: " + "[" * 50_000), SHOW),
    Case(
        "calibration: a matrix of 10^9 rows",
        "stereo",
        text(
            _YAML,
            "%YAML:1.0\nM1: !!opencv-matrix\n   rows: 1000000000\n   cols: 3\n   dt: d\n"
            "   data: [1]\n",
        ),
        SHOW,
    ),
    Case(
        "calibration: entities upon entities",
        "xml",
        text("rec/calibration.xml", f"{LAUGHS}<opencv_storage>&j;</opencv_storage>"),
        SHOW,
    ),
    Case(
        "calibration: an entity of a system file",
        "xml",
        text(
            "rec/calibration.xml",
            '<?xml version="1.0"?><!DOCTYPE x [<!ENTITY a SYSTEM "file:///etc/passwd">]><opencv_storage><M1>&a;</M1></opencv_storage>',
        ),
        SHOW,
    ),
    Case(
        "calibration: elements in elements",
        "xml",
        text("rec/calibration.xml", "<opencv_storage>" + "<a>" * 200_000),
        SHOW,
    ),
    Case(
        "calibration: a million cameras",
        "kitti",
        later(
            lambda: text("rec/calib.txt", "".join(f"P{n}: {'1 ' * 12}\n" for n in range(300_000)))
        ),
        SHOW,
    ),
    Case(
        "calibration: numbers without end",
        "kitti",
        text("rec/calib.txt", f"P0: {'9' * 100_000}\n"),
        SHOW,
    ),
    Case(
        "calibration: a camera of 10^9 pixels",
        "ros",
        text("rec/right.yaml", "image_width: 1000000000\nimage_height: 1000000000\n"),
        SHOW,
    ),
)
# One picture that cannot be read costs its frame, which is told, and not the recording.
PICTURES = (
    Case("picture: 30,000 x 30,000", "pictures", _all_pictures(png(30_000, 30_000)), _TRACK),
    Case(
        "picture: one of 30,000 x 30,000",
        "pictures",
        text(_FIRST, png(30_000, 30_000)),
        _TRACK,
        None,
    ),
    Case("picture: 2^31 x 2^31", "pictures", text(_FIRST, png(2**31 - 1, 2**31 - 1)), _LOOK, None),
    Case("picture: no pixel", "pictures", _all_pictures(png(0, 0)), _LOOK),
    Case(
        "picture: a text that unpacks to a gigabyte",
        "pictures",
        later(lambda: text(_FIRST, png(64, 48, b"a\0\0" + zlib.compress(bytes(1 << 30), 1)))),
        _TRACK,
        None,
    ),
    Case(
        "picture: a JPEG of 65,535 x 65,535",
        "pictures",
        _all_pictures(_jpeg(65_535, 65_535)),
        _LOOK,
    ),
    Case("picture: a device", "pictures", linked(_FIRST, "/dev/zero"), _LOOK, None),
    Case("picture: a pipe", "pictures", piped(_FIRST), _LOOK, None),
    Case(
        "picture: a drawing that names files",
        "pictures",
        text(
            _FIRST,
            '<svg xmlns="http://www.w3.org/2000/svg"><image href="file:///etc/passwd"/></svg>',
        ),
        _TRACK,
        None,
    ),
    Case("picture: a name with an escape", "pictures", _renamed("\x1b[31m000001.png"), _LOOK, None),
    Case("picture: a name with a line's end", "pictures", _renamed("000001\n.png"), _LOOK, None),
    Case("picture: a name that is no text", "pictures", _renamed("000001\udcff.png"), _LOOK, None),
    Case("picture: a name of 200 digits", "pictures", _renamed(f"{'9' * 200}.png"), _LOOK, None),
)
CASES = (*MANIFESTS, *CALIBRATIONS, *PICTURES)
