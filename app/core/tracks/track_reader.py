"""The tracks that are shown: those of a session, or those a tracker is just making."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from tracking.tracks import TRACK_COLUMNS, Columns, empty

Spans = NDArray[np.int64]
"""(k, 3) rows of first frame, end frame (half-open), `SpanKind`."""


class TrackReader(Protocol):
    """What the views ask of tracks, wherever they come from."""

    @property
    def frames(self) -> tuple[int, int]:
        """The half-open range of frames that a tracker went through."""

    @property
    def ids(self) -> Sequence[int]:
        """All tracks."""

    def of_frame(self, frame: int) -> Columns:
        """`TRACK_COLUMNS` of a frame, sorted by track."""

    def recent(self, frame: int, back: int) -> Columns:
        """`TRACK_COLUMNS` of the frame's people in it and `back` frames before.

        The rows of one track stand by frame.
        """

    def of_track(self, track: int) -> Columns:
        """`TRACK_COLUMNS` of a track, sorted by frame."""

    def detections(self, frame: int) -> Columns:
        """`DETECTION_COLUMNS` of a frame."""

    def particles(self, frame: int) -> Columns:
        """`PARTICLE_COLUMNS` of a frame, grouped by track."""

    def parts(self, frame: int) -> Columns:
        """`PART_COLUMNS` of a frame; none from trackers that follow people whole."""

    def part_particles(self, frame: int) -> Columns:
        """`PART_PARTICLE_COLUMNS` of a frame."""

    def tracklets(self, frame: int) -> Columns:
        """`TRACKLET_COLUMNS` of a frame; none from trackers that follow no points."""

    def network_boxes(self, frame: int) -> Columns:
        """`NETWORK_BOX_COLUMNS` of a frame; none of runs without a network."""

    def signals(self, frame: int) -> Columns:
        """`SIGNAL_COLUMNS` of a frame's people; none from trackers that notice nothing."""

    def parts_of_track(self, track: int) -> Columns:
        """`PART_COLUMNS` of a track, sorted by frame."""

    def spans(self, tracks: Iterable[int] | None = None) -> dict[int, Spans]:
        """For each track, or each of some, the stretches in which its rows are of one kind."""

    def keyframes(self, tracks: Iterable[int] | None = None) -> dict[int, NDArray[np.int64]]:
        """The frames whose row a person made, of the tracks that have any."""

    def activity(self, frame_count: int) -> NDArray[np.uint16]:
        """(frame_count,) people per frame."""


class WholeTracks(TrackReader, Protocol):
    """Tracks all rows of which can be read at once, off the GUI thread too."""

    def capture(self, names: Sequence[str]) -> Callable[[], Columns]:
        """Takes hold of all rows as they are now, quickly; gives what reads them on any thread.

        Only the named columns are read, "frame" among them; the rows stand in no certain order.
        """


def concatenate(parts: Sequence[Columns], names: Iterable[str] = TRACK_COLUMNS) -> Columns:
    """`TRACK_COLUMNS`, or some of them, of several tables one behind the other."""
    none = empty(TRACK_COLUMNS)
    return {name: np.concatenate([none[name], *(part[name] for part in parts)]) for name in names}
