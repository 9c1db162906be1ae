"""With how many threads NumPy works in the program."""

from __future__ import annotations

import os
import subprocess
import sys

VARIABLES = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS")
PROBE = f"""
import os, sys
import app.__main__ as program
early = "numpy" not in sys.modules
program.run = lambda _: print(early, *(os.environ[name] for name in {VARIABLES}))
program.main()
"""


def begun(**environment: str) -> list[str]:
    """Whether NumPy is yet to be imported when the program begins, and what it will read then."""
    kept = {name: value for name, value in os.environ.items() if name not in VARIABLES}
    done = subprocess.run(
        [sys.executable, "-c", PROBE],
        env={**kept, **environment},
        capture_output=True,
        text=True,
        check=True,
    )
    return done.stdout.split()


def test_the_program_has_numpy_work_with_one_thread() -> None:
    assert begun() == ["True", "1", "1"]


def test_who_asks_for_more_threads_has_them() -> None:
    assert begun(OPENBLAS_NUM_THREADS="2") == ["True", "2", "1"]
