"""Flow: `python -m tests.benchmarks.flow [--report] [--only SECTION ...] [--clips DIR]`.

Without --report: the figures on the clips for choosing settings, printed as the page would have
them. With it: on the clips reported, kept one by one in docs/results/flow.json, and the page made
of them. --rewrite only makes the page and its picture anew.
"""

from __future__ import annotations

from typing import Any

from tests.benchmarks.options import Asked
from tests.benchmarks.results import Contents, run

SECTIONS = ("scenes", "real", "speed")


def _contents(wish: Asked) -> Contents:
    from tests.benchmarks.flow import clips, counts, real, report, words

    known = clips.REPORTED if wish.report else clips.TUNED
    return Contents(
        words.INTRODUCTION,
        report.writers(),
        {
            "scenes": lambda: counts.scenes(known, wish.clips),
            "real": lambda: real.measure(wish.data),
            "speed": _speed,
        },
        diagrams={"scenes": ("counts", report.counts_picture)},
    )


def _speed() -> dict[str, Any]:
    from tests.benchmarks.flow_speed import measure

    return dict(measure())


if __name__ == "__main__":
    run("flow", __doc__ or "", SECTIONS, _contents)
