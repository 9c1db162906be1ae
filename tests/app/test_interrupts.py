"""A command that is interrupted while it starts says so in a line."""

from __future__ import annotations

import os
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


_AT_ONCE = """
import os, signal, sys
sys.path.insert(0, {root!r})
from app.core.interrupts import end_at_once
end_at_once()
file = os.open({file!r}, os.O_RDWR | os.O_CREAT)
os.write(file, b"data")
os.kill(os.getpid(), signal.SIGINT)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="there are no such signals there")
def test_an_interrupt_without_stderr_ends_all_the_same_and_writes_to_no_file(
    tmp_path: Path,
) -> None:
    file = tmp_path / "victim"
    code = _AT_ONCE.format(root=str(_ROOT), file=str(file))
    shell = ["/bin/sh", "-c", 'exec "$0" -c "$1" 2>&-', sys.executable, code]
    done = subprocess.run(shell, check=False, cwd="/")
    assert (done.returncode, file.read_bytes()) == (130, b"data")


@pytest.mark.skipif(sys.platform == "win32", reason="there are no such signals there")
def test_an_interrupt_ends_all_the_same_where_nobody_reads_stderr(tmp_path: Path) -> None:
    code = _AT_ONCE.format(root=str(_ROOT), file=str(tmp_path / "victim"))
    reader, writer = os.pipe()
    os.close(reader)
    done = subprocess.run([sys.executable, "-c", code], stderr=writer, check=False, cwd="/")
    os.close(writer)
    assert done.returncode == 130
