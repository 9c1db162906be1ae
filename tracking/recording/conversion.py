"""Decoded frames into BGR pictures."""

from __future__ import annotations

import av
import numpy as np
from av.video.reformatter import ColorRange, Colorspace, VideoReformatter

from tracking.errors import RecordingError
from tracking.recording.frame import Image


def bgr(frame: av.VideoFrame, reformatter: VideoReformatter) -> Image:
    """The frame as (height, width, 3) BGR.

    Args:
        frame: in whatever pixel format the decoder gave.
        reformatter: kept by the caller from frame to frame, which makes it fast. Threads of its
            own would cost it more than they save.

    Raises:
        RecordingError: the pixel format cannot be converted.
    """
    try:
        try:
            converted = reformatter.reformat(frame, format="bgr24", threads=1)
        except av.error.FFmpegError:
            # A colour space that FFmpeg does not convert, often only a damaged header.
            converted = reformatter.reformat(
                frame,
                format="bgr24",
                src_colorspace=Colorspace.ITU601,
                src_color_range=ColorRange.MPEG,
                threads=1,
            )
        return np.asarray(converted.to_ndarray(), np.uint8)
    except (av.error.FFmpegError, ValueError) as error:
        raise RecordingError(
            f"frame {frame.pts}: its pixels ({frame.format.name}) cannot be converted; convert "
            "the video to H.264"
        ) from error
