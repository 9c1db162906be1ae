"""The tracks of a session as the views ask for them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from app.presenters.shown import Spans, joined
from tracking.tracks import (
    DETECTION_COLUMNS,
    PARTICLE_COLUMNS,
    TRACK_COLUMNS,
    Columns,
    Run,
    TrackTable,
    empty,
)


class SessionTracks:
    """The corrected tracks of a session, with the measurements and particles of a run."""

    def __init__(self, table: TrackTable, run: Run | None) -> None:
        self._table = table
        self._run = run
        self._stop = (-1, 0)  # revision of the table, one past its last frame
        self._recent: tuple[tuple[int, int, int], Columns] = ((-1, 0, 0), empty(TRACK_COLUMNS))

    @property
    def frames(self) -> tuple[int, int]:
        """The frames the run went through; without a run, all that have rows."""
        if self._run is not None:
            return self._run.frames
        if self._stop[0] != self._table.revision:
            self._stop = (self._table.revision, self._table.frame_stop)
        return 0, self._stop[1]

    @property
    def ids(self) -> Sequence[int]:
        """All tracks."""
        return self._table.track_ids

    def of_frame(self, frame: int) -> Columns:
        """The frame's rows."""
        return self._table.of_frame(frame)

    def recent(self, frame: int, back: int) -> Columns:
        """The rows of the frame's people, from `back` frames before it.

        All views ask for the same ones one after the other: they are kept until others are asked.
        """
        asked = (self._table.revision, frame, back)
        if self._recent[0] != asked:
            here = self._table.of_frame(frame)["track"].tolist()
            start = max(0, frame - back)
            rows = [self._table.of_track(track, start, frame + 1) for track in here]
            self._recent = (asked, joined(rows))
        return self._recent[1]

    def of_track(self, track: int) -> Columns:
        """The rows of a track."""
        return self._table.of_track(track)

    def detections(self, frame: int) -> Columns:
        """What the run measured in the frame."""
        if self._run is None:
            return empty(DETECTION_COLUMNS)
        columns = self._run.detections
        low, high = np.searchsorted(columns["frame"], (frame, frame + 1))
        return {name: column[low:high] for name, column in columns.items()}

    def particles(self, frame: int) -> Columns:
        """The run's particles, coloured by the corrected ids where a swap changed them.

        A run never changes; an edit moves a person's rows to another id, and the particles of
        that person go with them.
        """
        if self._run is None:
            return empty(PARTICLE_COLUMNS)
        particles = self._run.particles.of_frame(frame)
        return _renamed(particles, self._run.tracks, self._table.of_frame(frame), frame)

    def spans(self) -> dict[int, Spans]:
        """The stretches of every track."""
        return spans_of(self._table.columns())

    def activity(self, frame_count: int) -> NDArray[np.uint16]:
        """People per frame."""
        return self._table.activity(frame_count)


def spans_of(rows: Columns) -> dict[int, Spans]:
    """The stretches of every track in a table: consecutive frames that are alike predicted."""
    if not len(rows["frame"]):
        return {}
    order = np.lexsort((rows["frame"], rows["track"]))
    track, frame, lost = (rows[name][order] for name in ("track", "frame", "predicted"))
    begins = np.ones(len(order), bool)
    begins[1:] = (np.diff(track) != 0) | (np.diff(frame) != 1) | (lost[1:] != lost[:-1])
    first = np.flatnonzero(begins)
    last = np.append(first[1:], len(order)) - 1
    spans = np.column_stack((frame[first], frame[last] + 1, lost[first])).astype(np.int64)
    ids, starts = np.unique(track[first], return_index=True)
    parts = np.split(spans, starts[1:])
    return {int(one): part for one, part in zip(ids, parts, strict=True)}


def _renamed(
    particles: dict[str, NDArray[Any]], made: Columns, corrected: Columns, frame: int
) -> Columns:
    """The particles with the ids that the same rows (by box and place) have after the edits."""
    low, high = np.searchsorted(made["frame"], (frame, frame + 1))
    names = ("left", "top", "width", "height")
    before = np.column_stack([made[name][low:high] for name in names])
    after = np.column_stack([corrected[name] for name in names])
    if not len(before) or not len(after):
        return particles
    alike = np.isclose(before[:, None, :], after[None, :, :], atol=1e-6).all(axis=2)
    ids = particles["track"].copy()
    for row, track in enumerate(made["track"][low:high].tolist()):
        same = np.flatnonzero(alike[row])
        if len(same):
            ids[particles["track"] == track] = corrected["track"][same[0]]
    return {**particles, "track": ids}
