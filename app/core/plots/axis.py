"""Frames along the screen, and where their numbers stand."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

_MOST_PX_PER_FRAME = 40.0


@dataclass(frozen=True, slots=True)
class TimeAxis:
    """A stretch of frames drawn from `left` over `width` widget units.

    Attributes:
        start: the frame at the left edge, with fractions.
        frames: how many frames the width shows, with fractions.
        frame_count: of the whole recording.
    """

    left: float
    width: float
    start: float
    frames: float
    frame_count: int

    @property
    def px_per_frame(self) -> float:
        """Widget units a frame takes."""
        return self.width / max(self.frames, 1e-9)

    def x_of(self, frame: float) -> float:
        """Where a frame begins."""
        return self.left + (frame - self.start) * self.px_per_frame

    def xs_of(self, frames: NDArray[np.int64]) -> NDArray[np.float64]:
        """Where many frames begin."""
        after_start = frames.astype(np.float64) - self.start
        return after_start * self.px_per_frame + self.left

    def frame_at(self, x: float) -> int:
        """The frame under a place, kept inside the recording."""
        frame = int(np.floor(self.start + (x - self.left) / self.px_per_frame))
        return min(max(frame, 0), max(self.frame_count - 1, 0))

    def edges(self, columns: int) -> NDArray[np.float64]:
        """(columns + 1,) the frames at the borders of so many equal columns."""
        return np.linspace(self.start, self.start + self.frames, columns + 1)

    def resized(self, left: float, width: float) -> TimeAxis:
        """The same frames over another width."""
        return TimeAxis(left, max(width, 1.0), self.start, self.frames, self.frame_count)

    def whole(self, frame_count: int) -> TimeAxis:
        """All of a recording."""
        return TimeAxis(self.left, self.width, 0.0, float(max(frame_count, 1)), frame_count)

    def fitting(self, first: int, end: int) -> TimeAxis:
        """The frames from first to end with a little room at both sides, as close as can be."""
        room = 0.04 * max(end - first, 1)
        return self._spanning(first - room, end - first + 2 * room)

    def around(self, frame: int, frames: float) -> TimeAxis:
        """So many frames with one of them in the middle."""
        return self._spanning(frame + 0.5 - frames / 2, frames)

    def _spanning(self, start: float, frames: float) -> TimeAxis:
        wide = min(max(frames, self._least), float(max(self.frame_count, 1)))
        start -= (wide - frames) / 2
        return TimeAxis(self.left, self.width, start, wide, self.frame_count)._inside()

    @property
    def _least(self) -> float:
        """How few frames it shows when enlarged most."""
        return min(self.width / _MOST_PX_PER_FRAME, float(max(self.frame_count, 1)))

    def zoomed(self, x: float, factor: float) -> TimeAxis:
        """Enlarged so that the frame under `x` stays there, as far as the ends allow."""
        frames = min(max(self.frames / factor, self._least), float(max(self.frame_count, 1)))
        under = self.start + (x - self.left) / self.px_per_frame
        start = under - (x - self.left) * frames / self.width
        return TimeAxis(self.left, self.width, start, frames, self.frame_count)._inside()

    def moved(self, frames: float) -> TimeAxis:
        """Shifted by frames, as far as the ends allow."""
        start = self.start + frames
        return TimeAxis(self.left, self.width, start, self.frames, self.frame_count)._inside()

    def showing(self, frame: int) -> TimeAxis:
        """Turned like a page where the frame lies outside; the same where it is inside."""
        if self.start <= frame < self.start + self.frames:
            return self
        return self.moved(frame - self.start - 0.1 * self.frames)

    def _inside(self) -> TimeAxis:
        latest = max(self.frame_count - self.frames, 0.0)
        start = min(max(self.start, 0.0), latest)
        return TimeAxis(self.left, self.width, start, self.frames, self.frame_count)


def ticks(axis: TimeAxis, fps: float, least_px: float) -> Iterator[tuple[int, str]]:
    """Frames at round times that lie at least `least_px` apart, and what is written there.

    They are written as mm:ss, and where they are less than a second apart all with as many
    decimals: as mm:ss.5, or as mm:ss.25 where tenths do not tell them.
    """
    rate = max(fps, 1e-6)
    step_s = _round_time(least_px / axis.px_per_frame / rate, rate)
    decimals = 0 if step_s >= 1 else 1 if abs(10 * step_s - round(10 * step_s)) < 1e-6 else 2
    first = int(np.floor(axis.start / rate / step_s))
    last = int(np.ceil((axis.start + axis.frames) / rate / step_s))
    for index in range(max(first, 0), last + 1):
        time_s = index * step_s
        frame = round(time_s * rate)
        if frame <= axis.frame_count:
            yield frame, _tick_text(time_s, decimals)


def _round_time(least_s: float, fps: float) -> float:
    frames = (1, 2, 5, 10)
    steps = [count / fps for count in frames if count / fps < 1.0]
    steps += [1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 1800, 3600, 7200]
    return next((step for step in steps if step >= least_s), 14400.0)


def _tick_text(time_s: float, decimals: int) -> str:
    whole, part = divmod(round(10**decimals * time_s), 10**decimals)
    hours, rest = divmod(whole, 3600)
    lead = f"{hours}:" if hours else ""
    parts = f".{part:0{decimals}d}" if decimals else ""
    return f"{lead}{rest // 60:02d}:{rest % 60:02d}{parts}"
