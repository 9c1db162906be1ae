"""Stereo trackers: `python -m tests.benchmarks.stereo [--report] [--only SECTION ...]`.

Without --report: the figures on the clips for choosing settings, printed as the page would have
them. With it: on the clips reported, kept one by one in docs/results/stereo.json, and the page made
of them. --rewrite only makes the page anew. Clips and runs are kept in the temporary folder, or
where --clips says; clips that are there are taken as they are.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tests.benchmarks.asking import Asked, asked, one_core

SECTIONS = ("tables", "goals", "real", "lost", "befallen", "peers")
"""As they are measured: programs of others come last, as they may fail."""


def main() -> None:
    """Measure, and write or print."""
    one_core()
    wish = asked("stereo", __doc__ or "", SECTIONS)
    from tests.benchmarks.pages import Page
    from tests.benchmarks.stereo import report, words

    page = Page("stereo")
    for name in () if wish.rewrite else wish.only:
        found = _measures(wish)[name]()
        if wish.report:
            page.keep(name, found)
            if name == "lost" and found["shown"]:
                _picture(page, found, wish)
            page.write(words.INTRODUCTION, report.writers())
        else:
            print(report.writers()[name](found), flush=True)
    if wish.rewrite:
        page.write(words.INTRODUCTION, report.writers())


def _measures(wish: Asked) -> dict[str, Callable[[], Any]]:
    from tests.benchmarks.stereo import befallen, clips, measuring, real

    known = clips.REPORTED if wish.report else clips.TUNED
    return {
        "tables": lambda: measuring.tables(known.of_scene, wish.clips),
        "goals": lambda: measuring.goals(known.of_scene, wish.clips),
        "peers": lambda: _peers(known, wish),
        "real": lambda: real.measure(wish.data),
        "lost": lambda: _lost(known, wish),
        "befallen": lambda: befallen.measure(known.dimmed, known.sound, wish.clips),
    }


def _peers(known: Any, wish: Asked) -> dict[str, Any]:
    from tests.benchmarks.stereo import peers
    from tests.benchmarks.tracker_peers import REPORTED_SEEDS
    from tests.benchmarks.tracker_peers.choosing import CHOOSING_SEEDS

    seeds = REPORTED_SEEDS if wish.report else CHOOSING_SEEDS[:1]
    return peers.measure(known.of_scene, seeds, wish.clips)


def _lost(known: Any, wish: Asked) -> dict[str, Any]:
    from tests.benchmarks.stereo import measuring, pictures

    people = measuring.not_kept_of(known.of_scene, wish.clips)
    return {"people": people, "shown": pictures.typical(people)}


def _picture(page: Any, found: dict[str, Any], wish: Asked) -> None:
    from tests.benchmarks.stereo import clips, pictures

    page.photograph("lost", pictures.strip(found["shown"], clips.REPORTED.folders(wish.clips)))


if __name__ == "__main__":
    main()
