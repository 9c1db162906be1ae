"""What the first bytes of an image file say, so that not every image need be decoded."""

from __future__ import annotations

import struct
from pathlib import Path

_BYTES = 4096
_SIGNATURES = (
    *(b"\x89PNG\r\n\x1a\n", b"\xff\xd8\xff", b"BM", b"II*\0", b"MM\0*", b"RIFF"),
    *(b"P1", b"P2", b"P3", b"P4", b"P5", b"P6"),
)
_JPEG_FRAMES = frozenset(range(0xC0, 0xD0)) - {0xC4, 0xC8, 0xCC}
"""Markers that begin a frame; the three left out are tables."""


def looks_odd(file: Path, size: tuple[int, int]) -> bool:
    """Whether a file does not begin like an image, or like one of another size.

    Args:
        size: width and height in px that the image should have.
    """
    try:
        with file.open("rb") as stream:
            start = stream.read(_BYTES)
    except OSError:
        return True
    return not start.startswith(_SIGNATURES) or size_in(start) not in (None, size)


def size_in(start: bytes) -> tuple[int, int] | None:
    """Width and height in px as a PNG or JPEG file's first bytes say them; None where they don't.

    A turned JPEG tells its size as stored, which need not be that of the picture.
    """
    if start.startswith(_SIGNATURES[0]) and len(start) >= 24:
        width, height = struct.unpack(">II", start[16:24])
        return width, height
    return _jpeg_size(start) if start.startswith(_SIGNATURES[1]) else None


def _jpeg_size(start: bytes) -> tuple[int, int] | None:
    """Goes from one segment to the next until one begins a frame."""
    at = 2
    while at + 9 <= len(start) and start[at] == 0xFF:
        length, height, width = struct.unpack(">2xHxHH", start[at : at + 9])
        if start[at + 1] in _JPEG_FRAMES:
            return width, height
        at += 2 + length
    return None
