"""Small tables of tracks written by hand or by arithmetic."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from tracking.scoring import ScoringTable

Row = tuple[int, int, float, float]
"""Frame, track, x and y of a person."""


def table(rows: Iterable[Row], dont_cares: Iterable[tuple[int, int]] = ()) -> ScoringTable:
    """People as boxes of 10 x 20 pixels whose corner is at ten times their place in metres."""
    rows = sorted(rows)
    ignored = set(dont_cares)
    places = np.array([row[2:] for row in rows], np.float64).reshape(-1, 2)
    return ScoringTable.from_columns(
        {
            "frame": np.array([row[0] for row in rows], np.int32),
            "track": np.array([row[1] for row in rows], np.int32),
            "left": places[:, 0] * 10,
            "top": places[:, 1] * 10,
            "width": np.full(len(rows), 10.0),
            "height": np.full(len(rows), 20.0),
            "x": places[:, 0],
            "y": places[:, 1],
            "confidence": np.array([float((row[0], row[1]) not in ignored) for row in rows]),
        },
        dont_cares=True,
    )


def standing(track: int, frames: Iterable[int], x: float = 0.0, y: float = 0.0) -> list[Row]:
    """One person who stands at a place."""
    return [(frame, track, x, y) for frame in frames]


def pseudo_random(seed: int, people: int, frames: int) -> tuple[ScoringTable, ScoringTable]:
    """Walkers and a bad tracker's result, from arithmetic that is the same everywhere.

    Every value is a whole or a half number, so that equal similarities and overlaps exactly on
    the thresholds occur.
    """
    state = seed

    def draw(below: int) -> int:
        nonlocal state
        state = (1103515245 * state + 12345) % 2**31
        return (state >> 16) % below

    truth: dict[tuple[int, int], tuple[float, ...]] = {}
    result: dict[tuple[int, int], tuple[float, ...]] = {}
    for frame in range(frames):
        for person in range(1, people + 1):
            step = frame if person % 2 else -frame
            box = (20.0 * person + step, 40.0 + draw(5), 30.0 + draw(4), 60.0 + draw(4))
            if draw(6):
                truth[frame, person] = (*box, float(draw(8) > 0))
            if draw(5):
                track = person if draw(9) else 1 + draw(people + 3)
                shifted = tuple(value + draw(17) / 2 - 4 for value in box[:2])
                result[frame, track] = (*shifted, box[2] + draw(6), box[3], 1.0)
            if not draw(7):
                result[frame, 50 + draw(4)] = (draw(150), 40.0, 30.0, 60.0, 1.0)
    return _boxes(truth), _boxes(result)


def _boxes(rows: dict[tuple[int, int], tuple[float, ...]]) -> ScoringTable:
    keys = sorted(rows)
    values = np.array([rows[key] for key in keys], np.float64).reshape(-1, 5)
    names = ("left", "top", "width", "height", "confidence")
    return ScoringTable.from_columns(
        {
            "frame": np.array([key[0] for key in keys], np.int32),
            "track": np.array([key[1] for key in keys], np.int32),
            **dict(zip(names, values.T, strict=True)),
        },
        dont_cares=True,
    )
