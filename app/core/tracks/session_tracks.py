"""The tracks of a session as the views ask for them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from app.core.scenes import SpanKind
from app.core.tracks.track_reader import Spans
from tracking.errors import SessionError
from tracking.session import ids_by_now, parts_by_now
from tracking.tracks import (
    DETECTION_COLUMNS,
    NETWORK_BOX_COLUMNS,
    PART_COLUMNS,
    PART_PARTICLE_COLUMNS,
    PARTICLE_COLUMNS,
    SIGNAL_COLUMNS,
    TRACK_COLUMNS,
    TRACKLET_COLUMNS,
    Columns,
    Particles,
    Run,
    Source,
    TrackTable,
    between,
    empty,
)


class SessionTracks:
    """The corrected tracks of a session, with the measurements and particles of a run.

    Attributes:
        unread: why particles of the run could not be read from the session's file last: its disk
            has gone, say. None: they could. Those frames show everything else.
    """

    def __init__(self, table: TrackTable, run: Run | None) -> None:
        self._table = table
        self._run = run
        self.unread: SessionError | None = None
        self._stop = (-1, 0)  # revision of the table, one past its last frame
        self._recent: tuple[tuple[int, int, int], Columns] = ((-1, 0, 0), empty(TRACK_COLUMNS))
        self._whole: tuple[tuple[int, int], Columns] = ((-1, 0), empty(TRACK_COLUMNS))
        self._parts: tuple[tuple[int, int], Columns] = ((-1, 0), empty(PART_COLUMNS))
        self._ids: tuple[tuple[int, int], dict[int, int]] = ((-1, 0), {})

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
            rows = self._table.of_tracks(here, start, frame + 1)
            self._recent = (asked, {name: rows[name] for name in TRACK_COLUMNS})
        return self._recent[1]

    def of_track(self, track: int) -> Columns:
        """The rows of a track, kept until another's are asked for: the card asks at every step."""
        asked = (self._table.revision, track)
        if self._whole[0] != asked:
            self._whole = (asked, self._table.of_track(track))
        return self._whole[1]

    def detections(self, frame: int) -> Columns:
        """What the run measured in the frame, less that of people who were taken out."""
        if self._run is None:
            return empty(DETECTION_COLUMNS)
        rows = rows_of_frame(self._run.detections, frame)
        unmatched = rows["track"] == 0
        ids = _renamed(rows["track"], self._after_edits(frame))
        kept = unmatched | (ids >= 0)
        named = {**rows, "track": np.where(unmatched, 0, ids).astype(np.int32)}
        return {name: column[kept] for name, column in named.items()}

    def particles(self, frame: int) -> Columns:
        """The run's particles with the ids their people have after the edits.

        A run never changes; an edit moves a person's rows to another id, and the particles of
        that person go with them. Those of people without a row in the frame are left out.
        """
        if self._run is None:
            return empty(PARTICLE_COLUMNS)
        return self._owned(self._stored(self._run.particles, PARTICLE_COLUMNS, frame), frame)

    def parts(self, frame: int) -> Columns:
        """What the run saw of the parts of people who are there, by their ids after the edits."""
        if self._run is None or not len(self._run.parts["frame"]):
            return empty(PART_COLUMNS)
        return self._owned(rows_of_frame(self._run.parts, frame), frame)

    def part_particles(self, frame: int) -> Columns:
        """The run's particles of parts, likewise."""
        if self._run is None:
            return empty(PART_PARTICLE_COLUMNS)
        rows = self._stored(self._run.part_particles, PART_PARTICLE_COLUMNS, frame)
        return self._owned(rows, frame)

    def tracklets(self, frame: int) -> Columns:
        """The run's tracklets, those of people who were taken out being nobody's."""
        if self._run is None:
            return empty(TRACKLET_COLUMNS)
        rows = self._stored(self._run.tracklets, TRACKLET_COLUMNS, frame)
        ids = _renamed(rows["track"], self._after_edits(frame))
        return {**rows, "track": np.maximum(ids, 0)}

    def network_boxes(self, frame: int) -> Columns:
        """What the network of the run found, as it was, whatever was edited."""
        if self._run is None:
            return empty(NETWORK_BOX_COLUMNS)
        return self._stored(self._run.network_boxes, NETWORK_BOX_COLUMNS, frame)

    def signals(self, frame: int) -> Columns:
        """What the run noticed of people who are there, by their ids after the edits."""
        if self._run is None or not len(self._run.signals["frame"]):
            return empty(SIGNAL_COLUMNS)
        return self._owned(rows_of_frame(self._run.signals, frame), frame)

    def parts_of_track(self, track: int) -> Columns:
        """The parts of a track, kept until another's are asked for."""
        if self._run is None or not len(self._run.parts["frame"]):
            return empty(PART_COLUMNS)
        asked = (self._table.revision, track)
        if self._parts[0] != asked:
            self._parts = (asked, parts_by_now(self._table, self._run, [track]))
        return self._parts[1]

    def _stored(
        self, particles: Particles, columns: Mapping[str, np.dtype[Any]], frame: int
    ) -> Columns:
        """The rows of a frame, read from the session's file; none where that cannot be read."""
        try:
            rows = particles.of_frame(frame)
        except SessionError as error:
            self.unread = error
            return empty(columns)
        self.unread = None
        return rows

    def _owned(self, rows: Columns, frame: int) -> Columns:
        """Rows of a frame of the run with the ids of now, less those of who was taken out."""
        ids = _renamed(rows["track"], self._after_edits(frame))
        kept = ids >= 0
        return {name: column[kept] for name, column in {**rows, "track": ids}.items()}

    def _after_edits(self, frame: int) -> dict[int, int]:
        """The ids of the run's tracks in a frame by now; several views ask one after the other."""
        if self._run is None:
            return {}
        asked = (self._table.revision, frame)
        if self._ids[0] != asked:
            self._ids = (asked, ids_by_now(self._table, self._run, frame))
        return self._ids[1]

    def spans(self, tracks: Iterable[int] | None = None) -> dict[int, Spans]:
        """The stretches of every track, or of some."""
        rows = self._rows_by_track(tracks)
        kind = rows["predicted"].astype(np.int64)
        kind[rows["source"] == Source.INTERPOLATED] = SpanKind.INTERPOLATED
        return spans_of(rows["track"], rows["frame"], kind)

    def keyframes(self, tracks: Iterable[int] | None = None) -> dict[int, NDArray[np.int64]]:
        """The frames whose row a person made."""
        rows = self._rows_by_track(tracks)
        made = rows["source"] == Source.PERSON
        return _grouped(rows["track"][made], rows["frame"][made].astype(np.int64))

    def _rows_by_track(self, tracks: Iterable[int] | None) -> Columns:
        """What lanes are made of, by track, then frame; nothing else is read."""
        return self._table.by_track(("track", "frame", "predicted", "source"), tracks)

    def activity(self, frame_count: int) -> NDArray[np.uint16]:
        """People per frame."""
        return self._table.activity(frame_count)

    def capture(self, names: Sequence[str]) -> Callable[[], Columns]:
        """Takes hold of all rows; they are read by track, then frame."""
        table = self._table.snapshot()
        return lambda: table.by_track(names)


def spans_of(
    track: NDArray[np.int32], frame: NDArray[np.int32], kind: NDArray[np.int64]
) -> dict[int, Spans]:
    """The stretches of every track: consecutive frames of one kind.

    The rows stand by track, then frame.
    """
    if not len(frame):
        return {}
    begins = np.ones(len(frame), bool)
    begins[1:] = (track[1:] != track[:-1]) | (frame[1:] != frame[:-1] + 1) | (kind[1:] != kind[:-1])
    first = np.flatnonzero(begins)
    last = np.append(first[1:], len(frame)) - 1
    spans = np.column_stack((frame[first], frame[last].astype(np.int64) + 1, kind[first]))
    return _grouped(track[first], spans)


def _grouped(track: NDArray[np.int32], values: NDArray[np.int64]) -> dict[int, NDArray[np.int64]]:
    """The values of each track; they stand by track."""
    ids, starts = np.unique(track, return_index=True)
    parts = np.split(values, starts[1:])
    return {int(one): part for one, part in zip(ids, parts, strict=False)}


def _renamed(tracks: NDArray[np.int32], after: dict[int, int]) -> NDArray[np.int32]:
    """Ids (n,) of a run as they are after the edits; those that `after` lacks become -1."""
    known, inverse = np.unique(tracks, return_inverse=True)
    ids = np.array([after.get(track, -1) for track in known.tolist()], np.int32)
    return np.asarray(ids[inverse], np.int32) if len(ids) else tracks


def rows_of_frame(columns: Columns, frame: int) -> Columns:
    """The rows of one frame; they stand by frame."""
    inside = between(columns["frame"], frame, frame + 1)
    return {name: column[inside] for name, column in columns.items()}
