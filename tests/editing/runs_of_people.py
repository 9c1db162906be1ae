"""People walking on a floor as tables and runs, each row where its person is."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracking.editing import Change, History, apply_change
from tracking.tracks import (
    CORRECTED_COLUMNS,
    TRACK_COLUMNS,
    Labels,
    Particles,
    Run,
    TrackTable,
)

FPS = 20.0
Walk = tuple[int, int, int, float]
"""Id, first frame, one past the last, and the lane: where the person walks, in metres."""


def rows_of(walks: Sequence[Walk]) -> dict[str, NDArray[Any]]:
    """`TRACK_COLUMNS` of people who walk along lanes a metre apart; the lane is the person."""
    places = sorted(
        (frame, track, lane) for track, start, end, lane in walks for frame in range(start, end)
    )
    frame, track, lane = (np.array(column) for column in zip(*places, strict=True))
    rows = {name: np.zeros(len(frame), dtype) for name, dtype in TRACK_COLUMNS.items()}
    rows["frame"][:], rows["track"][:] = frame, track
    rows["x"][:], rows["y"][:] = lane, 5.0 + 0.05 * frame
    rows["left"][:], rows["top"][:] = 100 * rows["x"], 10 * rows["y"]
    rows["width"][:], rows["height"][:] = 40.0, 90.0
    rows["confidence"][:] = rows["visibility"][:] = 1.0
    return rows


def table_of(walks: Sequence[Walk], highest: int = 0) -> TrackTable:
    """A corrected table that nobody has touched yet."""
    return TrackTable(rows_of(walks), highest_track=highest)


def run_of(
    walks: Sequence[Walk], frames: tuple[int, int], known: int = 0, tracks: Any = None
) -> Run:
    """What a tracker found; known: up to which id it went on from the corrected tracks."""
    none = Particles(np.zeros(1, np.int64), {})
    found: Mapping[str, NDArray[Any]] = rows_of(walks) if tracks is None else tracks
    return Run("stereo-direction", {}, 0, frames, found, {}, none, known_tracks=known)


def done(table: TrackTable, labels: Labels, history: History, change: Change) -> Labels:
    """Make an edit as a session does."""
    entry = history.draft(change, "2031-01-01T00:00:00.000Z", "somebody")
    labels = apply_change(table, labels, change)
    history.add(entry)
    return labels


def places(table: TrackTable, track: int) -> list[tuple[int, float]]:
    """Frame and lane of a track's rows."""
    rows = table.of_track(track)
    return list(zip(rows["frame"].tolist(), rows["x"].tolist(), strict=True))


def bits(rows: Mapping[str, NDArray[Any]]) -> dict[str, bytes]:
    """Rows to compare bit for bit."""
    return {name: rows[name].tobytes() for name in CORRECTED_COLUMNS}
