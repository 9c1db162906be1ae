"""An environment of its own with the wheel, and the versions of the lock file."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import venv
from collections.abc import Iterable
from pathlib import Path

ROOT = Path(__file__).parents[2]


def fresh_environment(work: Path, extras: Iterable[str] = (), more: Iterable[str] = ()) -> Path:
    """Build the wheel and an environment with it in `work`; gives the environment's Python.

    more: packages beside it.
    """
    run_at(ROOT, sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", work)
    wheel = next(work.glob("*.whl"))
    venv.create(work / "env", with_pip=True)
    python = work / "env" / "bin" / "python"
    locked = work / "constraints.txt"
    locked.write_text(versions_of((ROOT / "requirements.lock").read_text()))
    named = ",".join(extras)
    wanted = (f"{wheel}[{named}]" if named else wheel, *more)
    run_at(work, python, "-m", "pip", "install", "--quiet", "-c", locked, *wanted)
    return python


def versions_of(lock: str) -> str:
    """The lock file without its hashes: constraints for what is wanted alone."""
    return "\n".join(
        re.findall(r"^[\w.\[\]-]+==[^\s\\]+(?: ; [^\\\n]*[^\\\s])?", lock, re.MULTILINE)
    )


def run_at(folder: Path, *words: str | Path) -> None:
    """Run a command in a folder. Raises CalledProcessError where it fails."""
    # Where this program was begun from must not hide what the environment holds.
    clean = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    subprocess.run([str(word) for word in words], cwd=folder, env=clean, check=True)
