"""Somebody who corrects all day: `soak.py --runs 10000`, so many steps in the real window.

Edits, undo, redo, saves and reopening by keys, without a pause. Whatever was last said to be done
is in the session when it is closed and opened again, and the log gives the tracks. The memory of
the window does not grow with the steps, beyond what an edit in the log takes. Opening and closing
alone is `open_close`'s.
"""

from __future__ import annotations

import resource
import statistics
import sys
from collections.abc import Iterator, Sequence

from tests.sweeps.command import resident_bytes
from tests.sweeps.runner import Worker, sweep
from tests.sweeps.session_state import Said, look
from tests.sweeps.sessions import SMALL, tracked_session
from tracking.session import Session

_WARM = 0.2
"""Share of the steps after which everything was done once, and caches are full."""
_MOST_KIB_A_STEP = 16.0
"""An edit is kept in the log, with what was before it and after it."""
_MOST_MIB = 64
"""Besides: what an allocator keeps, and caches that fill late."""


def attack(worker: Worker) -> Iterator[str]:
    """All steps in one window; then what it left."""
    from tests.sweeps.editor import Editor

    path, taken = tracked_session(worker.folder, **SMALL), list[int]()
    editor, last = Editor(path, worker.asked.seed), ""
    for _ in worker.numbers:
        last = editor.step()
        taken.append(resident_bytes())
        worker.count("steps")
    editor.close()
    if wrong := look(path, Said(last))[0]:
        yield wrong
    worker.count("edits in the log", len(Session.look_into(path).history))
    worker.count("MiB at most", resource.getrusage(resource.RUSAGE_SELF).ru_maxrss >> 10)
    grown, between = growth(taken)
    worker.count("KiB more in the last tenth than in the first", round(grown / 1024))
    if grown > between * _MOST_KIB_A_STEP * 1024 + (_MOST_MIB << 20):
        yield f"the window grows by {grown / 2**20:.0f} MiB in {between} steps"


def growth(taken: Sequence[int]) -> tuple[float, int]:
    """Bytes from the median of the first tenth after warming up to that of the last; and steps."""
    warm = taken[round(_WARM * len(taken)) :]
    tenth = max(1, len(warm) // 10)
    first, last = statistics.median(warm[:tenth]), statistics.median(warm[-tenth:])
    return last - first, len(warm) - tenth


if __name__ == "__main__":
    sys.exit(sweep(attack, 10_000, workers=1))
