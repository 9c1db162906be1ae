"""A command that is interrupted while it starts says so in a line."""

from __future__ import annotations

import signal
import subprocess
import sys
from pathlib import Path

import pytest

_ROOT = Path(__file__).parents[2]
_SLOW_IMPORT = """
import os, signal, sys
sys.path.insert(0, {root!r})
class Slow:
    def find_spec(self, name, path=None, target=None):
        if name == "typer":
            os.kill(os.getpid(), signal.{name})
sys.meta_path.insert(0, Slow())
from app.launcher import main
main()
"""


@pytest.mark.skipif(sys.platform == "win32", reason="there are no such signals there")
@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM"])
def test_an_interrupt_while_modules_are_imported_is_told_in_a_line(name: str) -> None:
    assert hasattr(signal, name)
    code = _SLOW_IMPORT.format(root=str(_ROOT), name=name)
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd="/")
    assert done.stderr == "trackwright: interrupted; nothing half-done was kept\n"
    assert done.returncode == 130
