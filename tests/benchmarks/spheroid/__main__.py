"""Spheroids: `python -m tests.benchmarks.spheroid [--report] [--only SECTION ...] [--clips DIR]`.

Without --report: the figures on the clips for choosing settings, printed as the page would have
them. With it: on the clips reported, kept one by one in docs/results/spheroid.json, and the page
made of them. --rewrite only makes the page anew.
"""

from __future__ import annotations

import argparse
import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

_DATA = Path(__file__).parents[4] / "shared" / "data"
SECTIONS = ("marks", "situations", "real", "places", "befallen", "speed")


@dataclass(frozen=True, slots=True)
class _Asked:
    report: bool
    rewrite: bool
    only: tuple[str, ...]
    clips: Path | None
    data: Path


def main() -> None:
    """Measure, and write or print."""
    for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
        os.environ[variable] = "1"
    asked = _asked()
    import cv2

    from tests.benchmarks.pages import Page
    from tests.benchmarks.spheroid import report, words

    cv2.setNumThreads(1)
    page = Page("spheroid")
    if not asked.rewrite:
        for name in asked.only:
            found = _measures(asked)[name]()
            if not asked.report:
                print(report.writers()[name](found), flush=True)
                continue
            page.keep(name, found)
            page.write(words.INTRODUCTION, report.writers())
    else:
        page.write(words.INTRODUCTION, report.writers())


def _asked() -> _Asked:
    parser = argparse.ArgumentParser(
        prog="python -m tests.benchmarks.spheroid",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--report", action="store_true", help="write docs/results/spheroid.md")
    parser.add_argument("--rewrite", action="store_true", help="write it from what was measured")
    parser.add_argument("--only", nargs="+", choices=SECTIONS, help="these sections")
    parser.add_argument("--clips", type=Path, help="where clips are kept, not the user's cache")
    parser.add_argument("--data", type=Path, default=_data(), help="folder of real recordings")
    asked = parser.parse_args()
    only = tuple(asked.only or SECTIONS)
    return _Asked(asked.report, asked.rewrite, only, asked.clips, asked.data)


def _data() -> Path:
    named = os.environ.get("TRACKWRIGHT_DATA")
    return Path(named) if named else _DATA


def _measures(asked: _Asked) -> dict[str, Callable[[], Any]]:
    from tests.benchmarks.spheroid import clips, ghosts, hard, recordings, spots

    known = clips.REPORTED if asked.report else clips.TUNED
    kept = asked.clips

    def marks() -> dict[str, Any]:
        return {
            "clips": len(known.standing),
            "standing": spots.standing(known.standing, kept),
            "pairs": spots.standing(known.pairs, kept),
            "walking": spots.walking(known.walking, kept),
        }

    def places() -> dict[str, Any]:
        return {"seconds": clips.SECONDS, "rows": recordings.places(known.places, kept)}

    def befallen() -> dict[str, Any]:
        return {
            "begins with people": ghosts.befallen(known.peopled, kept),
            "light goes out": ghosts.befallen(known.dimmed, kept),
            "camera knocked": ghosts.befallen(known.bumped, kept),
        }

    def speed() -> dict[str, Any]:
        from tests.benchmarks.spheroid.speed import measure

        return dict(measure())

    return {
        "marks": marks,
        "situations": lambda: hard.situations(known.situations, kept),
        "real": lambda: recordings.real(asked.data),
        "places": places,
        "befallen": befallen,
        "speed": speed,
    }


if __name__ == "__main__":
    main()
