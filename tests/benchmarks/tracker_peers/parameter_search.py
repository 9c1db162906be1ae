"""Settings of the trackers of others, chosen as well as we can.

`python -m tests.benchmarks.tracker_peers.parameter_search crossing`, or `rendered`. Ranges
(`ranges.json`) hold what documentation recommends and what the scene says (the noise is known to
whoever sets a filter). The setting kept so far and a number drawn at random are tried on seeds that
nothing is reported on, then all that differ from the best in one value, and so on; the best is
kept: IDF1 less a tenth of the identity switches a person. They are chosen for each kind of clip
apart, while ours keep one setting for all.
"""

from __future__ import annotations

import argparse
import json
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from tests.benchmarks.command import parser_of
from tests.benchmarks.tracker_peers.comparison import (
    CHOOSING_SEEDS,
    CHOSEN,
    Figures,
    chosen_settings,
    figures_of,
    given_to_peers,
)
from tests.benchmarks.tracker_peers.crossings import FRAMES, crossing_clip
from tests.benchmarks.tracker_peers.detections import SeenClip, rendered_clip
from tests.peers.followers import FOLLOWERS, Follower

RANGES: Mapping[str, Mapping[str, Sequence[Any]]] = json.loads(
    Path(__file__).with_name("ranges.json").read_text(encoding="utf-8")
)
"""What each setting is drawn from, by tracker; see the scripts beside `tests.peers.followers`."""


def worth(figures: Figures) -> float:
    """How good a setting is: identities kept, and few switches."""
    return figures.idf1 - 0.1 * figures.id_switches / max(figures.people, 1)


def drawn(tracker: str, count: int, random: np.random.Generator) -> list[dict[str, Any]]:
    """So many settings from a tracker's ranges."""
    return [
        {
            name: range_[int(random.integers(len(range_)))]
            for name, range_ in RANGES[tracker].items()
        }
        for _ in range(count)
    ]


def varied(best: Mapping[str, Any], tracker: str) -> list[dict[str, Any]]:
    """The setting with each single value changed to each other of its range."""
    return [
        {**best, name: value}
        for name, range_ in RANGES[tracker].items()
        for value in dict.fromkeys(range_)
        if value != best[name]
    ]


def chosen(
    follower: Follower,
    clips: Sequence[SeenClip],
    first: Sequence[Mapping[str, Any]],
    rounds: int,
) -> tuple[dict[str, Any], Figures]:
    """The best of the first settings, then, round by round, of those one value away from it."""
    given, settings = given_to_peers(clips), list(first)
    tried: list[tuple[Mapping[str, Any], Figures]] = []
    for _ in range(1 + rounds):
        told = [figures_of(clips, one) for one in follower.follow(given, settings)]
        tried += zip(settings, told, strict=True)
        best = max(tried, key=lambda one: worth(one[1]))
        known = [one for one, _ in tried]
        settings = [one for one in varied(best[0], follower.name) if one not in known]
    return dict(best[0]), best[1]


def main() -> None:
    """Choose for the trackers and clips that are named, and write the settings."""
    asked = _asked()
    with tempfile.TemporaryDirectory() as folder:
        clips = [rendered_clip(place) for place in asked.recordings] or [
            crossing_clip(Path(folder) / "crossing", seed, asked.frames) for seed in CHOOSING_SEEDS
        ]
    for follower in FOLLOWERS:
        if not asked.names or follower.name in asked.names:
            first = drawn(follower.name, asked.count, np.random.default_rng(CHOOSING_SEEDS[0]))
            start = chosen_settings(asked.kind)[follower.name]
            best, figures = chosen(follower, clips, [start, *first], asked.rounds)
            print(follower.name, figures, best, flush=True)
            _keep(asked.kind, follower.name, best)


def _asked() -> argparse.Namespace:
    parser = parser_of("tracker_peers.parameter_search", __doc__)
    parser.add_argument("kind", choices=("crossing", "rendered"))
    parser.add_argument("names", nargs="*", help="of the trackers; all if left out")
    parser.add_argument("--recordings", nargs="*", type=Path, default=[], help="rendered ones")
    parser.add_argument("--count", type=int, default=60, help="settings to draw")
    parser.add_argument("--rounds", type=int, default=2, help="of changes to the best one")
    parser.add_argument("--frames", type=int, default=FRAMES, help="of crossing walkers")
    return parser.parse_args()


def _keep(kind: str, tracker: str, settings: Mapping[str, Any]) -> None:
    kept = json.loads(CHOSEN.read_text(encoding="utf-8"))
    kept[kind][tracker] = settings
    CHOSEN.write_text(json.dumps(kept, indent=2) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
