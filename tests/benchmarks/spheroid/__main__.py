"""Spheroids: `python -m tests.benchmarks.spheroid [--report] [--only SECTION ...] [--clips DIR]`.

Without --report: the figures on the clips for choosing settings, printed as the page would have
them. With it: on the clips reported, kept one by one in docs/results/spheroid.json, and the page
made of them. --rewrite only makes the page anew.
"""

from __future__ import annotations

from typing import Any

from tests.benchmarks.options import Asked
from tests.benchmarks.results import Contents, run

SECTIONS = ("marks", "situations", "real", "places", "robustness", "speed")


def _contents(wish: Asked) -> Contents:
    from tests.benchmarks.spheroid import clips, ghosts, hard, recordings, report, words

    known = clips.REPORTED if wish.report else clips.TUNED
    return Contents(
        words.INTRODUCTION,
        report.writers(),
        {
            "marks": lambda: _marks(known, wish),
            "situations": lambda: hard.situations(known.situations, wish.clips),
            "real": lambda: recordings.real(wish.data),
            "places": lambda: {
                "seconds": clips.SECONDS,
                "rows": recordings.places(known.places, wish.clips),
            },
            "robustness": lambda: {
                "begins with people": ghosts.robustness(known.peopled, wish.clips),
                "light goes out": ghosts.robustness(known.dimmed, wish.clips),
                "camera knocked": ghosts.robustness(known.bumped, wish.clips),
            },
            "speed": _speed,
        },
        photographs={"situations": lambda _: _picture(wish)},
    )


def _marks(known: Any, wish: Asked) -> dict[str, Any]:
    from tests.benchmarks.spheroid import spots

    return {
        "clips": len(known.standing),
        "standing": spots.standing(known.standing, wish.clips),
        "pairs": spots.standing(known.pairs, wish.clips),
        "walking": spots.walking(known.walking, wish.clips),
    }


def _picture(wish: Asked) -> Any:
    from tests.benchmarks.spheroid import clips, pictures

    crossing, hidden = clips.REPORTED.situations[6], clips.REPORTED.situations[11]
    return pictures.in_a_row(((crossing, 4.0), (crossing, 5.5), (hidden, 6.0)), wish.clips)


def _speed() -> dict[str, Any]:
    from tests.benchmarks.spheroid_speed import measure

    return dict(measure())


if __name__ == "__main__":
    run("spheroid", __doc__ or "", SECTIONS, _contents)
