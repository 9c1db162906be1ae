"""How long something takes, measured by what this machine does meanwhile.

Seconds say little where machines are slow, shared or throttled. A pace is the processor time of a
piece of plain Python, measured in the same moment: six milliseconds on a quiet machine of 2025.
"""

from __future__ import annotations

import os
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass


@dataclass
class Spent:
    """Processor time of this process and of children that ended, in paces; known at the end."""

    paces: float = float("nan")


@contextmanager
def spent() -> Iterator[Spent]:
    """The processor time that is spent within; what waits for others costs none."""
    found, began_s = Spent(), _spent_s()
    yield found
    found.paces = (_spent_s() - began_s) / _pace_s()


def _spent_s() -> float:
    times = os.times()
    return time.process_time() + times.children_user + times.children_system


def _pace_s() -> float:
    began_s, total = time.thread_time(), 0
    for number in range(100_000):
        total += number * number % 7
    return time.thread_time() - began_s
