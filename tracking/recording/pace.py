"""How fast pictures come, and what is odd about it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracking.translation import Message, count_msg, msg

_REGULAR_SHARE = 0.9


@dataclass(frozen=True, slots=True)
class Pace:
    """The rate of a stream and what is odd about it.

    Attributes:
        fps: frames a second; None where nothing tells.
        notes: in words; empty where frames come evenly.
    """

    fps: float | None
    notes: tuple[Message, ...]


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
        return Pace(len(steps) / float(times_s[-1]), (_uneven(steps),))
    fps = 1 / float(regular.mean())
    if told_fps and abs(told_fps - fps) < 0.005 * fps:
        fps = told_fps
    missing = np.round(steps / usual).astype(int) - 1
    gaps = np.flatnonzero(missing > 0)
    if not gaps.size:
        return Pace(fps, ())
    note = msg(
        "{frames} not recorded, first after {first}",
        frames=count_msg(int(missing[gaps].sum()), "{n} frame", "{n} frames"),
        first=gaps[0],
    )
    return Pace(fps, (note,))


def _uneven(steps_s: NDArray[np.float64]) -> Message:
    """What is said of frames (n + 1,) whose steps in time (n,) differ."""
    spread = msg(
        "{shortest:.0f} to {longest:.0f} ms",
        shortest=steps_s.min() * 1000,
        longest=steps_s.max() * 1000,
    )
    return msg("the time between frames varies ({spread}); the mean rate counts", spread=spread)
