"""Stereo trackers: `python -m tests.benchmarks.stereo [--report] [--only SECTION ...]`.

Without --report: the figures on the clips for choosing settings, printed as the page would have
them; fresh clips are left alone. With it: on the clips reported, goals and trackers on fresh ones,
kept one by one in docs/results/stereo.json, and the page made of them. --rewrite only makes the
page anew. Clips are kept in the user's cache, or where --clips says; clips that are there are taken
as they are.
"""

from __future__ import annotations

from typing import Any

from tests.benchmarks.clips import folder_of
from tests.benchmarks.command import Options
from tests.benchmarks.intervals import interval
from tests.benchmarks.pages import Figures, Page, Picture
from tests.benchmarks.stereo import clips, goals, measures, papers, peers
from tests.benchmarks.stereo.loss_context import WHERE
from tests.benchmarks.stereo.pictures import strip, typical
from tests.benchmarks.stereo.reasons import WHAT
from tests.benchmarks.tracker_peers.comparison import CHOOSING_SEEDS, RADIUS_M, REPORTED_SEEDS


def _often(options: Options) -> clips.OfScene:
    return clips.REPORTED if options.report else clips.TUNED


def _goals(options: Options) -> dict[str, Any]:
    """Of clips nobody has looked at, and of those that are measured after each change."""
    fresh = clips.FRESH if options.report else {}
    return {
        "fresh": measures.goals(fresh, options.clips),
        "often": measures.goals(_often(options), options.clips),
    }


def _peers(options: Options) -> dict[str, Any]:
    seeds = REPORTED_SEEDS if options.report else CHOOSING_SEEDS[:1]
    return peers.measure(_often(options), seeds, options.clips)


def _lost(options: Options) -> dict[str, Any]:
    people = measures.lost(_often(options), options.clips)
    return {"people": people, "shown": typical(people)}


def _picture(lost: Figures, options: Options) -> Picture | None:
    known = [clip for several in clips.REPORTED.values() for clip in several]
    folders = {clip.name: folder_of(clip, options.clips) for clip in known}
    return strip(lost["shown"], folders) if lost["shown"] else None


# As they are measured: runs of `tables` and `trackers` serve `goals`; programs of others come last,
# as they may fail.
PAGE = Page(
    subject="stereo",
    about=__doc__ or "",
    measures={
        "tables": lambda asked: measures.tables(_often(asked), asked.clips),
        "trackers": lambda asked: measures.trackers(
            clips.FRESH if asked.report else clips.TUNED, asked.clips
        ),
        "goals": _goals,
        "real": lambda asked: measures.real_footage(asked.data),
        "lost": _lost,
        "robustness": lambda asked: measures.robustness(_often(asked), asked.clips),
        "peers": _peers,
    },
    words={
        "clips": clips,
        "figured": measures,
        "judged": goals,
        "papers": papers,
        "beside": peers,
        "kinds": {"what": WHAT, "where": WHERE},
        "wilson": interval,
        "radius_m": RADIUS_M,
    },
    pictures={"lost": ("lost", _picture)},
)

if __name__ == "__main__":
    PAGE.main()
