"""How evenly frames follow each other."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.recording.plurals import counted

_REGULAR_SHARE = 0.9


@dataclass(frozen=True, slots=True)
class Pace:
    """The rate of a stream and what is odd about it.

    Attributes:
        fps: frames a second; None where nothing tells.
        notes: in words; empty where frames come evenly.
    """

    fps: float | None
    notes: tuple[str, ...]


def pace_of(times_s: NDArray[np.float64] | None, told_fps: float | None) -> Pace:
    """The pace of frames at the given times.

    Args:
        times_s: (n,) increasing seconds; None where the stream has none.
        told_fps: what the container says.
    """
    if times_s is None:
        return Pace(told_fps, ())
    steps = np.diff(times_s)
    if not steps.size or steps.max() <= 0:
        return Pace(told_fps, ())
    usual = float(np.median(steps))
    regular = steps[np.abs(steps - usual) < 0.5 * usual]
    if len(regular) < _REGULAR_SHARE * len(steps):
        fps = len(steps) / float(times_s[-1])
        spread = f"{steps.min() * 1000:.0f} to {steps.max() * 1000:.0f} ms"
        return Pace(fps, (f"the time between frames varies ({spread}); the mean rate counts",))
    fps = 1 / float(regular.mean())
    if told_fps and abs(told_fps - fps) < 0.005 * fps:
        fps = told_fps
    missing = np.round(steps / usual).astype(int) - 1
    gaps = np.flatnonzero(missing > 0)
    if not gaps.size:
        return Pace(fps, ())
    return Pace(
        fps,
        (f"{counted(int(missing[gaps].sum()), 'frame')} not recorded, first after {gaps[0]}",),
    )
