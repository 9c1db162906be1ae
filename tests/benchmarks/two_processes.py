"""How much sooner two recordings are tracked by two commands at once than one after the other."""

from __future__ import annotations

import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from tests.benchmarks.pipeline import recording
from tests.benchmarks.timing import clock_ms

_ROUNDS = 3


def measure() -> dict[str, float]:
    """`speed_up`: two commands `track` one after the other, over both at once, by the clock.

    2 is the best there can be; a machine with one core has 1. `one_ms`: one command alone, from its
    start to the stored session, the recording of `pipeline`; `both_ms`: two of them begun together.
    All are medians of three, in turn. Other work on the machine counts.
    """
    one, both = np.median([(_tracked_ms(1), _tracked_ms(2)) for _ in range(_ROUNDS)], axis=0)
    return {"speed_up": float(2 * one / both), "one_ms": float(one), "both_ms": float(both)}


def _tracked_ms(processes: int) -> float:
    """How long so many commands at once take.

    Raises:
        RuntimeError: one of them failed.
    """
    path = recording()  # rendered before the clock starts
    with tempfile.TemporaryDirectory(prefix="trackwright-benchmark-") as folder:
        outputs = [Path(folder) / f"{number}.h5" for number in range(processes)]
        taken, told = clock_ms(lambda: _track(path, outputs))
        if not all(output.is_file() for output in outputs):
            raise RuntimeError(f"trackwright track failed:\n{''.join(told)}")
    return taken


def _track(path: Path, outputs: list[Path]) -> list[str]:
    """Begin all commands, then wait for each; gives what they told on standard error."""
    command = [sys.executable, "-m", "app", "track", path, "--out"]
    begun = [
        subprocess.Popen(
            [*command, output], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True
        )
        for output in outputs
    ]
    return [one.communicate()[1] for one in begun]
