"""How fast the review queue is after an edit: `python -m tests.benchmarks.review_speed`.

Walks that wander over a crowded floor, about eight pairs of people within reach of each other for
every ten rows: looked through as a whole, after one swap in the middle, and as a whole again, which
has to find the same.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tracking.editing import apply_change, plan_swap
from tracking.review import ReviewItem, ReviewItemFinder
from tracking.tracks import (
    ASSOCIATION_COLUMNS,
    CLOTHES,
    DETECTION_COLUMNS,
    PARTICLE_COLUMNS,
    SIGNAL_COLUMNS,
    TRACK_COLUMNS,
    Labels,
    Particles,
    Run,
    TrackTable,
    empty,
)

_FPS, _SIZE = 20.0, (640, 480)
_ROWS, _AT_ONCE, _SIDE_M = 1000, 50, 10.0
"""Rows of a track, people at a time, and the floor they walk on."""
_STATUS = Path("/proc/self/status")


def main() -> None:
    """Print a line for each look."""
    parser = argparse.ArgumentParser(
        prog="python -m tests.benchmarks.review_speed", description=__doc__
    )
    parser.add_argument("--tracks", type=int, default=1000, help="of 1000 rows each")
    run = wandering(parser.parse_args().tracks, np.random.default_rng(3103))
    table, lookout = TrackTable(run.tracks), ReviewItemFinder()
    _look("as a whole", lookout, table, run)
    one, other, frame = _together(table)
    apply_change(table, Labels(), plan_swap(table, one, other, frame))
    again = _look("after a swap", lookout, table, run)
    print("the same:", again == _look("as a whole again", ReviewItemFinder(), table, run))


def _look(
    name: str, lookout: ReviewItemFinder, table: TrackTable, run: Run
) -> tuple[ReviewItem, ...]:
    cpu, wall = time.process_time(), time.perf_counter()
    found = lookout.find(table.snapshot(), run, _FPS, size=_SIZE)
    cpu, wall = time.process_time() - cpu, time.perf_counter() - wall
    peak = next(line for line in _STATUS.read_text("ascii").splitlines() if "VmHWM" in line)
    said = f"{len(found)} review items in {wall:.2f} s, {cpu:.2f} s of one core"
    print(f"{name}: {len(table)} rows, {said}; most memory {int(peak.split()[1]) // 1024} MB")
    return found


def _together(table: TrackTable) -> tuple[int, int, int]:
    """The track in the middle, another one that is there half way, and that frame."""
    ids = table.track_ids
    one = ids[len(ids) // 2]
    frame = sum(table.frame_range(one)) // 2
    ranges = {track: table.frame_range(track) for track in ids if track != one}
    other = next(track for track, (s, e) in ranges.items() if s < frame - 50 and e > frame + 50)
    return one, other, frame


def wandering(tracks: int, random: np.random.Generator) -> Run:
    """A run of so many tracks with all that is noticed of their rows."""
    count = tracks * _ROWS
    start = np.sort(random.integers(0, max(1, count // _AT_ONCE - _ROWS), tracks))
    row = {
        "track": np.repeat(np.arange(1, tracks + 1), _ROWS),
        "frame": np.repeat(start, _ROWS) + np.tile(np.arange(_ROWS), tracks),
    }
    heading = np.cumsum(random.normal(0, 0.05, (tracks, _ROWS)), 1)
    heading += random.uniform(0, 2 * np.pi, (tracks, 1))
    step = np.stack((np.cos(heading), np.sin(heading)), -1) * 1.2 / _FPS
    way = random.uniform(0, _SIDE_M, (tracks, 1, 2)) + np.cumsum(step, 1)
    place = np.abs(way % (2 * _SIDE_M) - _SIDE_M).reshape(count, 2)
    x, y = (place + random.normal(0, 0.005, place.shape)).T
    row |= {"x": x, "y": y, "left": 50 * x + 60, "top": 30 * y + 20}
    row |= {"width": np.full(count, 40.0), "height": np.full(count, 120.0)}
    row |= {"visibility": np.ones(count), "predicted": random.random(count) < 0.02}
    own = np.repeat(random.normal(0, 20, (tracks, len(CLOTHES))), _ROWS, 0)
    row |= dict(zip(CLOTHES, (own + random.normal(0, 1, own.shape)).T, strict=True))
    row |= {"height_m": random.normal(1.7, 0.01, count), "split": 0.3 * random.random(count)}
    row |= {"spread_m": random.gamma(4, 0.03, count)}
    close = random.random(count) < 0.1
    row["margin"] = np.where(close, random.gamma(2, 0.3, count), np.nan)
    order = np.lexsort((row["track"], row["frame"]))
    stop = int(row["frame"].max()) + 1
    return Run(
        tracker="made up",
        settings={},
        seed=0,
        frames=(0, stop),
        tracks=_columns(row, order, TRACK_COLUMNS),
        detections=empty(DETECTION_COLUMNS),
        particles=Particles(np.zeros(stop + 1, np.int64), empty(PARTICLE_COLUMNS)),
        associations=_columns(row, order, ASSOCIATION_COLUMNS),
        signals=_columns(row, order, SIGNAL_COLUMNS),
    )


def _columns(
    row: Mapping[str, NDArray[np.generic]],
    order: NDArray[np.int64],
    types: Mapping[str, np.dtype[np.generic]],
) -> dict[str, NDArray[np.generic]]:
    """Some columns in order; 0 where nothing is known."""
    nothing = np.zeros(len(order))
    return {name: row.get(name, nothing)[order].astype(kind) for name, kind in types.items()}


if __name__ == "__main__":
    main()
