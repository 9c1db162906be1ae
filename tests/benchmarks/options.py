"""What a benchmark with a page is asked on its command line."""

from __future__ import annotations

import argparse
import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

_DATA = Path(__file__).parents[3] / "shared" / "data"


@dataclass(frozen=True, slots=True)
class Asked:
    """The command line.

    Attributes:
        report: measure the clips reported and write the page; else those for choosing settings.
        rewrite: measure nothing, write the page from what was measured.
        only: the sections.
        clips: where rendered clips are kept; None: the user's cache.
        data: folder of real recordings.
    """

    report: bool
    rewrite: bool
    only: tuple[str, ...]
    clips: Path | None
    data: Path


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


def asked(subject: str, description: str, sections: Sequence[str]) -> Asked:
    """Read the command line."""
    parser = parser_of(subject, description)
    page = f"docs/results/{subject}.md"
    parser.add_argument("--report", action="store_true", help=f"measure and write {page}")
    parser.add_argument("--rewrite", action="store_true", help="write it from what was measured")
    parser.add_argument("--only", nargs="+", choices=sections, help="these sections")
    parser.add_argument("--clips", type=Path, help="where clips are kept, not the user's cache")
    parser.add_argument("--data", type=Path, default=_data(), help="folder of real recordings")
    given = parser.parse_args()
    only = tuple(given.only or sections)
    return Asked(given.report, given.rewrite, only, given.clips, given.data)


def one_core() -> None:
    """Everything is measured on one core."""
    for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
        os.environ[variable] = "1"
    import cv2

    cv2.setNumThreads(1)


def _data() -> Path:
    named = os.environ.get("TRACKWRIGHT_DATA")
    return Path(named) if named else _DATA
