"""What all programs of their own share, in which files that nobody trusts are read."""

from __future__ import annotations

import contextlib
import os
import subprocess
from pathlib import Path


def search_path() -> str:
    """PYTHONPATH with which the other program finds this package, wherever it is started."""
    root = str(Path(__file__).parents[2])
    return os.pathsep.join(filter(None, [root, os.environ.get("PYTHONPATH", "")]))


def end(child: subprocess.Popen[bytes]) -> None:
    """Kill the other program, and wait until it is gone."""
    child.kill()
    for stream in (child.stdin, child.stdout):
        with contextlib.suppress(OSError):  # bytes that nobody takes any more
            if stream is not None:
                stream.close()
    child.wait()
