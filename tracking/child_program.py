"""Programs of ours that this one begins, with the same Python and the same packages."""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Final

ONE_THREAD: Final[Mapping[str, str]] = dict.fromkeys(
    ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"), "1"
)
"""What NumPy's libraries read when they are loaded."""


def command(*words: str | os.PathLike[str]) -> list[str]:
    """A command that runs a file of ours, or with "-m" a module; the current folder hides none."""
    return [sys.executable, "-P", *(str(word) for word in words)]


def environment(more: Mapping[str, str] | None = None) -> dict[str, str]:
    """Ours with some more, in which the other program finds this package wherever it is begun.

    OpenCV's warnings of damaged images stay out of what is printed, unless somebody asked for them.
    """
    root = str(Path(__file__).parents[1])
    path = os.pathsep.join(filter(None, (root, os.environ.get("PYTHONPATH", ""))))
    return {"OPENCV_LOG_LEVEL": "SILENT", **os.environ, **(more or {}), "PYTHONPATH": path}


def begin(
    *words: str | os.PathLike[str],
    more: Mapping[str, str] | None = None,
    stderr: int | None = None,
) -> subprocess.Popen[bytes]:
    """Begin a program that is asked by its input and answers by its output.

    Args:
        words: see `command`. more: see `environment`. stderr: as in `subprocess`; None: ours.

    Raises OSError where it cannot be begun.
    """
    return subprocess.Popen(
        command(*words),
        env=environment(more),
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=stderr,
        creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
    )


def end(child: subprocess.Popen[bytes]) -> None:
    """Kill the other program, and wait until it is gone."""
    child.kill()
    for stream in (child.stdin, child.stdout):
        with contextlib.suppress(OSError):  # bytes that nobody takes any more
            if stream is not None:
                stream.close()
    child.wait()
