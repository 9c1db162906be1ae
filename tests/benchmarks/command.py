"""Command lines of benchmarks, one core for all of them, and how far they are."""

from __future__ import annotations

import argparse
import os
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import cv2

_REAL = Path(__file__).parents[3] / "shared" / "data"
_THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS")


@dataclass(frozen=True, slots=True)
class Options:
    """What a benchmark with a page is asked.

    Attributes:
        report: measure the clips reported and write the page; else those for choosing settings.
        rewrite: measure nothing, write the page from what was measured.
        only: the sections.
        clips: where rendered clips are kept; None: the user's cache.
    """

    report: bool = False
    rewrite: bool = False
    only: tuple[str, ...] = ()
    clips: Path | None = None


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


def page_options(subject: str, description: str, sections: Sequence[str]) -> Options:
    """Read the command line of a subject's page."""
    parser = parser_of(subject, description)
    page = f"docs/results/{subject}.md"
    parser.add_argument("--report", action="store_true", help=f"measure and write {page}")
    parser.add_argument("--rewrite", action="store_true", help="write it from what was measured")
    parser.add_argument("--only", nargs="+", choices=sections, help="these sections")
    parser.add_argument("--clips", type=Path, help="where clips are kept, not the user's cache")
    asked = vars(parser.parse_args())
    return Options(**{**asked, "only": tuple(asked["only"] or sections)})


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
