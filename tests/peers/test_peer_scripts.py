"""The script that starts trackers of others finds its own modules, whichever are installed."""

import subprocess
import sys
from pathlib import Path

import numpy as np

from tests.peers.environments import HERE
from tests.peers.sequences import read_tables, write_tables


def test_trackers_nobody_asks_for_need_not_be_installed(tmp_path: Path) -> None:
    given, told = tmp_path / "given.npz", tmp_path / "told.npz"
    write_tables(given, {"clip": (2, 10.0, np.zeros((0, 8)))})
    subprocess.run([sys.executable, HERE / "follow.py", given, told, "[]"], check=True)
    assert read_tables(told) == []
