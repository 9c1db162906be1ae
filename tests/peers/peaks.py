"""The most memory a stretch of work takes, on Linux.

Runs in the peers' environments too.
"""

import resource
from pathlib import Path

_SELF = Path("/proc/self")


def forget_peak():
    """What was taken so far no longer counts."""
    try:
        (_SELF / "clear_refs").write_text("5", encoding="ascii")
    except OSError:
        return


def peak_kib():
    """The most memory of the process since then, data in memory included, KiB."""
    try:
        lines = (_SELF / "status").read_text(encoding="ascii").splitlines()
    except OSError:
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return next(int(line.split()[1]) for line in lines if line.startswith("VmHWM"))
