"""Writes pictures into a video file."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import Final, Literal

import av
import cv2
import numpy as np
from av.codec.codec import UnknownCodecError

from tracking.errors import OutputError
from tracking.recording.frame import Image

_Encoder = Literal["libx264", "mpeg4"]
_ENCODERS: tuple[tuple[_Encoder, dict[str, str]], ...] = (
    # The fine noise of a sensor is part of what trackers have to live with: hardly compressed.
    ("libx264", {"crf": "16", "preset": "veryfast", "bf": "0", "threads": "1"}),
    ("mpeg4", {"qscale": "3", "flags": "+qscale"}),
)
_FRAMES_TO_A_KEY = 20
CLIP_COMMENT: Final = "clip exported by trackwright"
"""What a video says of itself that shows a recording with what was drawn over it."""


def is_clip(path: Path) -> bool:
    """Whether a video was exported as a clip: it is no footage. False where it cannot be read."""
    if path.suffix.lower() != ".mp4" or not path.is_file():
        return False
    try:
        # Only plain files, as `open_video` has it.
        with av.open(f"file:{path}", options={"protocol_whitelist": "file"}) as container:
            return container.metadata.get("comment") == CLIP_COMMENT
    except (av.error.FFmpegError, OSError, ValueError):
        return False


class VideoWriter:
    """One camera's video, frame after frame; a context manager.

    What the system says of its file (OSError) is for whoever named the place, such as `part_of`.
    """

    def __init__(self, path: Path, size: tuple[int, int], fps: float, comment: str = "") -> None:
        """Begin a video of images of `size` (width, height), which may say something of itself.

        Raises:
            OutputError: no encoder is there.
            OSError: the file cannot be made.
        """
        encoder, options = _encoder()
        self._container = av.open(str(path), "w", format="mp4")
        if comment:
            self._container.metadata["comment"] = comment
        rate = Fraction(fps).limit_denominator(1001)
        self._stream = self._container.add_stream(encoder, rate=rate, options=options)
        self._stream.width, self._stream.height = size
        self._stream.pix_fmt = "yuv420p"
        self._stream.gop_size = _FRAMES_TO_A_KEY
        self._next = 0

    def write(self, image: Image) -> None:
        """Append a picture; OSError where the disk is full."""
        # OpenCV rounds where FFmpeg's own conversion cuts off two grey levels.
        planes = np.asarray(cv2.cvtColor(image, cv2.COLOR_BGR2YUV_I420), np.uint8)
        frame = av.VideoFrame.from_ndarray(planes, format="yuv420p")
        frame.pts = self._next
        self._next += 1
        self._mux(frame)

    def _mux(self, frame: av.VideoFrame | None) -> None:
        self._container.mux(self._stream.encode(frame))

    def __enter__(self) -> VideoWriter:
        return self

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        if kind is None:
            self._mux(None)
        try:
            self._container.close()
        except OSError:
            if kind is None:
                raise


def _encoder() -> tuple[_Encoder, dict[str, str]]:
    for name, options in _ENCODERS:
        try:
            av.Codec(name, "w")
        except UnknownCodecError:
            continue
        return name, options
    raise OutputError("no video encoder (libx264, mpeg4) is there; install av from a wheel")
