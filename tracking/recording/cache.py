"""Decoded frames kept near the playing position."""

from __future__ import annotations

from collections.abc import Iterator
from threading import Lock

from tracking.recording.frame import StereoFrame
from tracking.recording.instants import Instants

_AHEAD_SHARE = 0.75
"""Of the frames that fit, how many lie ahead of the playing position; the rest stay behind it."""
_BEHIND_COST = 3
"""A frame behind the playing position is worth as little as one this many times as far ahead."""


class FrameCache:
    """Frames of a recording, bounded in bytes, those nearest in the play direction first.

    All methods may be called from several threads; none but `read` and `prefetch` decodes, and
    those do not keep the others waiting while they do.

    Args:
        recording: what to read from.
        capacity_bytes: how much the pictures may take together.
    """

    def __init__(self, recording: Instants, capacity_bytes: int) -> None:
        self._recording = recording
        self._capacity_bytes = capacity_bytes
        self._lock = Lock()
        self._frames: dict[int, StereoFrame] = {}
        self._bytes = 0
        self._frame_bytes = 0
        self._head = 0
        self._direction = 1

    @property
    def bytes_used(self) -> int:
        """What the kept pictures take together; never more than the capacity."""
        return self._bytes

    def get(self, number: int) -> StereoFrame | None:
        """A frame if it is kept; never decodes."""
        with self._lock:
            return self._frames.get(number)

    def read(self, number: int) -> StereoFrame:
        """A frame, decoded where it is not kept; RecordingError as `Recording.read`."""
        frame = self.get(number)
        if frame is None:
            frame = self._recording.read(number)
            self._keep(frame)
        return frame

    def point_at(self, number: int, direction: int = 1) -> None:
        """Say where the playing position is.

        Args:
            number: the frame shown.
            direction: 1 plays forward, -1 backward, 0 stands.
        """
        with self._lock:
            self._head, self._direction = number, direction

    def wanted(self) -> int | None:
        """The frame to fetch next; None while all that fit are kept."""
        with self._lock:
            return next((n for n in self._in_order() if n not in self._frames), None)

    def prefetch(self) -> bool:
        """Fetch the frame wanted next; False if there was none."""
        number = self.wanted()
        if number is None:
            return False
        self.read(number)
        return True

    def kept_ranges(self) -> list[tuple[int, int]]:
        """The kept frames as half-open ranges, in order."""
        with self._lock:
            numbers = sorted(self._frames)
        ranges: list[tuple[int, int]] = []
        for number in numbers:
            if ranges and ranges[-1][1] == number:
                ranges[-1] = (ranges[-1][0], number + 1)
            else:
                ranges.append((number, number + 1))
        return ranges

    def clear(self) -> None:
        """Forget all frames."""
        with self._lock:
            self._frames.clear()
            self._bytes = 0

    def _in_order(self) -> Iterator[int]:
        """Frames worth having, the one needed soonest first; no more than fit."""
        fitting = self._capacity_bytes // self._frame_bytes if self._frame_bytes else 1
        ahead = max(1, int(fitting * _AHEAD_SHARE))
        last = self._recording.frame_count - 1
        for distance in range(ahead if self._direction else (fitting + 1) // 2):
            sides = (self._direction,) if self._direction else (1, -1)
            for side in sides:
                number = self._head + side * distance
                if 0 <= number <= last:
                    yield number

    def _keep(self, frame: StereoFrame) -> None:
        size = _bytes_of(frame)
        with self._lock:
            self._frame_bytes = size
            if frame.number in self._frames or size > self._capacity_bytes:
                return
            self._frames[frame.number] = frame
            self._bytes += size
            while self._bytes > self._capacity_bytes:
                dropped = self._frames.pop(max(self._frames, key=self._cost))
                self._bytes -= _bytes_of(dropped)

    def _cost(self, number: int) -> int:
        """How far off a frame's use is."""
        ahead = (number - self._head) * (self._direction or 1)
        if not self._direction:
            return abs(ahead)
        return ahead if ahead >= 0 else -ahead * _BEHIND_COST


def _bytes_of(frame: StereoFrame) -> int:
    """What a frame's pictures take."""
    return sum(one.nbytes for one in (frame.left, frame.right, frame.depth) if one is not None)
