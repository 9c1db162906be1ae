"""Flow: `python -m tests.benchmarks.flow [--report] [--only SECTION ...] [--clips DIR]`.

Without --report: the figures on the clips for choosing settings, printed as the page would have
them. With it: on the clips reported, kept one by one in docs/results/flow.json, and the page made
of them. --rewrite only makes the page and its picture anew.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tests.benchmarks.asking import Asked, asked, one_core


def main() -> None:
    """Measure, and write or print."""
    one_core()
    wish = asked("flow", __doc__ or "", ("scenes", "real", "speed"))
    from tests.benchmarks.flow import report
    from tests.benchmarks.pages import Page

    page = Page("flow")
    for name in () if wish.rewrite else wish.only:
        found = _measures(wish)[name]()
        if wish.report:
            page.keep(name, found)
            _write(page)
        else:
            print(report.writers()[name](found), flush=True)
    if wish.rewrite:
        _write(page)


def _write(page: Any) -> None:
    from tests.benchmarks.flow import report, words

    figures = page.figures()
    if "scenes" in figures:
        page.picture("counts", report.counts_picture(figures["scenes"]))
    page.write(words.INTRODUCTION, report.writers())


def _measures(wish: Asked) -> dict[str, Callable[[], Any]]:
    from tests.benchmarks.flow import clips, counting, real

    known = clips.REPORTED if wish.report else clips.TUNED

    def speed() -> dict[str, Any]:
        from tests.benchmarks.flow_speed import measure

        return dict(measure())

    return {
        "scenes": lambda: counting.scenes(known, wish.clips),
        "real": lambda: real.measure(wish.data),
        "speed": speed,
    }


if __name__ == "__main__":
    main()
