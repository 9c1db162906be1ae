"""A program that is killed loses nothing it said was done."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).parent
LONGEST_S = 400
"""Ten seconds on a disk of one's own; each edit and save waits for the disk several times."""


@pytest.mark.skipif(sys.platform == "win32", reason="there is no fork to kill")
def test_no_acknowledged_edit_is_lost_when_the_program_is_killed(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, str(HERE / "kill_points.py"), str(tmp_path), "25", "1"],
        env={**os.environ, "PYTHONPATH": str(HERE.parents[1]), "OPENBLAS_NUM_THREADS": "1"},
        capture_output=True,
        text=True,
        timeout=LONGEST_S,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert "nothing lost" in done.stdout
