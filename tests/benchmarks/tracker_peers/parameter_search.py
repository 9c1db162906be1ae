"""Settings of the trackers of others, chosen as well as we can: `python -m ...choosing`.

Ranges hold what documentation recommends and what the scene says (the noise is known to whoever
sets a filter). The setting kept so far and a number drawn at random are tried on seeds that nothing
is reported on, then all that differ from the best in one value, and so on; the best is kept: IDF1
less a tenth of the identity switches a person. They are chosen for each kind of clip apart, while
ours keep one setting for all.
"""

from __future__ import annotations

import argparse
import json
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from tests.benchmarks.tracker_peers.clips import Clip
from tests.benchmarks.tracker_peers.comparison import CHOSEN, chosen_settings
from tests.benchmarks.tracker_peers.crossings import FRAMES, crossing_clip
from tests.benchmarks.tracker_peers.rendered_clips import rendered_clip
from tests.benchmarks.tracker_peers.rows import Figures, figures_of
from tests.peers.followers import FOLLOWERS, Follower

CHOOSING_SEEDS = (6001, 6002, 6003)

Range = Sequence[Any]

_MERGED: Mapping[str, Range] = {"with_merged": (True, False)}
_NOISE: Mapping[str, Range] = {"noise_m": (0.04, 0.06, 0.09, 0.15)}
_BOXED: Mapping[str, Range] = _MERGED | {
    "lost_s": (0.3, 0.5, 1.0, 1.5, 2.0, 3.0),
    "minimum_consecutive_frames": (1, 2, 3, 5),
    "minimum_iou": (0.001, 0.02, 0.05, 0.1, 0.2, 0.3),
    "state": ("corners", "centre"),
    "overlap": ("iou", "giou", "diou"),
    "boxes": ("floor", "floor", "picture"),
    "px_per_m": (3, 5, 10, 20, 50, 100),
    "size_m": (0.5, 0.7, 1.0, 1.4, 2.0),
}
_FILTERED: Mapping[str, Range] = (
    _MERGED
    | _NOISE
    | {
        "drift": (0.05, 0.1, 0.2, 0.5, 1.0, 2.0),
        "gate": (2.5, 3.0, 3.5, 4.0, 5.0, 6.0),
        "unsure_m": (0.4, 0.7, 1.0, 2.0),
        "speed_m_s": (0.8, 1.2, 2.0),
        "held_s": (0.1, 0.2, 0.5),
        "lost_s": (0.3, 0.5, 1.0, 1.5, 2.0, 3.0),
        "told_s": (0.0, 0.3, 0.6, 1.0),
        "min_points": (2, 3, 4, 6),
    }
)

RANGES: Mapping[str, Mapping[str, Range]] = {
    "norfair": _MERGED
    | _NOISE
    | {
        "distance_threshold_m": (0.3, 0.4, 0.5, 0.6, 0.8, 1.0),
        "hit_counter_max": (8, 15, 20, 30, 45),
        "initialization_delay": (1, 2, 3, 5),
        "process_m": (0.001, 0.003, 0.005, 0.01, 0.02, 0.04),
        "speed_m_s": (0.4, 0.8, 1.2, 2.0),
        "told_frames": (0, 5, 10, 20, 45),
    },
    "motpy": _MERGED
    | _NOISE
    | {
        "acceleration_m_s2": (0.5, 1.0, 2.0, 4.0, 8.0),
        "start": (0.1, 0.5, 1.0, 2.0),
        "min_iou": (0.001, 0.02, 0.05, 0.1, 0.2, 0.3),
        "max_staleness": (6, 12, 20, 30, 45),
        "min_steps_alive": (2, 3, 5),
        "told_staleness": (1, 3, 6, 12, 20, 45),
        "staleness_to_positive": (0.3, 1.0, 3.0),
        "size_m": (0.5, 0.7, 1.0, 1.4, 2.0),
    },
    "SORT": _BOXED,
    "ByteTrack": _BOXED,
    "OC-SORT": _BOXED
    | {"direction_consistency_weight": (0.0, 0.1, 0.2, 0.4), "delta_t": (1, 3, 6, 12)},
    "Stone Soup GNN": _FILTERED,
    "Stone Soup JPDA": _FILTERED
    | {
        "clutter_per_m2": (0.0005, 0.002, 0.01, 0.05),
        "detected": (0.8, 0.9, 0.95),
        "inside_gate": (0.95, 0.99, 0.999),
    },
}
"""What each setting is drawn from; see the scripts beside `tests.peers.followers`."""


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
    clips: Sequence[Clip],
    first: Sequence[Mapping[str, Any]],
    rounds: int,
) -> tuple[dict[str, Any], Figures]:
    """The best of the first settings, then, round by round, of those one value away from it."""
    given = {clip.name: (len(clip.observations), clip.fps, clip.seen) for clip in clips}
    settings = list(first)
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
    parser = argparse.ArgumentParser(
        prog="python -m tests.benchmarks.tracker_peers.parameter_search"
    )
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
