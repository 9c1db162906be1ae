"""How long it takes to tell what is protected: `python -m tests.benchmarks.protection`.

Logs of mixed edits (swaps from a frame on and in a range, moved boxes, deletions, names) of 50
tracks in 4,000 frames: read for the first time, as after opening a session, and then again.
"""

from __future__ import annotations

import argparse
import time

import numpy as np

from tracking.editing import (
    Change,
    History,
    find_protected,
    plan_delete,
    plan_move_box,
    plan_rename,
    plan_swap,
)
from tracking.tracks import TRACK_COLUMNS, Labels, TrackTable

_TRACKS, _FRAMES = 50, 4000
_SEED = 3105


def main() -> None:
    """Print a line for each length of log."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.protection")
    parser.add_argument("--edits", nargs="+", type=int, default=[5000, 20_000])
    asked = parser.parse_args()
    table = table_of_many()
    for count in asked.edits:
        entries = log_of(table, count).entries
        history = History(entries)
        figures = [measured(table, history) for _ in range(4)]
        print(f"{count:>7} edits: first {figures[0]:6.0f} ms, then {min(figures[1:]):5.0f} ms")


def table_of_many() -> TrackTable:
    """People who stand in every frame."""
    rows = {name: np.zeros(_TRACKS * _FRAMES, dtype) for name, dtype in TRACK_COLUMNS.items()}
    rows["frame"][:] = np.repeat(np.arange(_FRAMES), _TRACKS)
    rows["track"][:] = np.tile(np.arange(1, _TRACKS + 1), _FRAMES)
    rows["x"][:], rows["width"][:], rows["height"][:] = rows["track"], 30.0, 60.0
    return TrackTable(rows)


def log_of(table: TrackTable, count: int) -> History:
    """A log of so many edits, each planned on the same table: it is not changed by them."""
    random, history = np.random.default_rng(_SEED), History()
    for number in range(count):
        change = _planned(table, random, number)
        history.add(history.draft(change, "2031-01-01T00:00:00.000Z", "benchmark"), change)
    return history


def _planned(table: TrackTable, random: np.random.Generator, number: int) -> Change:
    one, other = random.choice(_TRACKS, 2, replace=False).tolist()
    start, chance = int(random.integers(1, _FRAMES - 200)), random.random()
    if chance < 0.2:
        return plan_swap(table, one + 1, other + 1, start)
    if chance < 0.4:
        return plan_swap(table, one + 1, other + 1, start, start + int(random.integers(5, 200)))
    if chance < 0.75:
        return plan_move_box(table, one + 1, start, (1.0, 2.0, 30.0, 60.0))
    if chance < 0.8:
        return plan_delete(table, one + 1, start, start + int(random.integers(1, 20)))
    return plan_rename(table, Labels(), one + 1, f"person {number}")


def measured(table: TrackTable, history: History) -> float:
    """Milliseconds of this process, whatever else the machine does."""
    began_s = time.process_time()
    find_protected(table, Labels(), history, fps=20.0)
    return 1000.0 * (time.process_time() - began_s)


if __name__ == "__main__":
    main()
