"""`bench`: the project's own benchmarks, which stand beside its tests in the checkout."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import resources
from tracking.errors import TrackwrightError


def run_bench(only: str | None, *, as_json: bool) -> None:
    """Run them; their output is the command's.

    Raises:
        TrackwrightError: this is an installed program without its tests.
    """
    checkout = Path(resources.__file__).parents[1]
    if not (checkout / "tests" / "benchmarks" / "__main__.py").is_file():
        raise TrackwrightError("no benchmarks here: they are run from a checkout of the source")
    words = [*(["--only", only] if only else []), *(["--json"] if as_json else [])]
    command = [sys.executable, "-m", "tests.benchmarks", *words]
    raise SystemExit(subprocess.run(command, cwd=checkout, check=False).returncode)
