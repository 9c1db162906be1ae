"""Opening recordings."""

from __future__ import annotations

from contextlib import AbstractContextManager, nullcontext

import tracking.recording
from tracking.library.paths import AnyPath, as_path
from tracking.recording import OpenOptions, Recording


def open_recording(path: AnyPath, options: OpenOptions | None = None) -> Recording:
    """Open a recording; close it, or use it in a `with` block.

    Args:
        path: a folder with recording.toml, a video, a folder of images, or a recording of another
            program that is known here (docs/recordings.md) or to a plug-in.
        options: what to take instead of what the recording says: calibration, floor, region.

    Returns:
        The recording: `frame_count`, `fps`, `size` in px, `read(number)` with the images
        (height, width, 3) BGR of a frame; frames count from 0.

    Raises:
        RecordingError: it is missing, unreadable, or its cameras do not belong together.
        CalibrationError: the calibration is unreadable or does not fit the images.
    """
    return tracking.recording.open_recording(as_path(path), options)


def opened(recording: Recording | AnyPath) -> AbstractContextManager[Recording]:
    """A recording that is given stays open; one that is named is closed in the end."""
    if isinstance(recording, Recording):
        return nullcontext(recording)
    return open_recording(recording)
