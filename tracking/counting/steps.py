"""Time cut into steps: in which one something happened, and the frame that stands for it."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.arrays import Floats, Integers
from tracking.errors import CountingError

PAPER_STEP_S = 0.5
"""[Yoneji2013] counts every 500 ms."""
_ROUNDING = 1e-9
_MOST_STEPS = 10_000_000


@dataclass(frozen=True, slots=True, eq=False)
class Steps:
    """Step k goes from k step_s to (k + 1) step_s, the end not included; frame 0 is at 0 s.

    Attributes:
        step_s: its length.
        fps: frames a second.
        frame: (k,) the frame shown when each step begins, the nearest one: at it people inside are
            counted. There are as many steps as begin within the recording.
    """

    step_s: float
    fps: float
    frame: Integers

    @classmethod
    def of(cls, frame_count: int, fps: float, step_s: float = PAPER_STEP_S) -> Steps:
        """The steps of a recording.

        Raises CountingError for a step that is no time or shorter than a frame.
        """
        if not (math.isfinite(step_s) and step_s * fps >= 1 - _ROUNDING):
            raise CountingError(
                "a step of {step_s:g} s: it lasts a frame at least, here {frame_s:.4g} s",
                step_s=step_s,
                frame_s=1 / fps,
            )
        count = math.floor(frame_count / (step_s * fps)) + 2
        if count > _MOST_STEPS:
            raise CountingError(
                "{count} steps of {step_s:g} s; make the step longer", count=count, step_s=step_s
            )
        begins = np.arange(count) * (step_s * fps)
        frame = np.floor(begins + 0.5 + _ROUNDING).astype(np.int64)
        return cls(step_s, fps, frame[frame < frame_count])

    def __len__(self) -> int:
        """How many there are."""
        return len(self.frame)

    @property
    def start_s(self) -> Floats:
        """(k,) when each begins."""
        return np.arange(len(self), dtype=np.float64) * self.step_s

    def begins_at(self, frame: Integers) -> NDArray[np.bool_]:
        """(n,) whether a step begins at each frame."""
        begins = np.zeros(int(frame.max(initial=0)) + 1, bool)
        begins[self.frame[self.frame < len(begins)]] = True
        at: NDArray[np.bool_] = begins[frame]
        return at

    def of_time(self, time_s: Floats) -> Integers:
        """(n,) the step each moment lies in."""
        step = np.floor(time_s / self.step_s + _ROUNDING).astype(np.int64)
        return np.clip(step, 0, max(len(self) - 1, 0))
