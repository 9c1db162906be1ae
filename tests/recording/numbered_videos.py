"""Pictures that carry their own number, and videos of them in many encodings."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from pathlib import Path

import av
import numpy as np
from numpy.typing import NDArray

BITS = 12
BLOCK_PX = 16
WIDTH, HEIGHT = 128, 96
_MASK = 0b010101010101
"""Bits that are drawn inverted, so that no number is a dark bar."""


def numbered_picture(number: int, width: int = WIDTH, height: int = HEIGHT) -> NDArray[np.uint8]:
    """A BGR picture with its number as bright and dark blocks over a moving pattern."""
    v, u = np.mgrid[:height, :width]
    pattern = 90 + 60 * np.sin((u + 3 * number) / 9.0) * np.cos((v - 2 * number) / 11.0)
    picture = np.repeat(pattern.astype(np.uint8)[..., None], 3, axis=2)
    for bit in range(BITS):
        row, column = divmod(bit, width // BLOCK_PX)
        block = np.s_[
            row * BLOCK_PX : (row + 1) * BLOCK_PX, column * BLOCK_PX : (column + 1) * BLOCK_PX
        ]
        picture[block] = 235 if (number ^ _MASK) >> bit & 1 else 20
    return picture


def number_in(picture: NDArray[np.uint8]) -> int:
    """The number a picture carries."""
    number = 0
    for bit in range(BITS):
        row, column = divmod(bit, picture.shape[1] // BLOCK_PX)
        top, left = row * BLOCK_PX + 4, column * BLOCK_PX + 4
        block = picture[top : top + BLOCK_PX - 8, left : left + BLOCK_PX - 8]
        number |= int(block.mean() > 128) << bit
    return number ^ _MASK


def write_video(
    path: Path,
    numbers: Iterable[int],
    codec: str = "libx264",
    fps: int = 25,
    options: Mapping[str, str] | None = None,
    times: Sequence[int] | None = None,
    pixels: str = "yuv420p",
    gop: int | None = None,
    b_frames: int | None = None,
    pictures: Sequence[NDArray[np.uint8]] | None = None,
) -> Path:
    """Encode numbered pictures; `times` are presentation times in 1 / (100 fps) seconds."""
    with av.open(str(path), "w") as container:
        stream = container.add_stream(codec, rate=fps, options=dict(options or {}))
        stream.width, stream.height, stream.pix_fmt = WIDTH, HEIGHT, pixels
        if pictures:
            stream.height, stream.width = pictures[0].shape[:2]
        if gop is not None:
            stream.codec_context.gop_size = gop
        if b_frames is not None:
            stream.codec_context.max_b_frames = b_frames
        if times is not None:
            stream.codec_context.time_base = Fraction(1, fps * 100)
        for position, picture in enumerate(pictures or map(numbered_picture, numbers)):
            frame = av.VideoFrame.from_ndarray(picture, format="bgr24")
            if times is not None:
                frame.pts, frame.time_base = times[position], Fraction(1, fps * 100)
            container.mux(stream.encode(frame))
        container.mux(stream.encode(None))
    return path
