"""Frames whose two pictures were taken at one instant, though an eye is late."""

from __future__ import annotations

from collections import deque
from collections.abc import Generator, Iterator
from contextlib import closing
from dataclasses import replace

from tracking.recording.frame import Image, StereoFrame
from tracking.recording.recording import Recording


class Instants:
    """A recording in the left eye's time: frame n holds the left picture n.

    The right picture is the one of the same instant, recorded `lag` frames later. Where there is
    none, before the recording begins or after it ends, the frame's `right_lag` is None, and another
    right picture stands in.

    Attributes:
        recording: where the pictures come from.
        lag: frames by which the right eye is late; negative: the left one. It may be changed
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

    def frames(self, start: int, stop: int) -> Iterator[StereoFrame]:
        """Frames start to stop (half-open) in order, each picture decoded once.

        After a change of the lag reading begins anew at the frame that comes next.

        Raises:
            RecordingError: the range is not in the recording.
        """
        while start < stop:
            lag = self.lag
            with closing(self._of_lag(lag, start, stop)) as frames:
                for frame in frames:
                    yield frame
                    start += 1
                    if self.lag != lag:
                        break

    def _of_lag(self, lag: int, start: int, stop: int) -> Generator[StereoFrame]:
        if lag and self.recording.is_stereo:
            return self._paired(lag, start, stop)
        return self.recording.frames(start, stop)

    def _paired(self, lag: int, start: int, stop: int) -> Generator[StereoFrame]:
        """Frames of a lag that is not 0: of one eye, pictures wait for those of the other."""
        first, last = max(0, start + min(lag, 0)), min(self.frame_count, stop + max(lag, 0))
        lefts: deque[StereoFrame] = deque()
        rights: dict[int, Image | None] = {}
        with closing(self.recording.frames(first, last)) as recorded:
            for number in range(start, stop):
                wanted = number + lag
                until = max(number, min(wanted, last - 1))
                while first <= until:
                    newest = next(recorded)
                    first += 1
                    if newest.number >= start + lag:
                        rights[newest.number] = newest.right
                    if newest.number >= start:
                        lefts.append(replace(newest, right=None))
                is_there = 0 <= wanted < last
                right = rights.pop(wanted) if is_there else newest.right
                yield replace(lefts.popleft(), right=right, right_lag=lag if is_there else None)
