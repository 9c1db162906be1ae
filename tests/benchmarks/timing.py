"""How long work takes, of the processor or of the clock, and how much memory."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

Done = TypeVar("Done")


class Stopwatch:
    """Processor time of a with statement, summed over all times it is entered."""

    def __init__(self) -> None:
        self.total_s = 0.0

    def __enter__(self) -> Stopwatch:
        self._began_s = time.process_time()
        return self

    def __exit__(self, *_: object) -> None:
        self.total_s += time.process_time() - self._began_s


def clock_ms(work: Callable[[], Done]) -> tuple[float, Done]:
    """Milliseconds of the clock, and what came of it."""
    begun_s = time.perf_counter()
    done = work()
    return 1000.0 * (time.perf_counter() - begun_s), done


class Peak:
    """How much more memory this program takes at its highest than when this was begun."""

    def __enter__(self) -> Peak:
        if sys.platform == "linux":
            Path("/proc/self/clear_refs").write_text("5")  # the high-water mark begins anew
        self._before = _status_mb("VmRSS")
        return self

    def __exit__(self, *_: object) -> None:
        """Nothing to let go."""

    def grown_mb(self) -> float:
        """In MB so far; NaN where the system does not tell."""
        return _status_mb("VmHWM") - self._before


def _status_mb(name: str) -> float:
    status = Path("/proc/self/status")
    if not status.is_file():
        return float("nan")
    lines = dict(line.split(":", 1) for line in status.read_text().splitlines())
    return int(lines[name].split()[0]) / 1000
