"""How long something takes, measured by what this machine does meanwhile.

Seconds say little where machines are slow, shared or throttled. A pace is the processor time of a
piece of plain Python, measured before and after: six milliseconds on a quiet machine of 2025.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass


@dataclass
class Spent:
    """Processor time of this process and of children waited for within, in paces; NaN before."""

    paces: float = float("nan")


@contextmanager
def spent() -> Iterator[Spent]:
    """The processor time that is spent within; what waits for others costs none."""
    pace_s, found, began_s = pace(time.thread_time), Spent(), _spent_s()
    yield found
    lasted_s = _spent_s() - began_s
    found.paces = 2 * lasted_s / (pace_s + pace(time.thread_time))


def _spent_s() -> float:
    times = os.times()
    return time.process_time() + times.children_user + times.children_system


def pace(clock: Callable[[], float]) -> float:
    """How long the piece of plain Python takes here and now, in seconds of a clock."""
    began_s, total = clock(), 0
    for number in range(100_000):
        total += number * number % 7
    return clock() - began_s
