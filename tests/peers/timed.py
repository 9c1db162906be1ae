"""A scorer's time and memory in a process of its own, printed as JSON.

Runs in the peers' environments too.
"""

import json
import resource
import sys
import time
from pathlib import Path

from sequences import read_tables

_SELF = Path("/proc/self")


def print_timed(prepare):
    """Print the seconds of processor time, the peak of memory and three figures.

    Args:
        prepare: gets truth and result, (n, 9) each, in whatever form is not counted; gives a
            function that measures, and gives MOTA, IDF1 and HOTA.
    """
    (pair,) = read_tables(sys.argv[1]).values()
    measure = prepare(*pair)
    del pair
    _forget_peak()
    begun = time.process_time()
    figures = measure()
    taken = time.process_time() - begun
    told = dict(zip(("MOTA", "IDF1", "HOTA"), map(float, figures), strict=True))
    print(json.dumps({"seconds": taken, "peak_kib": _peak_kib()} | told))


def _forget_peak():
    """What was taken so far no longer counts, on Linux."""
    try:
        (_SELF / "clear_refs").write_text("5", encoding="ascii")
    except OSError:
        return


def _peak_kib():
    """The most memory of the process since then, data in memory included."""
    try:
        lines = (_SELF / "status").read_text(encoding="ascii").splitlines()
    except OSError:
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return next(int(line.split()[1]) for line in lines if line.startswith("VmHWM"))
