"""Frames whose two pictures were taken at one instant, though a camera is late."""

from __future__ import annotations

from collections.abc import Generator
from contextlib import closing
from dataclasses import replace

from tracking.recording.frame import StereoFrame
from tracking.recording.recording import Recording


class Instants:
    """A recording in the left camera's time: frame n holds the left picture n.

    The right picture is the one of the same instant, recorded `lag` frames later. Where there is
    none, before the recording begins or after it ends, the frame's `right_lag` is None, and another
    right picture stands in.

    Attributes:
        recording: where the pictures come from.
        lag: frames by which the right camera is late; negative: the left one. It may be changed
            while `frames` are read: from the next one on it counts.
    """

    def __init__(self, recording: Recording, lag: int = 0) -> None:
        self.recording = recording
        self.lag = lag

    @property
    def frame_count(self) -> int:
        """The number of frames."""
        return self.recording.frame_count

    def read(self, number: int) -> StereoFrame:
        """One frame; RecordingError as `Recording.read`."""
        last = self.frame_count - 1
        if not self.recording.is_stereo or not 0 <= number <= last:
            return self.recording.read(number)
        wanted = number + self.lag
        frame = self.recording.read(number, min(max(wanted, 0), last))
        return frame if 0 <= wanted <= last else replace(frame, right_lag=None)

    def frames(self, start: int, stop: int) -> Generator[StereoFrame]:
        """Frames start to stop (half-open) in order, each picture decoded once.

        After a change of the lag reading begins anew at the frame that comes next.

        Raises:
            RecordingError: the range is not in the recording.
        """
        while True:
            lag = self.lag
            with closing(self.recording.frames(start, stop, lag)) as frames:
                for frame in frames:
                    yield frame
                    start += 1
                    if self.lag != lag:
                        break
                else:
                    return
