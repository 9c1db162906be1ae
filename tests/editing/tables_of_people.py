"""Small tables to edit."""

from __future__ import annotations

import numpy as np

from tracking.tracks import CORRECTED_COLUMNS, TrackTable


def table_of(spans: dict[int, list[tuple[int, int]]], seed: int = 0) -> TrackTable:
    """Tracks standing in half-open ranges of frames, with random values that tell rows apart."""
    places = sorted(
        (frame, track)
        for track, ranges in spans.items()
        for start, end in ranges
        for frame in range(start, end)
    )
    return table_at(places, seed)


def table_at(places: list[tuple[int, int]], seed: int = 0) -> TrackTable:
    """Rows at sorted (frame, track)."""
    random = np.random.default_rng(seed)
    rows = {
        name: random.uniform(0, 100, len(places)).astype(dtype)
        for name, dtype in CORRECTED_COLUMNS.items()
    }
    rows["source"][:] = 0
    rows["x"][random.random(len(places)) < 0.2] = np.nan
    rows["frame"] = np.array([frame for frame, _ in places], np.int32)
    rows["track"] = np.array([track for _, track in places], np.int32)
    return TrackTable(rows)


def bytes_of(table: TrackTable) -> dict[str, bytes]:
    """The table bit for bit, to compare."""
    return {name: column.tobytes() for name, column in table.columns().items()}


def frames(table: TrackTable, track: int) -> list[int]:
    """Where a track stands."""
    return table.frames_of_track(track).tolist()
