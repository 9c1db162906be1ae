"""Sessions against a plain list of states, for a night: `model.py --runs 40 [--steps 50]`.

The same machine as in `make test`; a run is 250 sequences of so many steps, from a seed of its own.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "session"))

from hypothesis import seed as seeded
from hypothesis import settings
from hypothesis.database import InMemoryExampleDatabase
from hypothesis.stateful import run_state_machine_as_test
from test_session_model import SessionAgainstStates

from tests.sweeps.runner import Worker, sweep

SEQUENCES = 250


def attack(worker: Worker) -> Iterator[str]:
    """Some sequences a run; a failure tells the steps that lead to it."""
    for _ in worker.numbers:
        machine = seeded(worker.chance().randrange(1 << 32))(SessionAgainstStates)
        how = settings(
            max_examples=SEQUENCES,
            stateful_step_count=worker.asked.steps,
            deadline=None,
            database=InMemoryExampleDatabase(),
        )
        run_state_machine_as_test(machine, settings=how)
        worker.count("sequences", SEQUENCES)
        yield from ()


if __name__ == "__main__":
    sys.exit(sweep(attack, 40, options={"--steps": {"type": int, "default": 50}}))
