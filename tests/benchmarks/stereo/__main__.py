"""Stereo trackers: `python -m tests.benchmarks.stereo [--report] [--only SECTION ...]`.

Only with --report fresh clips are looked at: goals and trackers are measured on them.
"""

from __future__ import annotations

from typing import Any

from tests.benchmarks.clips import folder_of
from tests.benchmarks.intervals import interval, same_share
from tests.benchmarks.pages import Figures, Page
from tests.benchmarks.stereo import clips, measures
from tests.benchmarks.tracker_peers.comparison import (
    CHOOSING_SEEDS,
    RADIUS_M,
    REPORTED_SEEDS,
    compared,
    compared_on,
)
from tests.benchmarks.tracker_peers.detections import rendered_clip

PAPER = {
    "indoor": (87.5, 92.5, "", ""),
    "outdoor": (81.5, 88, "", ""),
    "lobby": ("", 88, 90, ""),
    "plaza": ("", 88, 94, ""),
    "square": ("", 86, 92, ""),
}
"""[Kawashita2012] and [Kawashita2014] in per cent, beside each of our columns: distance; with
colour; with direction; none beside our own tracker."""
ACCURACY_GOALS = {"lobby": 0.97, "plaza": 0.98, "square": 0.97, "uniforms": 0.92, "pillars": 0.90}
_BESIDE_OTHERS = ("stereo-joint", "stereo-direction")
_SCENES_BESIDE_OTHERS = ("lobby", "plaza", "square")


def _often(report: bool) -> clips.OfScene:
    return clips.REPORTED if report else clips.TUNED


def _goals(report: bool) -> dict[str, Any]:
    """Of clips nobody has looked at, and of those that are measured after each change."""
    fresh = clips.FRESH if report else {}
    return {
        "fresh": measures.goals(fresh),
        "often": measures.goals(_often(report)),
    }


def _peers(report: bool) -> dict[str, Any]:
    """Everybody over crossing walkers, and over one clip each of some scenes."""
    seeds = REPORTED_SEEDS if report else CHOOSING_SEEDS[:1]
    chosen = [_often(report)[scene][0] for scene in _SCENES_BESIDE_OTHERS]
    seen = [rendered_clip(folder_of(clip)) for clip in chosen]
    return {
        "crossing": compared(seeds, _BESIDE_OTHERS),
        "rendered": compared_on(seen, "rendered", _BESIDE_OTHERS),
        "clips": [clip.name for clip in chosen],
    }


def people(rows: Figures) -> tuple[int, int]:
    """How many of all scenes are kept, and how many are detected."""
    kept, of = (
        sum(row[name] for row in rows.values()) for name in ("people_kept", "people_detected")
    )
    return kept, of


# As they are measured: runs of `tables` and `trackers` serve `goals`; programs of others come last,
# as they may fail.
PAGE = Page(
    subject="stereo",
    about=__doc__ or "",
    measures={
        "tables": lambda report: measures.tables(_often(report)),
        "trackers": lambda report: measures.trackers(clips.FRESH if report else clips.TUNED),
        "goals": _goals,
        "robustness": lambda report: measures.robustness(_often(report)),
        "peers": _peers,
    },
    words={
        "clips": clips,
        "floor_m": measures.FLOOR_M,
        "paper": PAPER,
        "accuracy_goals": ACCURACY_GOALS,
        "people": people,
        "same_share": same_share,
        "wilson": interval,
        "radius_m": RADIUS_M,
    },
)

if __name__ == "__main__":
    PAGE.main()
