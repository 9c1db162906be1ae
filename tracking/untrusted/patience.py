"""How long looking a file over may take: damage can make the HDF5 library loop without end.

Between two steps of a walk little may happen, so each step renews a short allowance of processor
time. Where it is used up, the system ends the program, and the file is told as damaged.
"""

from __future__ import annotations

import os
from pathlib import Path

STALL_S = 0.75
"""Processor time from one step to the next; a step takes microseconds, opening a file some ms."""
A_ROW_S = 20e-6
"""More for each row of text: h5py takes 1 to 5 us for a short one."""
_LEAST_BYTES = 96 << 20
_BYTES_A_BYTE = 8
"""Text takes 16 bytes a row in a file at least, and up to 100 once h5py has read it."""

_running = False


def begin() -> None:
    """Run out of patience from now on; nothing happens where the system knows no such timer."""
    global _running
    _running = True
    go_on()


def go_on(rows: int = 0) -> None:
    """A step is done, and the next one reads that many rows of text."""
    if _running:
        _set(STALL_S + rows * A_ROW_S)


def memory_for(path: Path, most: int) -> int:
    """Bytes of address space to look a file over with; `most` where that is not known."""
    try:
        pages = int(Path("/proc/self/statm").read_text().split()[0])
        taken = pages * os.sysconf("SC_PAGE_SIZE")
        return min(most, taken + _LEAST_BYTES + _BYTES_A_BYTE * path.stat().st_size)
    except (OSError, ValueError, AttributeError):
        return most


def _set(seconds: float) -> None:
    try:
        import signal

        signal.signal(signal.SIGPROF, signal.SIG_DFL)  # it ends the program
        signal.setitimer(signal.ITIMER_PROF, seconds)
    except (ImportError, AttributeError, ValueError):  # Windows
        return
