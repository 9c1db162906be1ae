"""Memory of the child: where there is too little of it, the child ends, and not the window."""

from __future__ import annotations

import contextlib
import os
import re
from pathlib import Path

_SHARE = 0.8
"""Of the memory that is free as a plug-in begins: the rest is the window's."""
_LEAST_BYTES = 1 << 30
LIMIT = "TRACKWRIGHT_PLUGIN_MEMORY_MB"
"""A variable of the environment: the memory that a plug-in may take, where a user says so."""
_FIRST = "600"
"""Of 1000: among ordinary programs the first that the system ends."""


def give_way(*, foreign: bool) -> None:
    """Be the first that the system ends where memory runs out.

    Args:
        foreign: a plug-in runs here, which gets an error before it takes all there is.
    """
    with contextlib.suppress(OSError):
        Path("/proc/self/oom_score_adj").write_text(_FIRST, encoding="ascii")
    if foreign and (most := _asked_bytes() or int(_free_bytes() * _SHARE)):
        _limit(max(most, _LEAST_BYTES))


def _asked_bytes() -> int:
    """0 where nobody says it."""
    told = os.environ.get(LIMIT, "")
    return int(told) << 20 if told.isdecimal() else 0


def _free_bytes() -> int:
    """0 where the system does not say it."""
    try:
        told = Path("/proc/meminfo").read_text(encoding="ascii")
    except OSError:
        return 0
    found = re.search(r"MemAvailable:\s+(\d+) kB", told)
    return int(found[1]) << 10 if found else 0


def _limit(data_bytes: int) -> None:
    try:
        import resource
    except ImportError:  # Windows
        return
    with contextlib.suppress(OSError, ValueError):
        _, hard = resource.getrlimit(resource.RLIMIT_DATA)
        most = data_bytes if hard == resource.RLIM_INFINITY else min(data_bytes, hard)
        resource.setrlimit(resource.RLIMIT_DATA, (most, hard))
