"""Somebody who corrects all day: `soak.py --runs 10000`, so many steps in the real window.

Edits, undo, redo, saves and reopening by keys, without a pause. Whatever was last said to be done
is in the session when it is closed and opened again, and the log gives the tracks. The memory of
the window does not grow with the steps, beyond what an edit in the log takes. Opening and closing
alone is `open_close`'s.
"""

from __future__ import annotations

import contextlib
import resource
import statistics
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from tests.sweeps.command import resident_bytes
from tests.sweeps.kills import tracked_session
from tests.sweeps.runner import Findings, Plan, asked_plan, sweep
from tests.sweeps.session_state import Said, look
from tracking.session import Session

_WARM = 0.2
"""Share of the steps after which everything was done once, and caches are full."""
_MOST_KIB_A_STEP = 16.0
"""An edit is kept in the log, with what was before it and after it."""
_MOST_MIB = 64
"""Besides: what an allocator keeps, and caches that fill late."""


def main() -> int:
    """Take the steps; the exit status."""
    plan, _ = asked_plan(__doc__, 10_000)

    def work(folder: Path, numbers: Sequence[int], findings: Findings) -> None:
        correct_all_day(folder, len(numbers), plan, findings)

    return sweep("soak", replace(plan, workers=1), work)


class Enough(Exception):  # noqa: N818 - no error
    """The time is up."""


def correct_all_day(folder: Path, steps: int, plan: Plan, findings: Findings) -> None:
    """All steps in one window; then what it left."""
    from tests.sweeps.editor import Editor

    path, said, taken = tracked_session(folder), list[str](), list[int]()

    def tell(state: str) -> None:
        said[:] = [state]
        taken.append(resident_bytes())
        findings.count("steps")
        if findings.is_over:
            raise Enough

    editor = Editor(path, folder / "settings.ini", plan.seed, tell, steps)
    with contextlib.suppress(Enough):
        editor.work()
    editor.close()
    wrong, _ = look(path, Said(said[0]))
    if wrong:
        findings.violation(wrong)
    session = Session.look_into(path)
    findings.count("edits in the log", len(session.history))
    findings.count("MiB at most", resource.getrusage(resource.RUSAGE_SELF).ru_maxrss >> 10)
    grown, between = growth(taken)
    findings.count("KiB grown between first and last tenth", round(grown / 1024))
    if grown > between * _MOST_KIB_A_STEP * 1024 + (_MOST_MIB << 20):
        findings.violation(f"the window grows by {grown / 2**20:.0f} MiB in {between} steps")


def growth(taken: Sequence[int]) -> tuple[float, int]:
    """Bytes from the median of the first tenth after warming up to that of the last; and steps."""
    warm = taken[round(_WARM * len(taken)) :]
    tenth = max(1, len(warm) // 10)
    first, last = statistics.median(warm[:tenth]), statistics.median(warm[-tenth:])
    return last - first, len(warm) - tenth


if __name__ == "__main__":
    sys.exit(main())
