"""Tables of people who walk where a test wants them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

Places = Sequence[tuple[float, float]]


def walk(places: Places, track: int = 1, first: int = 0) -> dict[str, NDArray[Any]]:
    """One person, a place a frame, with the foot of their box there too."""
    frames = range(first, first + len(places))
    return walk_at(list(zip(frames, places, strict=True)), track)


def walk_at(rows: Sequence[tuple[int, tuple[float, float]]], track: int = 1) -> dict[str, Any]:
    """One person, in some frames."""
    frame = np.array([frame for frame, _ in rows], np.int32)
    x, y = np.array([place for _, place in rows], np.float64).reshape(-1, 2).T
    size = {"width": np.full(len(x), 4.0), "height": np.full(len(x), 10.0)}
    box = {"left": x - 2.0, "top": y - 10.0, **size}
    return {"frame": frame, "track": np.full(len(x), track, np.int32), "x": x, "y": y, **box}


def together(*people: dict[str, NDArray[Any]]) -> dict[str, NDArray[Any]]:
    """Several people in one table, sorted by frame, then track."""
    columns = {name: np.concatenate([one[name] for one in people]) for name in people[0]}
    order = np.lexsort((columns["track"], columns["frame"]))
    return {name: column[order] for name, column in columns.items()}


def crowd(seed: int, people: int = 20, frames: int = 120) -> dict[str, NDArray[Any]]:
    """People who wander about a square of 5 m, 10 frames a second, none ever exactly on a line."""
    rng = np.random.default_rng(seed)
    walks = []
    for track in range(1, people + 1):
        first, count = int(rng.integers(0, frames // 3)), int(rng.integers(20, frames // 2))
        turning = np.cumsum(rng.normal(0, 0.25, count)) + rng.uniform(0, 2 * np.pi)
        steps = rng.uniform(0.05, 0.2) * np.column_stack((np.cos(turning), np.sin(turning)))
        places = rng.uniform(-2.5, 2.5, 2) + np.cumsum(steps, axis=0)
        walks.append(walk([(float(x), float(y)) for x, y in places], track, first))
    return together(*walks)
