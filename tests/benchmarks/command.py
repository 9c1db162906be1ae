"""Command lines of benchmarks, one core for all of them, and how far they are."""

from __future__ import annotations

import argparse
import os
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import cv2

_REAL = Path(__file__).parents[3] / "shared" / "data"
_THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS")


def parser_of(module: str, description: str | None) -> argparse.ArgumentParser:
    """A parser without arguments yet, whose help is the module's docstring as it stands.

    Args:
        module: below `tests.benchmarks`.
    """
    return argparse.ArgumentParser(
        prog=f"python -m tests.benchmarks.{module}",
        description=description,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )


def real_data() -> Path:
    """The folder of recordings that are not in the project."""
    return Path(os.environ.get("TRACKWRIGHT_DATA") or _REAL)


def one_core() -> None:
    """Measure on one core: numerical libraries look at the variables when they are loaded."""
    if any(os.environ.get(name) != "1" for name in _THREADS):
        os.environ.update(dict.fromkeys(_THREADS, "1"))
        os.execv(sys.executable, [sys.executable, *sys.orig_argv[1:]])
    cv2.setNumThreads(1)


def tell(text: str) -> None:
    """Say on standard error how far the work is: standard output is for figures."""
    print(text, file=sys.stderr, flush=True)


@contextmanager
def telling(what: str) -> Iterator[None]:
    """Say that something is measured, and afterwards how long that took."""
    tell(f"{what}: measuring ...")
    begun_s = time.monotonic()
    yield
    tell(f"{what}: {time.monotonic() - begun_s:.0f} s")
