"""What an image file says of itself, read without decoding it: so no image need fill the memory."""

from __future__ import annotations

import re
import struct
from collections.abc import Callable
from pathlib import Path
from typing import BinaryIO

from tracking.translation import msg

MOST_PIXELS = 40_000_000
"""Of one image: 8K video has 33 million. Decoded in colour that takes 120 MB."""
_START_BYTES = 4096
_MOST_BYTES_A_PIXEL = 8
"""Four channels of 16 bits: a file that packs nothing has as many."""
_MOST_BESIDE = 16 << 20
"""Bytes of thumbnails, colour profiles and notes beside the picture."""
_MOST_JPEG_SEGMENTS = 4096
_MOST_TIFF_ENTRIES = 512
_PNG, _JPEG, _BMP, _RIFF = b"\x89PNG\r\n\x1a\n", b"\xff\xd8\xff", b"BM", b"RIFF"
_TIFF = {b"II*\0": "<", b"MM\0*": ">"}
_PNM = tuple(b"P%d" % kind for kind in range(1, 7))
_JPEG_FRAMES = frozenset(range(0xC0, 0xD0)) - {0xC4, 0xC8, 0xCC}
"""Markers that begin a frame; the three left out are tables."""
_JPEG_ALONE = frozenset((0x01, *range(0xD0, 0xD8)))
"""Markers without a length."""
_PNM_HEAD = re.compile(rb"P[1-6](?:\s|#[^\n]*\n)+(\d{1,9})(?:\s|#[^\n]*\n)+(\d{1,9})\s")
_TIFF_SIZE = {256: 0, 257: 1}
_TIFF_TYPES = {1: "B", 3: "H", 4: "I"}

Size = tuple[int, int]


def why_not_decoded(file: Path) -> str:
    """Why an image is not decoded, in words that follow the file's name; "" where it may be.

    Raises:
        OSError: it cannot be read.
    """
    size = size_of(file)
    if size is None:
        return msg("cannot be read as an image")
    width, height = size
    if width * height > MOST_PIXELS:
        return msg(
            "has {width} x {height} px; images of up to {most} Mpx are read",
            width=width,
            height=height,
            most=MOST_PIXELS // 10**6,
        )
    if file.stat().st_size > width * height * _MOST_BYTES_A_PIXEL + _MOST_BESIDE:
        return msg("is far too large for {width} x {height} px", width=width, height=height)
    return ""


def looks_odd(file: Path, size: Size) -> bool:
    """Whether a file does not begin like an image, or like one of another size.

    Args:
        size: width and height in px that the image should have; a turned JPEG tells them the
            other way round.
    """
    try:
        return size_of(file) != size
    except OSError:
        return True


def size_of(file: Path) -> Size | None:
    """Width and height in px as the file says them; None where it is no image of a known kind.

    A turned JPEG tells its size as stored, which need not be that of the picture.

    Raises:
        OSError: it cannot be read.
    """
    with file.open("rb") as stream:
        return size_in(stream)


def size_in(stream: BinaryIO) -> Size | None:
    """The same of a stream that stands at an image's beginning."""
    start = stream.read(_START_BYTES)
    try:
        for signatures, size_told in _KINDS:
            if start.startswith(signatures):
                width, height = size_told(start, stream) or (0, 0)
                return (width, height) if width > 0 and height > 0 else None
    except (struct.error, IndexError):  # the file ends within its header
        pass
    return None


def _png(start: bytes, _stream: BinaryIO) -> Size:
    width, height = struct.unpack_from(">II", start, 16)
    return width, height


def _jpeg(_start: bytes, stream: BinaryIO) -> Size | None:
    """Goes from one segment to the next until one begins a frame."""
    at = 2
    for _ in range(_MOST_JPEG_SEGMENTS):
        stream.seek(at)
        head = stream.read(9)
        if head[0] != 0xFF:
            return None
        if head[1] in _JPEG_FRAMES:
            height, width = struct.unpack_from(">HH", head, 5)
            return width, height
        if head[1] == 0xFF or head[1] in _JPEG_ALONE:  # filled up, or nothing follows
            at += 1 if head[1] == 0xFF else 2
        else:
            at += 2 + int.from_bytes(head[2:4], "big")
    return None


def _bmp(start: bytes, _stream: BinaryIO) -> Size:
    if struct.unpack_from("<I", start, 14)[0] == 12:  # of OS/2
        width, height = struct.unpack_from("<HH", start, 18)
        return width, height
    width, height = struct.unpack_from("<ii", start, 18)
    return abs(width), abs(height)  # a negative height: rows from the top


def _pnm(start: bytes, _stream: BinaryIO) -> Size | None:
    said = _PNM_HEAD.match(start)
    return (int(said[1]), int(said[2])) if said else None


def _webp(start: bytes, _stream: BinaryIO) -> Size | None:
    kind = start[8:16]
    if kind == b"WEBPVP8X":
        width, height = (int.from_bytes(start[at : at + 3], "little") + 1 for at in (24, 27))
        return width, height
    if kind == b"WEBPVP8L":
        bits = int.from_bytes(start[21:25], "little")
        return (bits & 0x3FFF) + 1, (bits >> 14 & 0x3FFF) + 1
    if kind == b"WEBPVP8 ":
        width, height = struct.unpack_from("<HH", start, 26)
        return width & 0x3FFF, height & 0x3FFF
    return None


def _tiff(start: bytes, stream: BinaryIO) -> Size | None:
    """Of the first picture in the file."""
    order = _TIFF[start[:4]]
    stream.seek(struct.unpack_from(f"{order}I", start, 4)[0])
    (count,) = struct.unpack(f"{order}H", stream.read(2))
    if count > _MOST_TIFF_ENTRIES:
        return None
    size = [0, 0]
    entries = stream.read(12 * count)
    for at in range(0, len(entries), 12):
        tag, kind, _values = struct.unpack_from(f"{order}HHI", entries, at)
        if tag in _TIFF_SIZE and kind in _TIFF_TYPES:
            (value,) = struct.unpack_from(f"{order}{_TIFF_TYPES[kind]}", entries, at + 8)
            size[_TIFF_SIZE[tag]] = max(value, size[_TIFF_SIZE[tag]])  # said twice: the worse
    return size[0], size[1]


_KINDS: tuple[tuple[bytes | tuple[bytes, ...], Callable[[bytes, BinaryIO], Size | None]], ...] = (
    (_PNG, _png),
    (_JPEG, _jpeg),
    (_BMP, _bmp),
    (_PNM, _pnm),
    (_RIFF, _webp),
    (tuple(_TIFF), _tiff),
)
