"""A program that is killed loses nothing it said was done."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

LONGEST_S = 400
"""Ten seconds on a disk of one's own; each edit and save waits for the disk several times."""


@pytest.mark.skipif(sys.platform == "win32", reason="there is no fork to kill")
def test_no_acknowledged_edit_is_lost_when_the_program_is_killed() -> None:
    words = ("--runs", "25", "--window", "0", "--workers", "1")
    done = subprocess.run(
        [sys.executable, "-m", "tests.sweeps.kills", *words],
        cwd=Path(__file__).parents[2],
        capture_output=True,
        text=True,
        timeout=LONGEST_S,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert '"kills": 25' in done.stdout
