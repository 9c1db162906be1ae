"""Stereo trackers: `python -m tests.benchmarks.stereo [--report] [--only SECTION ...]`.

Without --report: the figures on the clips for choosing settings, printed as the page would have
them; fresh clips are left alone. With it: on the clips reported, goals and trackers on fresh ones,
kept one by one in docs/results/stereo.json, and the page made of them. --rewrite only makes the
page anew. Clips and runs are kept in the temporary folder, or where --clips says; clips that are
there are taken as they are.
"""

from __future__ import annotations

from typing import Any

from tests.benchmarks.options import Asked
from tests.benchmarks.results import Contents, run

SECTIONS = ("tables", "trackers", "goals", "real", "lost", "robustness", "peers")
"""As they are measured: runs of `tables` and `trackers` serve `goals`; programs of others come
last, as they may fail."""


def _contents(wish: Asked) -> Contents:
    from tests.benchmarks.stereo import (
        choice,
        clip_scores,
        clips,
        pictures,
        real,
        report,
        robustness,
        trackers,
        words,
    )

    known = clips.REPORTED if wish.report else clips.TUNED
    fresh = clips.FRESH.of_scene if wish.report else {}

    def picture(found: dict[str, Any]) -> Any:
        shown = found["shown"]
        return pictures.strip(shown, clips.REPORTED.folders(wish.clips)) if shown else None

    return Contents(
        words.INTRODUCTION,
        report.writers(),
        {
            "tables": lambda: clip_scores.tables(known.of_scene, wish.clips),
            "trackers": lambda: choice.measure(fresh or known.of_scene, wish.clips),
            "goals": lambda: clip_scores.both(fresh, known.of_scene, wish.clips),
            "peers": lambda: _peers(known, wish),
            "real": lambda: real.measure(wish.data),
            "lost": lambda: _lost(known, wish),
            "robustness": lambda: robustness.measure(known.dimmed, known.sound, wish.clips),
        },
        photographs={"lost": picture},
        state=lambda: trackers.sources()[:16],
    )


def _peers(known: Any, wish: Asked) -> dict[str, Any]:
    from tests.benchmarks.stereo import peers
    from tests.benchmarks.tracker_peers import REPORTED_SEEDS
    from tests.benchmarks.tracker_peers.parameter_search import CHOOSING_SEEDS

    seeds = REPORTED_SEEDS if wish.report else CHOOSING_SEEDS[:1]
    return peers.measure(known.of_scene, seeds, wish.clips)


def _lost(known: Any, wish: Asked) -> dict[str, Any]:
    from tests.benchmarks.stereo import clip_scores, pictures

    people = clip_scores.not_kept_of(known.of_scene, wish.clips)
    return {"people": people, "shown": pictures.typical(people)}


if __name__ == "__main__":
    run("stereo", __doc__ or "", SECTIONS, _contents)
