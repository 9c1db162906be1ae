"""Damaged networks, as tracking runs them: `networks.py --runs N`.

Each is a small ONNX with bytes changed or its end cut off, read and run by either engine, every
tenth an appearance network. It is refused in one line or gives sound boxes or embeddings; nothing
but its own process ends, and none takes long.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "networks"))

from small_networks import LIMITS, damaged

from tests.sweeps.runner import Worker, sweep


def attack(worker: Worker) -> Iterator[str]:
    """A damaged network a run."""
    for number in worker.numbers:
        began_s = time.monotonic()
        try:
            outcome = damaged(worker.folder / "network", number)
        except Exception as error:
            outcome = f"raises {error!r}"
        worker.count("networks")
        if outcome in ("refused", "answered"):
            worker.count(outcome)
        else:
            yield f"network {number}: {outcome}"
        if time.monotonic() - began_s > 2 * LIMITS.start_s:
            yield f"network {number}: it takes {time.monotonic() - began_s:.0f} s"


if __name__ == "__main__":
    sys.exit(sweep(attack, 1_000))
