"""Spheroids: `python -m tests.benchmarks.spheroid [--report] [--only SECTION ...] [--clips DIR]`.

Without --report: the figures on the clips for choosing settings, printed as the page would have
them. With it: on the clips reported, kept one by one in docs/results/spheroid.json, and the page
made of them. --rewrite only makes the page anew.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tests.benchmarks.asking import Asked, asked, one_core

SECTIONS = ("marks", "situations", "real", "places", "befallen", "speed")


def main() -> None:
    """Measure, and write or print."""
    one_core()
    wish = asked("spheroid", __doc__ or "", SECTIONS)
    from tests.benchmarks.pages import Page
    from tests.benchmarks.spheroid import report, words

    page = Page("spheroid")
    for name in () if wish.rewrite else wish.only:
        found = _measures(wish)[name]()
        if wish.report:
            page.keep(name, found)
            page.write(words.INTRODUCTION, report.writers())
            if name == "situations":
                _picture(page, wish)
        else:
            print(report.writers()[name](found), flush=True)
    if wish.rewrite:
        page.write(words.INTRODUCTION, report.writers())


def _measures(wish: Asked) -> dict[str, Callable[[], Any]]:
    from tests.benchmarks.spheroid import clips, ghosts, hard, recordings

    known = clips.REPORTED if wish.report else clips.TUNED
    return {
        "marks": lambda: _marks(known, wish),
        "situations": lambda: hard.situations(known.situations, wish.clips),
        "real": lambda: recordings.real(wish.data),
        "places": lambda: {
            "seconds": clips.SECONDS,
            "rows": recordings.places(known.places, wish.clips),
        },
        "befallen": lambda: {
            "begins with people": ghosts.befallen(known.peopled, wish.clips),
            "light goes out": ghosts.befallen(known.dimmed, wish.clips),
            "camera knocked": ghosts.befallen(known.bumped, wish.clips),
        },
        "speed": _speed,
    }


def _marks(known: Any, wish: Asked) -> dict[str, Any]:
    from tests.benchmarks.spheroid import spots

    return {
        "clips": len(known.standing),
        "standing": spots.standing(known.standing, wish.clips),
        "pairs": spots.standing(known.pairs, wish.clips),
        "walking": spots.walking(known.walking, wish.clips),
    }


def _picture(page: Any, wish: Asked) -> None:
    from tests.benchmarks.spheroid import clips, pictures

    crossing, hidden = clips.REPORTED.situations[6], clips.REPORTED.situations[11]
    shown = pictures.in_a_row(((crossing, 4.0), (crossing, 5.5), (hidden, 6.0)), wish.clips)
    page.photograph("situations", shown)


def _speed() -> dict[str, Any]:
    from tests.benchmarks.spheroid_speed import measure

    return dict(measure())


if __name__ == "__main__":
    main()
