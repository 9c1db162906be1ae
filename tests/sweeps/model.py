"""Sessions against a plain list of states, for a night: `model.py [RUNS] [STEPS] [SEED]`.

The same machine as in `make test`, for as many runs as asked for, from another seed each time.
"""

from __future__ import annotations

import argparse
import random
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "session"))

from hypothesis import seed as seeded
from hypothesis import settings
from hypothesis.database import InMemoryExampleDatabase
from hypothesis.stateful import run_state_machine_as_test
from test_session_model import SessionAgainstStates

RUNS_A_BATCH = 250


def main() -> int:
    """Run as often as asked; a failure ends it with the steps that lead to it."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("runs", type=int, nargs="?", default=10_000)
    parser.add_argument("steps", type=int, nargs="?", default=50)
    parser.add_argument("seed", type=int, nargs="?", default=random.SystemRandom().randrange(2**32))
    asked = parser.parse_args()
    print(f"seed {asked.seed}", flush=True)
    began, done = time.monotonic(), 0
    while done < asked.runs:
        batch = min(RUNS_A_BATCH, asked.runs - done)
        run_batch(batch, asked.steps, asked.seed + done)
        done += batch
        print(f"{done} runs of {asked.steps} steps, {time.monotonic() - began:.0f} s", flush=True)
    print(f"{done} runs of {asked.steps} steps: nothing lost, nothing differs")
    return 0


def run_batch(runs: int, steps: int, seed: int) -> None:
    """Some runs of the machine; raises what it finds."""
    run_state_machine_as_test(
        seeded(seed)(SessionAgainstStates),
        settings=settings(
            max_examples=runs,
            stateful_step_count=steps,
            deadline=None,
            database=InMemoryExampleDatabase(),
        ),
    )


if __name__ == "__main__":
    sys.exit(main())
